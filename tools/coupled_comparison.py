#!/usr/bin/env python3
"""Compares prescribed and coupled vessel motion: examples/bgl1.yaml, whose barge moves by RAOs, and examples/bgl1-moored.yaml,
whose barge floats on its moorings with pipe and rollers, in the same seas. Writes docs/coupled-comparison.md.

    tools/coupled_comparison.py [--duration SECONDS] [--program PROGRAM] [--keep FOLDER]

Both models have the same pipe, supports, tensioner, current and components of the sea: build-up, duration and seed are
the same. Existing runs in FOLDER are reused.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "coupled-comparison.md"
BUILD_UP = 300   # s
SEAS = [("Hs 1.5 m, Tp 8 s, 5 deg off the bow", "hs: 1.5 m, tp: 8 s, from: 85 deg"),
        ("Hs 4 m, Tp 12.9 s, on the beam", "hs: 4.0 m, tp: 12.9 s, from: 180 deg")]
MODELS = [("RAOs", "bgl1"), ("coupled", "bgl1-moored")]


def percent(change):
    whole = round(100 * change)
    return f"{whole:+d}" if whole else "0"


def changed(text, pattern, replacement):
    text, found = re.subn(pattern, replacement, text, flags=re.M)
    if found != 1:
        sys.exit(f"expected one place of {pattern!r}, found {found}")
    return text


def model(example, sea, duration, folder):
    """Writes the example with this sea and absolute paths of its data files."""
    text = (ROOT / "examples" / f"{example}.yaml").read_text(encoding="utf-8")
    text = changed(text, r"^(  waves: \{type: jonswap, )[^}]*\}", rf"\g<1>{sea}, seed: 1}}")
    text = changed(text, r"^(  dynamic: )\{[^}]*\}", rf"\g<1>{{duration: {duration:g} s, build_up: {BUILD_UP} s}}")
    text = re.sub(r"\.\./data/", f"{ROOT}/data/", text)
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "model.yaml"
    file.write_text(text, encoding="utf-8")
    return file


def summary(program, example, sea, duration, folder):
    out = folder / "results"
    if not (out / "summary.json").exists():
        file = model(example, sea, duration, folder)
        subprocess.run([program, "dynamic", str(file), "--restart", "-o", str(out)], check=True, stdout=subprocess.DEVNULL)
    return json.loads((out / "summary.json").read_text(encoding="utf-8"))


def span(spread, factor=1.0, digits=1):
    return f"{spread['min'] * factor:.{digits}f} to {spread['max'] * factor:.{digits}f}"


def left(dynamic):
    """First box left by the pipe, from the warning of the program."""
    said = next((w for w in dynamic["warnings"] if w.startswith("the pipe left '")), None)
    if not said:
        return "no"
    found = re.match(r"the pipe left '([^']*)'.* over (?:its|their) sides? (to \w+), (?:the first )?at t = (\S+) s", said)
    return f"{found[1]}, {found[2]}, at {found[3].rstrip(',')} s" if found else said


def rows(dynamic):
    tip = dynamic["stinger_tip_clearance"]
    stinger = [box for box in dynamic["supports"] if box["structure"] == "stinger"]
    return [
        ("tension at the tensioner, kN", span(dynamic["top_tension"], 1e-3)),
        ("its standard deviation, kN", f"{dynamic['top_tension']['std'] / 1e3:.2f}"),
        ("minimum effective tension of the line, kN", f"{dynamic['smallest_tension']['min'] / 1e3:.1f}"),
        ("overbend, maximum strain, %", f"{100 * dynamic['overbend']['max_strain']['max']:.3f}"),
        ("sagbend, maximum von Mises stress, MPa", f"{dynamic['sagbend']['max_von_mises']['max'] / 1e6:.1f}"),
        ("clearance at the stinger tip, m", span(tip, 1.0, 2)),
        ("stinger boxes in contact, on average", f"{sum(box['contact_share'] for box in stinger):.2f} of {len(stinger)}"),
        ("maximum reaction of a box, kN", f"{max(box['reaction']['max'] for box in dynamic['supports']) / 1e3:.1f}"),
        ("impacts", f"{dynamic['impact_count']}"),
        ("tensioner travel, m", f"{dynamic['tensioner']['travel_min']:.2f} to {dynamic['tensioner']['travel_max']:.2f}"),
        ("number of times at the travel limit", f"{dynamic['tensioner']['limit_count']}"),
        ("lay-back from the mean position of the stern shoe, m", span(dynamic["lay_back"])),
        ("its standard deviation, m", f"{dynamic['lay_back']['std']:.2f}"),
        ("first box left by the pipe", left(dynamic)),
    ]


def table(results):
    of = [rows(result["dynamic"]) for result in results]
    text = "| | " + " | ".join(name for name, _ in MODELS) + " |\n|---|" + "---|" * len(MODELS) + "\n"
    for k, (name, _) in enumerate(of[0]):
        text += f"| {name} | " + " | ".join(column[k][1] for column in of) + " |\n"
    return text


def moored_table(result):
    """Motion statistics of the coupled barge and the most loaded mooring line."""
    dynamic = result["dynamic"]
    vessel = dynamic.get("vessel")
    text = ""
    if vessel:
        text += "| coupled barge | min | max | mean | LF std | WF std |\n|---|---|---|---|---|---|\n"
        for name, unit, factor in (("surge", "m", 1), ("sway", "m", 1), ("yaw", "deg", 57.29578), ("roll", "deg", 57.29578)):
            v = vessel[name]
            text += (f"| {name}, {unit} | {v['min'] * factor:.2f} | {v['max'] * factor:.2f} | {v['mean'] * factor:.2f} | "
                     f"{v['slow']['std'] * factor:.2f} | {v['wave']['std'] * factor:.2f} |\n")
    lines = dynamic.get("moorings") or []
    if lines:
        worst = max(lines, key=lambda line: line["fairlead_tension"]["max"])
        text += (f"\nMost loaded line: {worst['name']}, {worst['fairlead_tension']['max'] / 1e3:.0f} kN maximum"
                 f" (static {next(l['fairlead_tension'] for l in result['static']['moorings'] if l['name'] == worst['name']) / 1e3:.0f} kN).\n")
    return text


def findings(results):
    """Sentences with the numbers of the tables."""
    rao, coupled = (result["dynamic"] for result in results)
    said = []
    def by(name, a, b, unit, digits=1):
        said.append(f"- {name}: {a:.{digits}f} {unit} with RAOs, {b:.{digits}f} {unit} coupled ({percent(b / a - 1)} %)." if a else
                    f"- {name}: {a:.{digits}f} {unit} with RAOs, {b:.{digits}f} {unit} coupled.")
    by("Standard deviation of the tension", rao["top_tension"]["std"] / 1e3, coupled["top_tension"]["std"] / 1e3, "kN", 2)
    by("Standard deviation of the lay-back", rao["lay_back"]["std"], coupled["lay_back"]["std"], "m", 2)
    by("Maximum strain in the overbend", 100 * rao["overbend"]["max_strain"]["max"], 100 * coupled["overbend"]["max_strain"]["max"], "%", 3)
    by("Maximum von Mises stress in the sagbend", rao["sagbend"]["max_von_mises"]["max"] / 1e6, coupled["sagbend"]["max_von_mises"]["max"] / 1e6, "MPa", 0)
    ways = [left(rao) != "no", left(coupled) != "no"]
    said.append("- " + ("The pipe leaves roller boxes in both runs." if all(ways) else
                        "The pipe leaves no roller box in either run." if not any(ways) else
                        f"The pipe leaves roller boxes only in the {'run with RAOs' if ways[0] else 'coupled run'}."))
    least = [d["smallest_tension"]["min"] for d in (rao, coupled)]
    if min(least) < 0:
        said.append(f"- The line is briefly in compression: {least[0] / 1e3:.0f} kN with RAOs, {least[1] / 1e3:.0f} kN coupled.")
    return "\n".join(said) + "\n"


HEAD = """# Coupled and prescribed motion compared

This page, written by `tools/coupled_comparison.py`, compares two models with the same pipe, supports, tensioner, current and waves
(seed 1):

- **RAOs**: [bgl1.yaml](../examples/bgl1.yaml). The barge moves by its RAOs about a fixed mean position; the pipe does not act
  back on it.
- **coupled**: [bgl1-moored.yaml](../examples/bgl1-moored.yaml). The barge floats on eight mooring lines under waves, slow drift,
  current and the forces of lines, rollers and tensioner; its motion is solved together with that of the pipe.

RAOs and coefficients come from the same computation of a box-shaped hull ([data/bgl1](../data/bgl1/README.md)). The
moorings of the coupled model are assumed. The tensioner is {tensioner} in both.

**Each run is {duration:.0f} s long after a build-up of {build_up} s, with one seed.** That is {cycles:.0f} periods of the slowest
motion (sway, 77 s): enough to show trends, not enough for extremes. Differences of a few per cent in maxima are within the scatter
between seeds.
"""


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--duration", type=float, default=600.0)
    arguments.add_argument("--program", default=str(ROOT / "build" / "release" / "overbend"))
    arguments.add_argument("--keep")
    options = arguments.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(options.keep or scratch)
        text, tensioner = "", ""
        for i, (label, sea) in enumerate(SEAS):
            results = [summary(options.program, example, sea, options.duration, folder / f"sea{i}-{name}")
                       for name, example in MODELS]
            tensioner = results[0]["dynamic"]["tensioner"]["mode"]
            text += f"\n## {label}\n\n{findings(results)}\n{table(results)}"
            more = moored_table(results[1])
            if more:
                text += "\n" + more
        PAGE.write_text(HEAD.format(duration=options.duration, build_up=BUILD_UP, cycles=options.duration / 77.0,
                                    tensioner=tensioner) + text, encoding="utf-8")
    print(f"Wrote {PAGE}")


if __name__ == "__main__":
    main()
