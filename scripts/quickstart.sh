#!/usr/bin/env bash
# From a fresh clone to a first result: installs what is missing, builds the program and solves the BGL-1 example.
set -euo pipefail
cd "$(dirname "$0")/.."

results=results/bgl1

bash scripts/install.sh build

echo "== Building the program"
cmake --preset release -DOVERBEND_TESTS=OFF -DOVERBEND_BENCH=OFF
cmake --build --preset release --target overbend --parallel "$(nproc)"

echo "== Solving the statics of examples/bgl1.yaml"
build/release/overbend static examples/bgl1.yaml -o "$results"

echo
echo "Done. Open the report in a browser:"
echo "  $PWD/$results/report.html"
echo "Beside it lie summary.json, pipe.csv, supports.csv and results.h5."
