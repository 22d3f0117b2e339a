#!/usr/bin/env python3
"""Sensitivity of the results of the BGL-1 examples to single inputs: table and tornado diagrams of docs/reproduction.md.

    tools/sensitivity.py [PROGRAM]      default: build/release/overbend; a few minutes
    tools/sensitivity.py --draw         only the diagrams again, from the table

Runs examples/bgl1.yaml in statics and examples/bgl1-tensioner.yaml for 120 s, once unchanged and once for
each change of a single input. Writes docs/sensitivity.csv and docs/images/tornado-*.svg.
"""

import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

import svg

ROOT = pathlib.Path(__file__).resolve().parents[1]
TABLE = ROOT / "docs" / "sensitivity.csv"
IMAGES = ROOT / "docs" / "images"
DURATION = "120 s"
TENSION = 250.0            # kN, of the examples; the range reaches 10 kN to either side
ROLLER_STIFFNESS = 833.0   # MN/m, what the program chooses for this pipe: EI / h^3


def substituted(text, pattern, replacement, count=1):
    """The text with each of so many places changed, and no other number of places."""
    changed, found = re.subn(pattern, replacement, text, flags=re.M)
    if found != count:
        sys.exit(f"expected {count} places of {pattern!r}, found {found}")
    return changed


def shoe(z):
    return lambda text: substituted(text, r"(stern_shoe: \{x: -60 m, z: )[\d.]+", rf"\g<1>{z:.3f}")


def rows(count):
    return lambda text: substituted(text, r"^(    rows: )3", rf"\g<1>{count}", 2)


def stiffness(factor):
    value = f"{1e3 * ROLLER_STIFFNESS * factor:.0f} kN/m"
    return lambda text: substituted(text, r"^(    restitution: 0.3)", rf"\g<1>\n    stiffness: {value}")


def friction(factor):
    return lambda text: substituted(
        text, r"axial: 0.02, lateral: 0.3", f"axial: {0.02 * factor:g}, lateral: {0.3 * factor:g}")


def delay(seconds):
    return lambda text: substituted(text, r"^(  delay: )2 s", rf"\g<1>{seconds:g} s")


def velocity(speed):
    return lambda text: substituted(text, r"^(  velocity: )0.25 m/s", rf"\g<1>{speed:g} m/s")


def acceleration(value):
    return lambda text: substituted(text, r"^(  delay: 2 s)", rf"\g<1>\n  acceleration: {value:g} m/s^2")


def drag(factor):
    return lambda text: substituted(
        text, r"drag_normal: 1.2, drag_axial: 0.03", f"drag_normal: {1.2 * factor:g}, drag_axial: {0.03 * factor:g}")


def current(factor):
    def change(text):
        return re.sub(r"speed: ([\d.]+) m/s", lambda m: f"speed: {float(m[1]) * factor:g} m/s", text)
    return change


def tension(factor):
    def change(text):
        wanted = TENSION * factor
        text = substituted(text, r"^(  tension: )250 kN", rf"\g<1>{wanted:g} kN")
        return substituted(text, r"\[240 kN, 260 kN\]", f"[{wanted - 10:g} kN, {wanted + 10:g} kN]")
    return change


def surge(factor):
    return lambda text: substituted(text, r"\.\./data/bgl1/rao\.csv", f"rao-surge-{factor:g}.csv")


# input, its base, [(value, change of the model's text), ...], whether statics know it
INPUTS = [
    ("top tension", "250 kN", [("225 kN", tension(0.9)), ("275 kN", tension(1.1))], True),
    ("stern shoe above water", "3.818 m", [("3.568 m", shoe(3.568)), ("4.068 m", shoe(4.068))], True),
    ("roller rows per box", "3", [("1", rows(1)), ("5", rows(5))], True),
    ("roller stiffness", "833 MN/m", [("83 MN/m", stiffness(0.1)), ("8330 MN/m", stiffness(10))], True),
    ("current speed", "as given", [("-20 %", current(0.8)), ("+20 %", current(1.2))], True),
    ("drag coefficients", "1.2, 0.03", [("-20 %", drag(0.8)), ("+20 %", drag(1.2))], True),
    ("roller friction along, across", "0.02, 0.3", [("0, 0", friction(0)), ("0.04, 0.6", friction(2))], False),
    ("surge RAO", "as computed", [("-20 %", surge(0.8)), ("+20 %", surge(1.2))], False),
    ("tensioner delay", "2 s", [("1 s", delay(1)), ("4 s", delay(4))], False),
    ("tensioner velocity", "0.25 m/s", [("0.1 m/s", velocity(0.1)), ("0.5 m/s", velocity(0.5))], False),
    ("tensioner acceleration", "0.5 m/s2", [("0.1 m/s2", acceleration(0.1)), ("1 m/s2", acceleration(1))], False),
]

# key, study, title of the tornado, unit, digits, and the longest bar, if the rest would be dwarfed without
RESULTS = [
    ("overbend_von_mises", "static", "Static: largest von Mises stress of the overbend", "MPa", 1, None),
    ("overbend_bending", "static", "Static: largest bending stress of the overbend", "MPa", 1, None),
    ("sagbend_bending", "static", "Static: largest bending stress of the sagbend", "MPa", 1, None),
    ("out_of_range", "tensioner", "Tensioner study: share of time with the tension out of its range", "%", 1, None),
    ("tension_std", "tensioner", "Tensioner study: standard deviation of the top tension", "kN", 1, None),
    ("overbend_von_mises", "tensioner", "Tensioner study: largest von Mises stress of the overbend", "MPa", 1, 120.0),
]


def scaled_raos(factor, path):
    """The barge's RAOs with the amplitude of surge multiplied."""
    lines = []
    for line in (ROOT / "data" / "bgl1" / "rao.csv").read_text(encoding="utf-8").splitlines():
        cells = line.split(",")
        if len(cells) == 5 and cells[2] == "surge":
            cells[3] = f"{float(cells[3]) * factor:.6e}"
        lines.append(",".join(cells))
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def run(program, kind, text, folder):
    """The summary of a run of a model's text; none if there is no equilibrium to start from."""
    model = folder / "model.yaml"
    model.write_text(text.replace("../data/bgl1/rao.csv", str(ROOT / "data" / "bgl1" / "rao.csv")), encoding="utf-8")
    extra = ["--duration", DURATION] if kind == "dynamic" else []
    done = subprocess.run([program, kind, model, *extra, "-o", folder / "out"], capture_output=True, encoding="utf-8", timeout=300)
    if done.returncode == 3 and "no equilibrium found" in done.stderr:
        return None
    if done.returncode != 0:
        sys.exit(f"{done.stdout[-500:]}{done.stderr[-2000:]}")
    return json.loads((folder / "out" / "summary.json").read_text(encoding="utf-8"))


def measured(kind, summary):
    """Results of a run for the table."""
    if summary is None:
        return None
    if kind == "static":
        found = summary["static"]
        return {"overbend_von_mises": found["overbend"]["max_von_mises"] / 1e6,
                "overbend_bending": found["overbend"]["max_bending_stress"] / 1e6,
                "sagbend_bending": found["sagbend"]["max_bending_stress"] / 1e6, "left": []}
    found = summary["dynamic"]
    machine = found["tensioner"]
    left = [m[1] for m in (re.search(r"left '(.+)' over its side", w) for w in found["warnings"]) if m]
    return {"out_of_range": 100 * machine["time_out_of_range"] / found["duration"],
            "tension_std": machine["std_tension"] / 1e3,
            "overbend_von_mises": found["overbend"]["max_von_mises"]["max"] / 1e6, "left": left}


def studied(program, folder):
    """{study: (base, [(input, base value, value, results), ...])}"""
    for factor in (0.8, 1.2):
        scaled_raos(factor, folder / f"rao-surge-{factor:g}.csv")
    studies = {}
    for study, kind, name in (("static", "static", "bgl1.yaml"), ("tensioner", "dynamic", "bgl1-tensioner.yaml")):
        text = (ROOT / "examples" / name).read_text(encoding="utf-8")
        base = measured(kind, run(program, kind, text, folder))
        changed = []
        for label, base_value, changes, static in INPUTS:
            for value, change in changes if static or kind == "dynamic" else []:
                print(f"{study}: {label} {value}", flush=True)
                changed.append((label, base_value, value, measured(kind, run(program, kind, change(text), folder))))
        studies[study] = (base, changed)
    return studies


COLUMNS = ["study", "input", "base value", "value", "result", "unit", "base result", "result value", "change",
           "pipe left a box"]


def write_table(studies):
    with TABLE.open("w", encoding="utf-8", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(COLUMNS)
        for key, study, _, unit, digits, _ in RESULTS:
            base, changed = studies[study]
            number = lambda value, sign="": f"{value:{sign}.{digits + 1}f}"
            for label, base_value, value, found in changed:
                cells = [study, label, base_value, value, key, unit, number(base[key])]
                if found is None:
                    table.writerow([*cells, "no equilibrium", "", ""])
                else:
                    left = "yes" if found["left"] else "no"
                    table.writerow([*cells, number(found[key]), number(found[key] - base[key], "+"), left])


def tick_step(span):
    """A round distance of some six ticks."""
    power = 10.0 ** len(str(int(span))) / 1e3
    return next(step * power for step in (1, 2, 5, 10, 20, 50, 100, 200, 500) if span / (step * power) <= 7)


class Tornado:
    """Horizontal bars around a base value, the longest on top. bars: [(input, [(value, result or None, left), ...]), ...]"""

    WIDTH, LEFT, RIGHT, TOP, ROW = 960, 250, 80, 66, 34
    COLOURS = "#7fb0d8", "#e8a05a"

    def __init__(self, title, unit, digits, base, bars, longest):
        self.unit, self.digits, self.base, self.longest = unit, digits, base, longest
        self.bars = sorted(bars, key=lambda bar: -max(abs(r - base) for _, r, _ in bar[1] if r is not None))
        values = [base, *(self.shown(r) for _, ends in bars for _, r, _ in ends if r is not None)]
        room = 0.24 * (max(values) - min(values)) or 1.0
        self.lo = max(min(values) - room, 0.0)
        self.hi = max(values) + room
        self.bottom = self.TOP + self.ROW * len(bars)
        self.out = [svg.text(16, 24, f"{title} [{unit}]", font_size=16, font_weight=600)]

    def shown(self, result):
        return min(max(result, self.base - self.longest), self.base + self.longest)

    def x(self, value):
        return self.LEFT + (value - self.lo) / (self.hi - self.lo) * (self.WIDTH - self.LEFT - self.RIGHT)

    def axis(self):
        step = tick_step(self.hi - self.lo)
        tick = step * math.ceil(self.lo / step)
        while tick <= self.hi:
            x = self.x(tick)
            self.out.append(svg.line(x, self.TOP - 6, x, self.bottom))
            self.out.append(svg.text(x, self.bottom + 18, f"{tick:g}", text_anchor="middle", fill=svg.SOFT))
            tick += step

    def write(self, x, y, before, label, **attributes):
        anchor = "end" if before else "start"
        self.out.append(svg.text(x + (-5 if before else 5), y, label, text_anchor=anchor, **attributes))

    def row(self, y, ends):
        """The bars of one input; two that go the same way lie one above the other."""
        found = [r for _, r, _ in ends if r is not None]
        same_side = len(found) == 2 and (found[0] - self.base) * (found[1] - self.base) > 0
        for i, (value, result, left) in enumerate(ends):
            if result is None:  # on the side that the other end leaves free
                before = found[0] > self.base or (found[0] == self.base and i == 0)
                self.write(self.x(self.base), y + 20, before, f"{value}: no equilibrium found", font_size=12, fill="#b3261e")
                continue
            before = result < self.base or (result == self.base and i == 0)
            x0, x1 = sorted((self.x(self.base), self.x(self.shown(result))))
            y0, tall = (y + 4 + 13 * i, 12) if same_side else (y + 6, 20)
            self.out.append(svg.rect(x0, y0, max(x1 - x0, 1.0), tall, fill=self.COLOURS[i]))
            note = (" *" if left else "") + (" (bar cut)" if self.shown(result) != result else "")
            label = f"{value}: {result:.{self.digits}f}{note}"
            self.write(x0 if before else x1, y0 + 0.5 * tall + 4, before, label, font_size=12)

    def drawn(self):
        self.axis()
        for k, (label, ends) in enumerate(self.bars):
            y = self.TOP + self.ROW * k
            self.out.append(svg.text(self.LEFT - 12, y + 20, label, text_anchor="end"))
            self.row(y, ends)
        x = self.x(self.base)
        self.out.append(svg.line(x, self.TOP - 8, x, self.bottom, stroke=svg.INK, stroke_width=1.5))
        label = f"base {self.base:.{self.digits}f} {self.unit}"
        self.out.append(svg.text(x, self.TOP - 14, label, text_anchor="middle", font_weight=600))
        note = "Blue: the first value of an input, orange: the second."
        if any(left for _, ends in self.bars for _, _, left in ends):
            note += "  * the pipe left a roller box over its side"
        self.out.append(svg.text(self.LEFT, self.bottom + 46, note, font_size=12, fill=svg.SOFT))
        return svg.document(self.WIDTH, self.bottom + 62, self.out)


def drawings(studies):
    """(file name, drawing) of each result."""
    for key, study, title, unit, digits, longest in RESULTS:
        base, changed = studies[study]
        bars = {}
        for label, _, value, results in changed:
            bars.setdefault(label, []).append((value, results and results[key], bool(results and results["left"])))
        name = f"tornado-{study}-{key.replace('_', '-')}.svg"
        yield name, Tornado(title, unit, digits, base[key], list(bars.items()), longest or math.inf).drawn()


def draw(studies):
    for name, drawing in drawings(studies):
        (IMAGES / name).write_text(drawing, encoding="utf-8")


def kept():
    """Reads the studies from the table."""
    studies = {study: ({}, {}) for _, study, *_ in RESULTS}
    with TABLE.open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            base, changed = studies[row["study"]]
            base[row["result"]] = float(row["base result"])
            key = (row["input"], row["base value"], row["value"])
            changed.setdefault(key, None)
            if row["result value"] != "no equilibrium":
                left = row["pipe left a box"] == "yes"
                changed[key] = {**(changed[key] or {}), row["result"]: float(row["result value"]), "left": left}
    return {study: (base, [(*key, results) for key, results in changed.items()]) for study, (base, changed) in studies.items()}


def main():
    if sys.argv[1:] == ["--draw"]:
        draw(kept())
        return
    program = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build" / "release" / "overbend").resolve()
    with tempfile.TemporaryDirectory() as folder:
        studies = studied(program, pathlib.Path(folder))
    write_table(studies)
    draw(kept())


if __name__ == "__main__":
    main()
