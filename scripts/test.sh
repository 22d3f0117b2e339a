#!/usr/bin/env bash
# Everything a change has to pass: layers, format, release tests, linter, and the tests again with sanitizers.
set -euo pipefail
cd "$(dirname "$0")/.."

jobs="$(nproc)"
step() { echo; echo "== $* [$((SECONDS / 60)) min $((SECONDS % 60)) s]"; }

build_preset() {
  cmake --preset "$1" -DOVERBEND_TESTS=ON -DOVERBEND_UNITS=ON "${@:2}"
  cmake --build --preset "$1" --parallel "$jobs"
}

step "Packages"
bash scripts/install.sh test

step "Layers: who includes whom"
/usr/bin/python3 tools/check_layers.py

step "Words: the vocabulary of the field"
/usr/bin/python3 tools/check_words.py

step "Format"
bash tools/format.sh --check

step "Release build"
build_preset release -DOVERBEND_BENCH=ON

step "Release tests"
ctest --preset release --parallel "$jobs"

step "Linter"
bash tools/tidy.sh

step "Sanitizer build"
build_preset sanitize -DOVERBEND_TESTS_OF="$PWD/build/release"

step "Sanitizer tests"
ctest --preset sanitize --parallel "$jobs"
