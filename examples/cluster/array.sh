#!/bin/sh
# Slurm: sbatch array.sh SCENES — 16 shards of a folder on a shared file system. Requeued tasks go on where they were.
# Of other numbers: SHARDS=32 sbatch --array=1-32 array.sh SCENES. Some tasks again:
# sbatch --array=3,7 array.sh SCENES, with the same SHARDS: the number of shards is not that of the tasks.
# Every bay of each scene: TASK="--task audit --vehicle sedan,van" sbatch array.sh SCENES.
# Where the package is installed, by npm install --global ./parkade-0.1.0.tgz say:
# PARKADE=parkade sbatch array.sh SCENES.
#SBATCH --job-name=parkade
#SBATCH --array=1-16
#SBATCH --cpus-per-task=4
#SBATCH --mem=2G
#SBATCH --requeue
set -eu
parkade=${PARKADE:-npx --yes parkade@0.1.0}
# A package that npx does not find ends with 1 as well: it is asked for first.
$parkade version
$parkade batch "${1:-scenes}" ${TASK:---planner "${PLANNER:-hybrid}"} --jobs "${SLURM_CPUS_PER_TASK:-1}" \
  --shard "$SLURM_ARRAY_TASK_ID/${SHARDS:-16}" --out "results-$SLURM_ARRAY_TASK_ID.jsonl" --quiet || [ $? -eq 1 ]
# 1: some scenes were refused, which their results say.
