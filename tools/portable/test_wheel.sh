#!/usr/bin/env bash
# Tests the wheels with numpy alone: that of 3.11 in an environment of this machine, that of 3.13 in a root of Debian 13:
#
#   test_wheel.sh OUTPUT
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
root="$(cd "$here/../.." && pwd)"
work="$(realpath "$1")"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT

# Symbols of the C library no newer than 2.31, and no other library but libm, libpthread, libdl and libgcc_s.
for wheel in "$work"/wheels/*.whl; do
  rm -rf "$folder/wheel"
  /usr/bin/python3 -m zipfile -e "$wheel" "$folder/wheel"
  module="$(ls "$folder"/wheel/overbend/_core*.so)"
  newest="$(objdump -T "$module" | grep -o 'GLIBC_[0-9.]*' | sort --version-sort --unique | tail -n 1)"
  [[ "$(printf '%s\n' GLIBC_2.31 "$newest" | sort --version-sort | tail -n 1)" == GLIBC_2.31 ]] || {
    echo "$wheel: needs $newest" >&2; exit 1; }
  others="$(objdump -p "$module" | awk '/NEEDED/ {print $2}' | grep -v -E '^(libc|libm|libpthread|libdl|librt|libgcc_s|ld-linux.*)\.so' || true)"
  [[ -z "$others" ]] || { echo "$wheel: needs $others" >&2; exit 1; }
  echo "$(basename "$wheel"): $newest"
done

/usr/bin/python3 -m venv "$folder/3.11"
"$folder/3.11/bin/pip" install --quiet --no-index --no-deps "$work"/wheels/*-cp311-*.whl
ln -s /usr/lib/python3/dist-packages/numpy "$folder/3.11/lib/python3.11/site-packages/"
"$folder/3.11/bin/python" "$here/wheel_test.py" "$root/examples"

target="$work/python3.13"
enter=(chroot)
((EUID == 0)) || enter=(unshare --map-root-user chroot)
rm -rf "$target/wheel"
mkdir -p "$target/wheel" "$target/tmp"
/usr/bin/python3 -m zipfile -e "$work"/wheels/*-cp313-*.whl "$target/wheel"
cp -r "$root/examples" "$root/data" "$here/wheel_test.py" "$target/wheel/"
# What the scripts of its packages, which did not run, would have set up.
for name in lib lib64; do ln -sfn "usr/$name" "$target/$name"; done
libraries=/usr/lib/x86_64-linux-gnu
LD_LIBRARY_PATH="$libraries/blas:$libraries/lapack" PYTHONPATH=/wheel "${enter[@]}" "$target" /usr/bin/python3.13 /wheel/wheel_test.py /wheel/examples
