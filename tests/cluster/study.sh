#!/usr/bin/env bash
# A study on a real Slurm on this machine: submitted, a task killed, submitted again, gathered, and compared with the
# same study run here. By hand, as root; needs the Debian packages slurm-wlm and munge. See docs/guide/cluster.md.
#
#   tests/cluster/study.sh [OVERBEND] [FOLDER]
set -euo pipefail
here=$(dirname "$(realpath "$0")")
overbend=$(realpath "${1:-$here/../../build/release/overbend}")
folder=$(realpath -m "${2:-$(mktemp -d)}")
mkdir -p "$folder"
say() { printf '\n== %s\n' "$*"; }

eval "$("$here/slurm-up.sh" "$folder/slurm-state")"
trap '"$here/slurm-down.sh" "$folder/slurm-state"' EXIT
sinfo

cat >"$folder/study.yaml" <<STUDY
overbend_study: 1
base: $here/../../examples/bgl1.yaml
analysis: static
axes:
  - {key: tensioner.tension, from: 220 kN, to: 320 kN, steps: 21}
  - {key: environment.water_depth, from: 80 m, to: 96 m, steps: 5}
gather: [static.bottom_tension, static.sagbend.max_bending_moment]
STUDY

say "submitting"
"$overbend" study "$folder/study.yaml" -o "$folder/cluster" --on slurm --cases-per-task 15
job=$(sed -n 's/.*"id": "\([0-9]*\)".*/\1/p' "$folder/cluster/slurm/jobs.json" | tail -1)

say "killing a task at work"
for _ in $(seq 100); do
  running=$(squeue -h --array -j "$job" -t RUNNING -o %K | head -1)
  [ -n "$running" ] && break
  sleep 0.1
done
sleep 0.5
scancel --signal=KILL --full "${job}_$running"
echo "killed task $running of job $job"

say "watching"
"$overbend" study "$folder/study.yaml" -o "$folder/cluster" --watch

say "submitting again"
"$overbend" study "$folder/study.yaml" -o "$folder/cluster" --resubmit
"$overbend" study "$folder/study.yaml" -o "$folder/cluster" --watch

say "gathering"
"$overbend" study "$folder/study.yaml" -o "$folder/cluster" --gather | tail -5

say "the same study here"
"$overbend" study "$folder/study.yaml" -o "$folder/local" | tail -5

say "comparing"
# All but the last column, the time that a case took.
columns() { sed 's/,[^,]*$//' "$1"; }
if diff <(columns "$folder/cluster/study.csv") <(columns "$folder/local/study.csv"); then
  echo "the tables of $(($(wc -l <"$folder/local/study.csv") - 1)) cases agree to the last digit"
else
  echo "the tables differ" >&2
  exit 1
fi
echo "files: $(find "$folder/cluster/cases" -type f | wc -l), bytes: $(du -sb "$folder/cluster/cases" | cut -f1)"
