#!/usr/bin/env bash
# Installs the Debian packages that Overbend needs; nothing is touched when all are there.
#
#   scripts/install.sh build   what it takes to build and run the program
#   scripts/install.sh test    the same, and what the tests, linters and the documentation use
#   scripts/install.sh docs    what scripts/docs.sh takes to build the documentation site
#   scripts/install.sh arm     what tools/arm_check.sh takes: a compiler for 64-bit ARM and a machine to run what it makes
#   scripts/install.sh portable-TARGET   what scripts/portable.sh TARGET takes besides `build`
set -euo pipefail

build_packages=(
  ca-certificates g++ cmake ninja-build
  libeigen3-dev libyaml-cpp-dev nlohmann-json3-dev libcli11-dev libfmt-dev libhdf5-dev libudunits2-data
  libcpp-httplib-dev libxlsxwriter-dev pkgconf
  pybind11-dev python3-dev python3-numpy
)
docs_packages=(python3-sphinx python3-myst-parser furo libjs-mathjax)
test_packages=(
  libgtest-dev libbenchmark-dev libudunits2-dev
  python3 python3-h5py python3-jsonschema python3-yaml
  python3-xarray python3-matplotlib python3-nbclient python3-nbformat python3-ipykernel mypy
  python3-pip python3-setuptools python3-venv dpkg-dev file
  chromium fontconfig fonts-dejavu-core fonts-liberation2
  clang-format clang-tidy
  g++-mingw-w64-x86-64-posix
  "${docs_packages[@]}"
)
arm_packages=(g++-aarch64-linux-gnu qemu-user libeigen3-dev)
# Libraries of portable builds are compiled from Debian's sources (tools/portable/sources.txt).
portable_packages=(dpkg-dev python3 file libudunits2-data)

# The packages of page and report come from npm. An npm that is already there, from wherever, is good enough; asking apt
# for another beside it may conflict.
if ! command -v npm >/dev/null; then
  build_packages+=(nodejs npm)
fi

case "${1:-build}" in
  build) wanted=("${build_packages[@]}") ;;
  test) wanted=("${build_packages[@]}" "${test_packages[@]}") ;;
  arm) wanted=("${arm_packages[@]}") ;;
  docs) wanted=("${docs_packages[@]}") ;;
  portable-linux) wanted=("${portable_packages[@]}") ;;
  portable-wheel) wanted=("${portable_packages[@]}" python3-pip python3-venv) ;;
  portable-aarch64) wanted=("${portable_packages[@]}" g++-aarch64-linux-gnu qemu-user) ;;
  portable-windows) wanted=("${portable_packages[@]}" g++-mingw-w64-x86-64-posix wine64) ;;
  portable-wasm) wanted=("${portable_packages[@]}" emscripten chromium fonts-dejavu-core fontconfig) ;;
  *) echo "usage: scripts/install.sh [build|test|arm|docs|portable-TARGET]" >&2; exit 2 ;;
esac

installed() {
  [[ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]
}

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "scripts/install.sh: this is not a Debian system; install these packages (or equivalents) yourself: ${wanted[*]}" >&2
  exit 1
fi

missing=()
for package in "${wanted[@]}"; do
  installed "$package" || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  exit 0
fi

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "scripts/install.sh: missing packages, and neither root nor sudo to install them: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -y -q \
    -o Acquire::Retries=3 -o DPkg::Lock::Timeout=120 "$@" </dev/null
}

install_missing() {
  apt install --no-install-recommends "${missing[@]}"
}

echo "== Installing ${missing[*]}"
# The first try fails on a machine whose package lists are absent or old.
if ! install_missing; then
  # A third-party source that does not answer must not stop us: the second try decides.
  apt update || true
  install_missing
fi
