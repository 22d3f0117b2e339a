#!/usr/bin/env bash
# Runs clang-tidy over src/ as .clang-tidy says, in parallel; any finding fails. Needs a configured release build.
#
#   tools/tidy.sh                  every source
#   tools/tidy.sh io/.*_reader     only sources whose path matches one of the expressions
set -euo pipefail
cd "$(dirname "$0")/.."

if [[ ! -f build/release/compile_commands.json ]]; then
  echo "tools/tidy.sh: no build/release; run 'cmake --preset release' first" >&2
  exit 2
fi
patterns=("$@")
if ((${#patterns[@]} == 0)); then
  patterns=('.*')
fi
log="$(mktemp)"
trap 'rm -f "$log"' EXIT
# Called through Debian's own Python: the one first on the PATH may be another. The compile commands are g++'s, whose
# warning options clang need not know.
if ! /usr/bin/python3 "$(command -v run-clang-tidy)" -quiet -p build/release -j "$(nproc)" \
    -extra-arg=-Wno-unknown-warning-option "${patterns[@]/#/^$PWD/src/.*}" >"$log" 2>&1; then
  grep -E -A 4 '(warning|error):' "$log" || tail -n 40 "$log"
  exit 1
fi
echo "clang-tidy: no findings"
