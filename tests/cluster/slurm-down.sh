#!/usr/bin/env bash
# Stops what slurm-up.sh started in DIR, by its files of process numbers, and waits until each has ended.
dir=$(realpath -m "${1:?the folder of the state of Slurm}")
alive() { [ -d "/proc/$1" ] && ! grep -q '^State:.*[ZX]' "/proc/$1/status" 2>/dev/null; }
for file in slurmd.pid slurmctld.pid munge/pid; do
  [ -s "$dir/$file" ] || continue
  process=$(cat "$dir/$file")
  kill "$process" 2>/dev/null
  for _ in $(seq 100); do
    alive "$process" || break
    sleep 0.1
  done
  alive "$process" && kill -9 "$process" 2>/dev/null
  rm -f "$dir/$file"
done
exit 0
