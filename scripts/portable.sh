#!/usr/bin/env bash
# Builds the program for other systems from Debian 12, and tests what it has built:
#
#   scripts/portable.sh linux     build/portable/overbend-linux.tar.gz: one static executable for any x86-64 Linux
#   scripts/portable.sh aarch64   build/portable/overbend-linux-aarch64.tar.gz: the same for 64-bit ARM
#   scripts/portable.sh windows   build/portable/overbend-windows.zip: overbend.exe
#   scripts/portable.sh wasm      build/portable/overbend.html: the program in a browser tab, as one file
#   scripts/portable.sh wheel     build/portable/wheels: Python packages with their libraries inside
set -euo pipefail
cd "$(dirname "$0")/.."

target="${1:-}"
case "$target" in
  linux | aarch64 | windows | wasm | wheel) ;;
  *) sed -n '2,8s/^# \?//p' "$0" >&2; exit 2 ;;
esac
work="$PWD/build/portable"
[[ "$target" == wasm ]] && export NODE_PATH=/usr/share/nodejs  # packages of emscripten
step() { echo; echo "== $* [$((SECONDS / 60)) min $((SECONDS % 60)) s]"; }

step "Packages"
bash scripts/install.sh build
bash scripts/install.sh "portable-$target"

step "Libraries"
system="$target"
[[ "$target" == wheel ]] && system=linux
prefix="$work/$system/prefix"
tools/portable/libraries.sh "$system" "$prefix"

step "Program"
options=(-DCMAKE_BUILD_TYPE=Release "-DOVERBEND_LIBRARIES=$prefix" -DOVERBEND_UNITS=ON -DOVERBEND_TESTS=OFF
         -DOVERBEND_BENCH=OFF -DOVERBEND_PYTHON_MODULE=OFF)
[[ "$system" == linux ]] || options+=(--toolchain "$PWD/cmake/toolchains/$system.cmake")
if [[ "$target" != wheel ]]; then
  cmake -S . -B "$work/$system/program" -G Ninja "${options[@]}"
  cmake --build "$work/$system/program" --target overbend
fi

step "Archive"
bash "tools/portable/pack_$target.sh" "$work/$system" "$work"

step "Tests"
bash "tools/portable/test_$target.sh" "$work"
