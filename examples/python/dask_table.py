"""Plans a table of tasks with Dask: python dask_table.py OUT [--count 1000] [--planner eight]"""

import argparse
import pathlib

import dask
import pyarrow as pa
from parkade import batch


@dask.delayed
def planned(rows, file):
    batch.write(batch.plan_table(rows), file)
    return file


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--planner", default="eight", help="one or more, with commas")
    parser.add_argument("--rows", type=int, default=500, help="rows per part")
    given = parser.parse_args()
    scenes = [{"family": "random", "size": 15, "seed": seed} for seed in range(given.count)]
    tasks = batch.manifest(scenes, given.planner.split(","))
    given.out.mkdir(parents=True, exist_ok=True)
    done = sorted(given.out.glob("*.parquet"))
    if done:
        tasks = batch.remaining(tasks, batch.read(*done))
    parts = [pa.Table.from_batches([rows]) for rows in tasks.to_batches(max_chunksize=given.rows)]
    files = [given.out / f"{batch.hash_of(''.join(part['key'].to_pylist()))}.parquet" for part in parts]
    dask.compute(*(planned(part, file) for part, file in zip(parts, files, strict=True)), scheduler="processes")
    results = batch.read(*sorted(given.out.glob("*.parquet")))
    print(f"{tasks.num_rows} planned; {results.num_rows} results, digest {batch.digest(results)}")


if __name__ == "__main__":
    main()
