#!/usr/bin/env bash
# Runs clang-tidy over src/ as .clang-tidy says, in parallel; any finding fails.
#
#   tools/tidy.sh                      every source
#   tools/tidy.sh seafiles/.*_reader   only sources whose path matches one of the expressions
set -euo pipefail
cd "$(dirname "$0")/.."

# A tree of its own, never built: one that compiles sources in units has no commands for the sources.
cmake --preset release -B build/lint -DOVERBEND_UNITS=OFF -DOVERBEND_TESTS=OFF -DOVERBEND_BENCH=OFF >/dev/null
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
cp .clang-tidy "$work"  # the linter looks for it above the unit
# Called through Debian's own Python: the one first on the PATH may be another.
/usr/bin/python3 tools/tidy_units.py build/lint/compile_commands.json "$work" "$@"
# The compile commands are g++'s, whose warning options clang need not know.
if ! /usr/bin/python3 "$(command -v run-clang-tidy)" -quiet -p "$work" -j "$(nproc)" \
    -extra-arg=-Wno-unknown-warning-option >"$work/log" 2>&1; then
  grep -E -A 4 '(warning|error):' "$work/log" || tail -n 40 "$work/log"
  exit 1
fi
echo "clang-tidy: no findings"
