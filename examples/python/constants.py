"""What a batch costs: python constants.py [--count 1000]

Prints, for planners on generated scenes and on a built-in one, the processor time of a task and of its row, and the
bytes of a row of results and of the manifest as Parquet.
"""

import argparse
import io
import time

import parkade
import pyarrow.parquet as pq
from parkade import batch

TASKS = [("eight", 40), ("jump-point", 40), ("risk-field", 40), ("hybrid", None), ("hybrid-classic", None)]


def size_of(table):
    file = io.BytesIO()
    pq.write_table(table, file, compression="snappy")
    return file.tell() / table.num_rows


def moved(scene, seed):
    """The built-in scene with another start: a hair further for each seed."""
    start = {**scene["start"], "x": scene["start"]["x"] + seed * 1e-4}
    return {**scene, "start": start}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=1000)
    given = parser.parse_args()
    print("| planner | scenes | a task, ms | the manifest's row, ms | results, bytes a row | manifest, bytes a row |")
    print("| --- | --- | --- | --- | --- | --- |")
    for planner, size in TASKS:
        seeds = range(given.count)
        scene = parkade.scenario("perpendicular")
        scenes = (
            {f"perpendicular {seed}": moved(scene, seed) for seed in seeds}
            if size is None
            else [{"family": "random", "size": size, "seed": seed} for seed in seeds]
        )
        started = time.process_time()
        tasks = batch.manifest(scenes, [planner])
        listed = time.process_time()
        results = batch.plan_table(tasks)
        planned = time.process_time()
        milliseconds = [1000 * seconds / given.count for seconds in (planned - listed, listed - started)]
        name = "perpendicular" if size is None else f"random, {size} × {size}"
        cells = [planner, name, *(f"{one:.2f}" for one in milliseconds)]
        cells += [f"{size_of(results):.0f}", f"{size_of(tasks):.0f}"]
        print(f"| {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
