#!/usr/bin/env bash
# Packs page and WebAssembly module into overbend.html:  pack_wasm.sh BUILD OUTPUT
set -euo pipefail
root="$(cd "$(dirname "$0")/../.." && pwd)"
# The sources of the page with their packages, as the program's own build has them.
node "$root/tools/portable/single_file.mjs" "$1/program/web/site" "$1/program" "$2/overbend.html"
