#!/usr/bin/env bash
# Packs the static program with examples, documents and licences:  pack_linux.sh BUILD OUTPUT [SUFFIX]
set -euo pipefail
root="$(cd "$(dirname "$0")/../.." && pwd)"
name="overbend-linux${3:-}"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/overbend"
"${STRIP:-strip}" -o "$folder/overbend/overbend" "$1/program/overbend"
bash "$root/tools/portable/add_documents.sh" "$folder/overbend"
tar --create --gzip --owner=0 --group=0 --sort=name --file "$2/$name.tar.gz.part" --directory "$folder" overbend
mv "$2/$name.tar.gz.part" "$2/$name.tar.gz"
du -h "$2/$name.tar.gz"
