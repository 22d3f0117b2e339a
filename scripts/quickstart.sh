#!/usr/bin/env bash
# From a fresh clone to a first result: installs what is missing, builds the program and the Python package, solves the
# BGL-1 example and runs two minutes in the waves.
set -euo pipefail
cd "$(dirname "$0")/.."

results=results/bgl1

bash scripts/install.sh build

echo "== Building the program and the Python package"
cmake --preset release -DOVERBEND_TESTS=OFF -DOVERBEND_BENCH=OFF -DOVERBEND_UNITS=ON
cmake --build --preset release --target overbend_installed --parallel "$(nproc)"

echo "== Solving the statics of examples/bgl1.yaml"
build/release/overbend static examples/bgl1.yaml -o "$results"

echo "== Dynamic analysis: two minutes of the same lay in a workable sea"
build/release/overbend dynamic examples/bgl1-workable-sea.yaml --duration '120 s' -o "$results-waves"

echo
echo "Done. Open the reports in a browser:"
echo "  $PWD/$results/report.html          statics"
echo "  $PWD/$results-waves/report.html    static and dynamic analysis"
echo "The same folders contain summary.json, pipe.csv, supports.csv and results.h5."
echo "From Python: PYTHONPATH=$PWD/build/release/python /usr/bin/python3 -c 'import overbend'"
