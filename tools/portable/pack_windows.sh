#!/usr/bin/env bash
# Packs overbend.exe with examples, documents and licences:  pack_windows.sh BUILD OUTPUT
set -euo pipefail
root="$(cd "$(dirname "$0")/../.." && pwd)"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/overbend"
x86_64-w64-mingw32-strip -o "$folder/overbend/overbend.exe" "$1/program/overbend.exe"
bash "$root/tools/portable/add_documents.sh" "$folder/overbend"
(cd "$folder" && cmake -E tar cf archive.zip --format=zip overbend)
mv "$folder/archive.zip" "$2/overbend-windows.zip"
du -h "$2/overbend-windows.zip"
