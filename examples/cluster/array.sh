#!/bin/sh
# Slurm: sbatch array.sh SCENES — 16 shards of a folder on a shared file system. Requeued tasks go on where they were.
#SBATCH --job-name=parkade
#SBATCH --array=1-16
#SBATCH --cpus-per-task=4
#SBATCH --mem=2G
#SBATCH --requeue
set -eu
exec npx parkade batch "${1:-scenes}" --planner "${PLANNER:-hybrid}" --jobs "${SLURM_CPUS_PER_TASK:-1}" \
  --shard "$SLURM_ARRAY_TASK_ID/${SLURM_ARRAY_TASK_COUNT:-16}" --out "results-$SLURM_ARRAY_TASK_ID.jsonl" --quiet
