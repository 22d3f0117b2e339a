#!/usr/bin/env bash
# Formats all C++ files in place, or with --check only names those that differ (and fails).
set -euo pipefail
cd "$(dirname "$0")/.."

mapfile -d '' files < <(find src tests bench \( -name '*.cpp' -o -name '*.h' \) -print0 | sort -z)

if [[ "${1:-}" != --check ]]; then
  clang-format -i "${files[@]}"
  exit 0
fi

differ=0
for file in "${files[@]}"; do
  if ! clang-format "$file" | cmp -s - "$file"; then
    echo "$file: not formatted"
    differ=$((differ + 1))
  fi
done
echo "format: ${#files[@]} files, $differ to format (tools/format.sh does it)"
((differ == 0))
