#!/usr/bin/env bash
# Builds the libraries of a portable build from Debian's sources, as static archives:
#
#   tools/portable/libraries.sh TARGET PREFIX     TARGET: linux, aarch64, windows or wasm
#
# Sources are downloaded once into build/portable/sources and checked against sources.txt. A source that cannot be had
# stops the script by name.
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
root="$(cd "$here/../.." && pwd)"
target="$1"
prefix="$(realpath -m "$2")"
work="$root/build/portable"
sources="$work/sources"
mkdir -p "$sources"

. "$here/debian_packages.sh"

fetch() {  # PACKAGE VERSION SHA256
  local folder="$sources/$1" dsc="$work/downloads/$1_${2#*:}.dsc"  # without the epoch
  [[ -f "$folder/.sum" && "$(cat "$folder/.sum")" == "$3" ]] && return
  if ! echo "$3  $dsc" | sha256sum --check --status 2>/dev/null; then
    use_release bookworm deb-src
    mkdir -p "$work/downloads"
    (cd "$work/downloads" && "${apt[@]}" source --download-only "$1=$2" >"$work/log" 2>&1) || {
      echo "tools/portable/libraries.sh: the source of $1 $2 cannot be downloaded:" >&2
      tail -n 3 "$work/log" >&2
      exit 1
    }
    echo "$3  $dsc" | sha256sum --check --status || {
      echo "tools/portable/libraries.sh: $dsc is not the file of sources.txt: $(sha256sum <"$dsc")" >&2
      exit 1
    }
  fi
  rm -rf "$folder"
  dpkg-source -q -x "$dsc" "$folder" >"$work/log" 2>&1  # gpgv knows no keys; the sums are checked
  rm -f "$sources"/*.orig.tar.*
  echo "$3" >"$folder/.sum"
}

while read -r package version sum; do
  [[ "$package" == \#* || -z "$package" ]] || fetch "$package" "$version" "$sum"
done <"$here/sources.txt"

toolchain=()
[[ "$target" == wasm ]] && export NODE_PATH=/usr/share/nodejs  # packages of emscripten
[[ "$target" == linux ]] || toolchain=(--toolchain "$root/cmake/toolchains/$target.cmake")
[[ -n "${ONLY_SOURCES:-}" ]] && exit
cmake -S "$here/libraries" -B "$work/$target/libraries" -G Ninja -DCMAKE_BUILD_TYPE=Release "-DSOURCES=$sources" \
  "${toolchain[@]}" --install-prefix "$prefix" >"$work/$target-libraries.log" 2>&1 || { cat "$work/$target-libraries.log" >&2; exit 1; }
ninja -C "$work/$target/libraries" install >"$work/$target-libraries.log" 2>&1 || { grep -A 5 FAILED "$work/$target-libraries.log" | cut -c 1-300 >&2; exit 1; }
echo "Libraries for $target: $prefix"
