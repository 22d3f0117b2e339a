#!/usr/bin/env bash
# Tests overbend.html: numbers of the module under node against the native program, and the page in Chromium from a file.
#
#   test_wasm.sh OUTPUT      OVERBEND_PROGRAM: the native program (default: build/release/overbend)
set -euo pipefail
root="$(cd "$(dirname "$0")/../.." && pwd)"
export OVERBEND_PROGRAM="${OVERBEND_PROGRAM:-$root/build/release/overbend}"
node --no-experimental-fetch "$root/tools/portable/test_module.mjs" "$1/wasm/program" "$root"
cd "$1/wasm/program/web/site"
OVERBEND_ROOT="$root" OVERBEND_SINGLE="$1/overbend.html" npx vitest run --dir single --config vitest.e2e.config.ts
# Tests of the page that need neither a folder of the disk nor the end of the program.
OVERBEND_ROOT="$root" OVERBEND_SINGLE="$1/overbend.html" npx vitest run --dir e2e --config vitest.e2e.config.ts grid laytable
