#!/usr/bin/env bash
# A study as a job array of Slurm, on machines that share a folder:
#
#   sbatch --array=0-15 cluster/slurm.sh STUDY.toml FOLDER
#
# runs it in 16 parts, each the shards k with k mod 16 = its number. A part that was ended goes on
# where it was when it is submitted again. When all parts are done,
#
#   slideline sweep STUDY.toml --out FOLDER --csv
#
# joins the rows. SLIDELINE names the program where it is not on the path.
#SBATCH --job-name=slideline
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --requeue
set -euo pipefail

if [ $# != 2 ] || [ -z "${SLURM_ARRAY_TASK_COUNT:-}" ]; then
  echo "usage: sbatch --array=0-15 slurm.sh STUDY.toml FOLDER" >&2
  exit 64
fi
part=$((SLURM_ARRAY_TASK_ID - ${SLURM_ARRAY_TASK_MIN:-0}))
if [ "$part" -ge "$SLURM_ARRAY_TASK_COUNT" ]; then
  echo "the array has gaps: its numbers follow one another, such as --array=0-15" >&2
  exit 64
fi
exec "${SLIDELINE:-slideline}" sweep "$1" --out "$2" --quiet \
  --threads "${SLURM_CPUS_PER_TASK:-1}" --shard "$part/$SLURM_ARRAY_TASK_COUNT"
