#!/usr/bin/env bash
# Formats all C++ files in place, or with --check only names those that differ (and fails).
set -euo pipefail
cd "$(dirname "$0")/.."

mapfile -d '' files < <(find src tests bench validation \( -name '*.cpp' -o -name '*.h' \) -print0 | sort -z)

if [[ "${1:-}" != --check ]]; then
  clang-format -i "${files[@]}"
  exit 0
fi

# Many files to a process: it takes longer to start than to look at one. They are named one by one where some differ.
differ=0
if ! printf '%s\0' "${files[@]}" | xargs -0 -n 50 -P "$(nproc)" clang-format --dry-run --Werror 2>/dev/null; then
  for file in "${files[@]}"; do
    if ! clang-format "$file" | cmp -s - "$file"; then
      echo "$file: not formatted"
      differ=$((differ + 1))
    fi
  done
fi
echo "format: ${#files[@]} files, $differ to format (tools/format.sh does it)"
((differ == 0))
