#!/usr/bin/env python3
"""How far the results of one storm depend on chance: runs a model with tolerances that differ by a hundredth each.

    bench/chance.py examples/bgl1.yaml [--runs 8] [--duration "600 s"] [--build-up "60 s"]
                    [--program build/release/overbend]

All runs see the same waves and are as accurate as one another. A single run does not
show their differences. Prints every value's smallest and largest, and their distance over the mean.
"""

import argparse
import json
import os
import pathlib
import re
import subprocess
import tempfile

VALUES = {
    "impacts": lambda d: d["impact_count"],
    "largest impact [kN]": lambda d: 1e-3 * max(roller["largest_impact_force"] for roller in d["impacts"]),
    "tension, mean [kN]": lambda d: 1e-3 * d["top_tension"]["mean"],
    "tension, standard deviation [kN]": lambda d: 1e-3 * d["top_tension"]["std"],
    "tension, largest [kN]": lambda d: 1e-3 * d["top_tension"]["max"],
    "max. overbend von Mises [MPa]": lambda d: 1e-6 * d["overbend"]["max_von_mises"]["max"],
    "max. sagbend von Mises [MPa]": lambda d: 1e-6 * d["sagbend"]["max_von_mises"]["max"],
    "travel of the tensioner, std [m]": lambda d: d["tensioner"]["travel_std"],
    "surge, std [m]": lambda d: d["vessel"]["surge"]["std"],
    "sway, std [m]": lambda d: d["vessel"]["sway"]["std"],
}


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("model", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=8)
    parser.add_argument("--duration", default="600 s")
    parser.add_argument("--build-up", default="60 s")
    parser.add_argument("--program", type=pathlib.Path, default=pathlib.Path("build/release/overbend"))
    return parser.parse_args()


def run(options, tolerance, directory):
    """The dynamic part of the summary of one run."""
    text = options.model.read_text()
    settings = f"dynamic: {{duration: {options.duration}, build_up: {options.build_up}, tolerance: {tolerance:.3e}}}"
    text, count = re.subn(r"dynamic: \{.*\}", settings, text)
    if count != 1:
        raise SystemExit(f"{options.model}: 'dynamic: {{...}}' expected in one line")
    model = options.model.parent / f".chance-{os.getpid()}-{tolerance:.3e}.yaml"  # next to its RAO file
    model.write_text(text)
    try:
        subprocess.run([options.program, "dynamic", model, "-o", directory], check=True, capture_output=True)
    finally:
        model.unlink()
    return json.loads((pathlib.Path(directory) / "summary.json").read_text())["dynamic"]


def main():
    options = parse_arguments()
    results = []
    for i in range(options.runs):
        with tempfile.TemporaryDirectory() as directory:
            results.append(run(options, 1e-6 * (1.0 + 0.01 * i), directory))
    print(f"{'':36}{'smallest':>12}{'largest':>12}{'spread':>9}")
    for name, value in VALUES.items():
        try:
            values = [value(result) for result in results]
        except KeyError:
            continue  # of moored vessels, of tensioners that pay out
        mean = sum(values) / len(values)
        spread = 100 * (max(values) - min(values)) / mean if mean else 0.0
        print(f"{name:36}{min(values):12.3f}{max(values):12.3f}{spread:8.1f} %")


main()
