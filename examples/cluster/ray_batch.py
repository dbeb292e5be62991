"""Plans a folder of scenes on a Ray cluster: python ray_batch.py SCENES --shards 8 [--planner hybrid]

Every bay of each scene: --task="--task audit --vehicle sedan,van".

Every shard is one task that runs the command `parkade batch`. All machines need Node, the npm package and the scenes'
folder at the same place, and OUT must be a folder that they share. Tasks that die are tried again
and go on in their own file.
"""

import argparse
import os
import pathlib
import shlex
import subprocess

import ray


@ray.remote(num_cpus=1, max_retries=3)
def shard(command, scenes, task, at, of, out):
    result = pathlib.Path(out) / f"results-{at}-of-{of}.jsonl"
    arguments = ["batch", scenes, *task, "--jobs", "1", "--shard", f"{at}/{of}", "--out", str(result), "--quiet"]
    subprocess.run([*command, "version"], capture_output=True, check=True)  # npx without the package ends with 1, too
    done = subprocess.run([*command, *arguments], capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):  # 1: some scenes were refused, which their results say
        raise RuntimeError(done.stderr.strip())
    return str(result), done.stdout.strip(), ray.get_runtime_context().get_node_id()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes")
    parser.add_argument("--shards", type=int, default=2)
    parser.add_argument("--planner", default="hybrid")
    parser.add_argument("--task", help="options of batch in the place of --planner")
    parser.add_argument("--out", default=".")
    parser.add_argument("--command", default="npx --no parkade", help="how the command is started")
    given = parser.parse_args()
    command = shlex.split(given.command)
    scenes, out = os.path.abspath(given.scenes), os.path.abspath(given.out)
    os.makedirs(out, exist_ok=True)
    ray.init(address=os.environ.get("RAY_ADDRESS"), log_to_driver=False)
    task = shlex.split(given.task) if given.task else ["--planner", given.planner]
    tasks = [shard.remote(command, scenes, task, at, given.shards, out) for at in range(1, given.shards + 1)]
    files = []
    for task in tasks:
        file, words, node = ray.get(task)
        files.append(file)
        print(f"{file} on {node[:8]}: {words}", flush=True)
    subprocess.run([*command, "digest", *files], check=True)


if __name__ == "__main__":
    main()
