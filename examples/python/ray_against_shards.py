"""Ray Data against plain processes: python ray_against_shards.py [--count 100000] [--planner eight] [--rounds 3]

Both plan the same table on as many processors, in turns; starting Ray and its workers is not counted. Prints, for each
round, both times by the clock, both processor times (of all processes, Ray's own too), and Ray's speed as a share of
the processes'. On a busy machine only the processor time tells something.
"""

import argparse
import multiprocessing
import os
import statistics
import time
from concurrent.futures import ProcessPoolExecutor

import psutil
import pyarrow as pa
import ray
from parkade import batch


def spent():
    """Processor time of this process and all that it started, seconds."""
    own = psutil.Process()
    total = 0.0
    for process in [own, *own.children(recursive=True)]:
        try:
            times = process.cpu_times()
        except psutil.NoSuchProcess:
            continue
        total += times.user + times.system
    return total


def outline(rows):
    return batch.plan_table(rows).select(["key", "hash", "error_message"])


def by_ray(tasks, rows):
    # The table is in the object store before the clock starts, as a cluster's files are.
    parts = ray.data.from_arrow([pa.Table.from_batches([part]) for part in tasks.to_batches(max_chunksize=rows)])
    parts = parts.materialize()
    started = time.perf_counter()
    blocks = parts.map_batches(outline, batch_format="pyarrow", batch_size=None).materialize()
    seconds = time.perf_counter() - started
    return seconds, pa.concat_tables(ray.get(blocks.to_arrow_refs()))


def by_shards(tasks, pool, count):
    length = -(-tasks.num_rows // count)
    started = time.perf_counter()
    results = list(pool.map(outline, [tasks.slice(at * length, length) for at in range(count)]))
    return time.perf_counter() - started, pa.concat_tables(results)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=100_000)
    parser.add_argument("--planner", default="eight")
    parser.add_argument("--size", type=int, default=40)
    parser.add_argument("--rows", type=int, default=5000, help="rows per part of Ray's")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--processes", type=int, default=2)
    given = parser.parse_args()
    scenes = [{"family": "random", "size": given.size, "seed": seed} for seed in range(given.count)]
    tasks = batch.manifest(scenes, [given.planner])
    ray.init(num_cpus=given.processes, log_to_driver=False, logging_level="error")
    ray.data.DataContext.get_current().enable_progress_bars = False
    # Ray and Arrow have threads by now, and what they hold would stay held in a fork.
    with ProcessPoolExecutor(given.processes, multiprocessing.get_context("spawn")) as pool:
        by_ray(tasks.slice(0, 100), 50)
        by_shards(tasks.slice(0, 100), pool, given.processes)
        shares = []
        for _ in range(given.rounds):
            load = os.getloadavg()[0]
            before = spent()
            shards, expected = by_shards(tasks, pool, given.processes)
            between = spent()
            seconds, found = by_ray(tasks, given.rows)
            processor = (between - before, spent() - between)
            assert batch.digest(found) == batch.digest(expected)
            shares.append((shards / seconds, processor[0] / processor[1]))
            clock = f"shards {shards:.1f} s, Ray {seconds:.1f} s ({shares[-1][0]:.0%})"
            print(
                f"clock: {clock}; processor: {processor[0]:.1f} s and {processor[1]:.1f} s ({shares[-1][1]:.0%})",
                end="; ",
            )
            print(f"load {load:.1f}", flush=True)
    medians = [statistics.median(share[kind] for share in shares) for kind in (0, 1)]
    print(f"medians: {medians[0]:.0%} by the clock, {medians[1]:.0%} in processor time; digest {batch.digest(found)}")


if __name__ == "__main__":
    main()
