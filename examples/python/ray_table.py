"""Plans a table of tasks with Ray Data: python ray_table.py OUT [--count 1000] [--planner eight]

The manifest's rows are divided among the cluster's processors; each part becomes a Parquet file in OUT, so that a part
that dies is planned again, and a second run plans only what is missing.
"""

import argparse
import pathlib
import time

import pyarrow as pa
import ray
from parkade import batch


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--family", default="random")
    parser.add_argument("--size", type=int, default=15)
    parser.add_argument("--planner", default="eight", help="one or more, with commas")
    parser.add_argument("--rows", type=int, default=5000, help="rows per part")
    given = parser.parse_args()
    scenes = [{"family": given.family, "size": given.size, "seed": seed} for seed in range(given.count)]
    tasks = batch.manifest(scenes, given.planner.split(","))
    given.out.mkdir(parents=True, exist_ok=True)
    done = sorted(given.out.glob("*.parquet"))
    if done:
        tasks = batch.remaining(tasks, batch.read(*done))
    ray.init(log_to_driver=False)
    started = time.perf_counter()
    if tasks.num_rows > 0:
        parts = ray.data.from_arrow(pa.Table.from_batches(tasks.to_batches(max_chunksize=given.rows)))
        parts = parts.repartition(target_num_rows_per_block=given.rows)
        # Each part is written by the worker that planned it, with the schema of results.
        parts.map_batches(Written(given.out).plan, batch_format="pyarrow", batch_size=given.rows).materialize()
    seconds = time.perf_counter() - started
    results = batch.read(*sorted(given.out.glob("*.parquet")))
    print(f"{tasks.num_rows} planned in {seconds:.1f} s; {results.num_rows} results, digest {batch.digest(results)}")


class Written:
    def __init__(self, folder):
        self.folder = folder

    def plan(self, rows):
        results = batch.plan_table(rows)
        name = batch.hash_of("".join(rows["key"].to_pylist()))
        part = self.folder / f"{name}.part"
        batch.write(results, part)
        part.rename(self.folder / f"{name}.parquet")
        return pa.table({"rows": [results.num_rows]})


if __name__ == "__main__":
    main()
