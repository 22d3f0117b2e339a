#!/usr/bin/env bash
# Tests the archive under wine:  test_windows.sh OUTPUT
set -euo pipefail
root="$(cd "$(dirname "$0")/../.." && pwd)"
if [[ -z "${OVERBEND_PROGRAM:-}" && -x "$root/build/release/overbend" ]]; then
  export OVERBEND_PROGRAM="$root/build/release/overbend"
fi
/usr/bin/python3 "$root/tools/portable/program_test.py" windows "$1/overbend-windows.zip"
