#!/usr/bin/env bash
# Copies examples, their data, documents and licences to a folder:  add_documents.sh FOLDER
set -euo pipefail
root="$(cd "$(dirname "$0")/../.." && pwd)"
cp -r "$root/examples" "$root/data" "$root/docs" "$root/README.md" "$root/CHANGELOG.md" "$root/LICENSE" "$1"
find "$1" -name __pycache__ -o -name .ipynb_checkpoints | xargs -r rm -rf
mkdir "$1/licences"
for package in cpp-httplib fmtlib hdf5 libxlsxwriter yaml-cpp zlib; do
  cp "$root/build/portable/sources/$package/debian/copyright" "$1/licences/$package.txt"
done
for package in libstdc++6:libstdc++ libc6:glibc libeigen3-dev:eigen nlohmann-json3-dev:nlohmann-json libcli11-dev:cli11 \
               libudunits2-data:udunits; do
  cp "/usr/share/doc/${package%%:*}/copyright" "$1/licences/${package#*:}.txt"
done
