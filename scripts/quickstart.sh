#!/usr/bin/env bash
# From a fresh clone to a first result: installs what is missing, builds the program, solves the BGL-1 example and sets
# it in motion for two minutes.
set -euo pipefail
cd "$(dirname "$0")/.."

statics=results/bgl1
dynamics=results/bgl1-dynamic

bash scripts/install.sh build

echo "== Building the program"
cmake --preset release -DOVERBEND_TESTS=OFF -DOVERBEND_BENCH=OFF
cmake --build --preset release --target overbend --parallel "$(nproc)"

echo "== Solving the statics of examples/bgl1.yaml"
build/release/overbend static examples/bgl1.yaml -o "$statics"

echo "== Two minutes of its storm"
build/release/overbend dynamic examples/bgl1.yaml --duration '120 s' -o "$dynamics"

echo
echo "Done. Open the reports in a browser:"
echo "  $PWD/$statics/report.html    the static state"
echo "  $PWD/$dynamics/report.html    in motion"
echo "Beside each lie summary.json, pipe.csv, supports.csv and results.h5."
