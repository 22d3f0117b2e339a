#!/usr/bin/env bash
# Packs the Python package for CPython 3.11 and 3.13, with its libraries inside:  pack_wheel.sh BUILD OUTPUT
#
# The module is linked against the glibc of Debian 11 (2.31). Headers of Python 3.13 and of a pybind11 that knows it come
# from Debian 13; Debian has no 3.12.
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
root="$(cd "$here/../.." && pwd)"
work="$(realpath "$2")"
. "$here/debian_packages.sh"
unpack_packages bullseye "$work/glibc" libc6-dev
unpack_packages trixie "$work/python3.13" python3.13-minimal libpython3.13-dev python3-numpy pybind11-dev

# Of the headers of Debian 13 only these, not those of its C library.
included="$work/python3.13/usr/include"
headers="$work/python3.13/headers"
mkdir -p "$headers/x86_64-linux-gnu"
ln -sfn "$included/pybind11" "$headers/pybind11"
ln -sfn "$included/x86_64-linux-gnu/python3.13" "$headers/x86_64-linux-gnu/python3.13"

rm -rf "$work/wheels"
mkdir "$work/wheels"
for version in 3.11 3.13; do
  number="${version/./}"
  [[ "$version" == 3.11 ]] && python=/usr/include/python3.11 || python="$included/python$version"
  cmake -S "$root" -B "$1/program" -G Ninja -DCMAKE_BUILD_TYPE=Release "-DOVERBEND_LIBRARIES=$1/prefix" -DOVERBEND_UNITS=ON \
    -DOVERBEND_TESTS=OFF -DOVERBEND_BENCH=OFF -DOVERBEND_PYTHON_MODULE=ON "-DOVERBEND_GLIBC=$work/glibc" \
    "-DOVERBEND_PYTHON_HEADERS=$headers;$python" "-DOVERBEND_PYTHON_SUFFIX=.cpython-$number-x86_64-linux-gnu.so"
  cmake --build "$1/program" --target overbend_python_installed overbend_installed
  /usr/bin/python3 "$root/packages/build_backend.py" "$1/program" "cp$number-cp$number-manylinux_2_31_x86_64" "$work/wheels"
done
ls -l "$work/wheels"
