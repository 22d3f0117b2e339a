#!/usr/bin/env bash
# Formats all C++ files in place, or with --check only names those that differ (and fails).
set -euo pipefail
cd "$(dirname "$0")/.."

mode=(-i)
if [[ "${1:-}" == --check ]]; then
  mode=(--dry-run --Werror)
fi
find src tests bench \( -name '*.cpp' -o -name '*.h' \) -not -path '*/build/*' -print0 |
  xargs -0 -r clang-format "${mode[@]}"
