#!/usr/bin/env bash
# From a fresh clone to a first result: installs what is missing, builds the program, solves the BGL-1 example and runs
# two minutes in the waves; then, the reports being there to be read, builds the Python package.
set -euo pipefail
cd "$(dirname "$0")/.."

results=results/bgl1
build() { cmake --build --preset release --target "$1" --parallel "$(nproc)"; }

bash scripts/install.sh build

echo "== Building the program"
cmake --preset release -DOVERBEND_TESTS=OFF -DOVERBEND_BENCH=OFF -DOVERBEND_UNITS=ON
build overbend

echo "== Solving the statics of examples/bgl1.yaml"
build/release/overbend static examples/bgl1.yaml -o "$results"

echo "== Dynamic analysis: two minutes of the same lay in a workable sea"
build/release/overbend dynamic examples/bgl1-workable-sea.yaml --duration '120 s' -o "$results-waves"

echo
echo "Open the reports in a browser:"
echo "  $PWD/$results/report.html          statics"
echo "  $PWD/$results-waves/report.html    static and dynamic analysis"
echo "The same folders contain summary.json, pipe.csv, supports.csv and results.h5."

echo
echo "== Building the Python package, manual page and completion"
build overbend_installed
echo
echo "Done. Reports: $PWD/$results/report.html and $PWD/$results-waves/report.html"
echo "From Python: PYTHONPATH=$PWD/build/release/python /usr/bin/python3 -c 'import overbend'"
