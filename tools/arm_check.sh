#!/usr/bin/env bash
# Compiles the kernels for 64-bit ARM, runs them on an emulated machine and holds what they give against what the same
# sources give here, compiled without vectors' fused operations. Also that the ARM code is vectors of two doubles.
# Packages: scripts/install.sh arm
set -euo pipefail
cd "$(dirname "$0")/.."

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
# The line kernel asks bed_shape.cpp for a bed that is not a plane; how one is set up is left out by --gc-sections.
sources=(src/overbend/*/*_kernel.cpp src/overbend/model/site/seabed_shape.cpp tests/arm/*.cpp)
options=(-std=c++20 -ffunction-sections -Wall -Wextra -Werror -Wno-psabi -fno-math-errno -fno-trapping-math -DEIGEN_MPL2_ONLY
         -Isrc/overbend -isystem /usr/include/eigen3
         -DOVERBEND_ISA_NAMESPACE=isa_baseline -DOVERBEND_ISA_WIDTH=2)

# compile COMPILER FOLDER OPTION...: every source to an object, two at a time, and the program
compile() {
  mkdir "$work/$2"
  printf '%s\n' "${sources[@]}" | xargs -P "$(nproc)" -I{} bash -c '
    source="$1"; shift; folder="$1"; shift; exec "$@" -c "$source" -o "$folder/$(basename "$source" .cpp).o"' \
    _ {} "$work/$2" "$1" "${options[@]}" "${@:3}"
  "$1" "$work/$2"/*.o -o "$work/$2/numbers" -Wl,--gc-sections "${@:3}"
}

# As a user's machine would run them, and here without fused multiply-adds, which round once where others round twice.
compile aarch64-linux-gnu-g++ arm -O3 -ffp-contract=fast -static
compile g++ here -O2 -ffp-contract=off

for object in "$work"/arm/*_kernel.o; do
  # To a file: grep that has seen enough would end the pipe.
  aarch64-linux-gnu-objdump -d "$object" >"$work/code"
  count="$(grep -cE '\sfml[as]\s+v[0-9]+\.2d' "$work/code" || true)"
  echo "$(basename "$object" .o): $count fused multiply-adds of two doubles"
  if ((count == 0)); then
    echo "tools/arm_check.sh: no vector instructions in $(basename "$object")" >&2
    exit 1
  fi
done

qemu-aarch64 "$work/arm/numbers" >"$work/arm.txt"
"$work/here/numbers" >"$work/here.txt"
/usr/bin/python3 tools/compare_numbers.py "$work/arm.txt" "$work/here.txt" 1e-11
