#!/usr/bin/env python3
"""The figures of the examples' pages and of docs/reproduction.md, from runs of the program.

    tools/example_figures.py [PROGRAM] [--only WORD]      default: build/release/overbend; some minutes

Solves the examples, opens their reports in headless Chromium and photographs single figures at twice their size into
docs/images/examples/. Two figures that compare runs are drawn here from results.h5. Wants Chromium and h5py (Debian:
chromium, python3-h5py; then /usr/bin/python3).
"""

import argparse
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import h5py

import svg

ROOT = pathlib.Path(__file__).resolve().parents[1]
IMAGES = ROOT / "docs" / "images" / "examples"
FLAGS = [
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--hide-scrollbars",
    "--disable-background-networking", "--disable-component-update", "--disable-sync", "--virtual-time-budget=5000",
]
WIDTH = 960


def mode(name):
    return (r"^(  travel: 2.5 m)", rf"  mode: {name}\n\g<1>")


GAP_SPRINGS = (r"^supports:", "supports:\n  contact: gap_springs")

# name: (kind, example, further options, change of its text)
RUNS = {
    "static": ("static", "bgl1.yaml", [], None),
    "as-printed": ("static", "bgl1-as-printed.yaml", [], None),
    "irregular": ("dynamic", "bgl1.yaml", ["--duration", "600 s"], None),
    "workable": ("dynamic", "bgl1-workable-sea.yaml", ["--duration", "600 s"], None),
    "gap-springs": ("dynamic", "bgl1-tensioner.yaml", [], GAP_SPRINGS),
    "locked": ("dynamic", "bgl1-tensioner.yaml", [], mode("locked")),
    "controlled": ("dynamic", "bgl1-tensioner.yaml", [], None),
    "constant": ("dynamic", "bgl1-tensioner.yaml", [], mode("constant")),
}

# picture: (run, figure of its report, parts in one column)
PICTURES = {
    "static-configuration": ("static", "configuration", ["whole"]),
    "static-stinger": ("static", "configuration", ["stinger"]),
    "static-geometry": ("static", "geometry", ["whole", "overbend"]),
    "static-tension": ("static", "tension", ["whole", "overbend"]),
    "static-bending": ("static", "bending", ["whole", "overbend"]),
    "static-mises": ("static", "mises", ["whole", "overbend"]),
    "static-reactions": ("static", "reactions", ["bars"]),
    "as-printed-mises": ("as-printed", "mises", ["overbend"]),
    "as-printed-reactions": ("as-printed", "reactions", ["bars"]),
    "irregular-mises": ("irregular", "envelope_mises", ["whole", "overbend"]),
    "irregular-clearance": ("irregular", "history", ["separation"]),
    "workable-mises": ("workable", "envelope_mises", ["whole", "overbend"]),
    "rollers-shares": ("controlled", "shares", ["bars"]),
    "rollers-reactions": ("controlled", "ranges", ["bars"]),
    "gap-springs-shares": ("gap-springs", "shares", ["bars"]),
    "gap-springs-reactions": ("gap-springs", "ranges", ["bars"]),
}


def run_example(program, name, folder):
    """Folder with the results of a run."""
    kind, example, options, change = RUNS[name]
    out = folder / name
    text = (ROOT / "examples" / example).read_text(encoding="utf-8")
    if change:
        text, found = re.subn(*change, text, flags=re.M)
        if found != 1:
            sys.exit(f"{example}: {change[0]!r} found {found} times")
    model = folder / f"{name}.yaml"
    model.write_text(text.replace("../data/", f"{ROOT}/data/"), encoding="utf-8")
    print(f"{kind} {example} for {name}", flush=True)
    subprocess.run([program, kind, model, *options, "-o", out], check=True, capture_output=True, timeout=600)
    return out


# Keeps only the requested panels of the report's page, one below the other, and puts their height in the title.
ALONE = """<script>
(() => {
  const kept = %s.map((p) => document.querySelector(`.panel[data-figure="%s"][data-part="${p}"]`));
  document.body.replaceChildren(...kept);
  document.body.style.cssText = 'background:#fff;margin:0;padding:8px 0;width:%dpx';
  document.querySelectorAll('.hint').forEach((hint) => hint.remove());
  document.title = 'height ' + Math.ceil(document.body.getBoundingClientRect().height);
})();
</script>"""


def chromium(options, folder):
    command = ["chromium", *FLAGS, f"--user-data-dir={folder}/profile", *options]
    return subprocess.run(command, capture_output=True, encoding="utf-8", timeout=120, check=True).stdout


def photographed(page, picture, folder, height=None):
    """Writes the page as a picture; without a height that of its title is used."""
    if height is None:
        height = int(re.search(r"<title>height (\d+)", chromium(["--dump-dom", page.as_uri()], folder))[1])
    size = [f"--window-size={WIDTH},{height}", "--force-device-scale-factor=2"]
    chromium([*size, f"--screenshot={picture}", page.as_uri()], folder)


def photograph_figure(report, figure, parts, picture, folder):
    page = folder / "alone.html"
    text = report.read_text(encoding="utf-8")
    end = text.rindex("</body>")
    page.write_text(text[:end] + ALONE % (parts, figure, WIDTH) + text[end:], encoding="utf-8")
    photographed(page, picture, folder)


# --- figures that compare runs ---------------------------------------------------------------------------------------

LEFT, RIGHT = 78, 24
STATES = {1: ("#f2d16b", "waits"), 2: ("#4f9d69", "pays out"), 3: ("#b3261e", "hauls in")}


def history(run, name):
    """Times and values of a history from t = 0."""
    with h5py.File(run / "results.h5") as file:
        group = file["dynamic/histories"]
        time, value = group["time"][:], group[name][:]
    return time[time >= 0.0], value[time >= 0.0]


def ticks(lo, hi, most):
    raw = (hi - lo) / most
    power = 10.0 ** math.floor(math.log10(raw))
    step = next(power * f for f in (1, 2, 5, 10) if power * f >= raw)
    first = math.ceil(lo / step - 1e-9)
    return [step * k for k in range(first, math.floor(hi / step + 1e-9) + 1)]


class Chart:
    """A frame with axes; y grows upwards."""

    def __init__(self, top, height, x_range, y_range, title, y_label, x_label=""):
        self.top, self.height, self.x_range, self.y_range = top, height, x_range, y_range
        right, bottom, middle = WIDTH - RIGHT, top + height, (LEFT + WIDTH - RIGHT) / 2
        soft = {"text_anchor": "middle", "fill": svg.SOFT}
        self.behind = []
        for t in ticks(*x_range, 12):
            self.behind += [svg.line(self.x(t), top, self.x(t), bottom), svg.text(self.x(t), bottom + 17, f"{t:g}", **soft)]
        for v in ticks(*y_range, height / 40):
            y = self.y(v)
            self.behind += [svg.line(LEFT, y, right, y)]
            self.behind += [svg.text(LEFT - 8, y + 4, f"{round(v, 9):g}", text_anchor="end", fill=svg.SOFT)]
        self.behind.append(svg.text(0, 0, y_label, transform=f"translate(20,{top + height / 2}) rotate(-90)", **soft))
        self.behind.append(svg.text(middle, bottom + 38, x_label, **soft))
        self.out = [svg.text(LEFT, top - 14, title, font_size=15, font_weight=600)]

    def x(self, t):
        return LEFT + (t - self.x_range[0]) / (self.x_range[1] - self.x_range[0]) * (WIDTH - LEFT - RIGHT)

    def y(self, v):
        return self.top + self.height * (self.y_range[1] - v) / (self.y_range[1] - self.y_range[0])

    def band(self, lo, hi, colour):
        height = self.y(lo) - self.y(hi)
        self.behind.insert(0, svg.rect(LEFT, self.y(hi), WIDTH - LEFT - RIGHT, height, fill=colour))

    def line(self, time, value, colour, width):
        seen = (time >= self.x_range[0]) & (time <= self.x_range[1])
        points = " ".join(f"{self.x(t):.1f},{self.y(v):.1f}" for t, v in zip(time[seen], value[seen]))
        self.out.append(svg.element("polyline", points=points, fill="none", stroke=colour, stroke_width=width))

    def states(self, time, state):
        """A strip of colours at the foot: what the machine does."""
        seen = (time >= self.x_range[0]) & (time <= self.x_range[1])
        for a, b, what in zip(time[seen], time[seen][1:], state[seen]):
            if int(what) in STATES:
                x0, x1 = self.x(a), self.x(b)
                self.out.append(svg.rect(x0, self.top + self.height - 12, x1 - x0 + 0.2, 9, fill=STATES[int(what)][0]))

    def parts(self):
        frame = svg.rect(LEFT, self.top, WIDTH - LEFT - RIGHT, self.height, fill="none", stroke=svg.FRAME)
        return [*self.behind, frame, *self.out]


def legend(entries, y):
    """Labels with their colours, in one line."""
    out, x = [], LEFT
    for colour, text, block in entries:
        out.append(svg.rect(x, y - (10 if block else 6), 18, 12 if block else 3, fill=colour))
        out.append(svg.text(x + 24, y, text))
        x += 46 + 7.2 * len(text)
    return out


def write_chart(parts, height, picture, folder):
    page = folder / "chart.html"
    drawing = svg.document(WIDTH, height, parts)
    page.write_text(f'<!doctype html><meta charset="utf-8"><body style="margin:0">{drawing}</body>', encoding="utf-8")
    photographed(page, picture, folder, height)


OFF, ON, CONSTANT, RANGE = "#7b8794", "#0b5394", "#d9720a", "#d6ead9"
TIME = "Time from the end of the build-up [s]"


def draw_tension(runs, picture, folder):
    """Top tension, tensioner off against on: the whole run, and three waves of it with what the machine does."""
    lines = [(RANGE, "range 240 to 260 kN", True), (OFF, "off (brake locked)", False), (ON, "on (controlled)", False)]
    parts = legend([*lines, *((colour, text, True) for colour, text in STATES.values())], 22)
    whole = Chart(66, 200, (0, 300), (180, 310), "Top tension", "Tension [kN]")
    title = "Three waves of it; the strip shows what the machine does"
    near = Chart(334, 250, (216, 252), (180, 310), title, "Tension [kN]", TIME)
    for chart, width in ((whole, 1.3), (near, 2)):
        chart.band(240, 260, RANGE)
        for run, colour in (("locked", OFF), ("controlled", ON)):
            time, value = history(runs[run], "tensioner/tension")
            chart.line(time, value / 1e3, colour, width)
    near.states(*history(runs["controlled"], "tensioner/state"))
    write_chart([*parts, *whole.parts(), *near.parts()], 636, picture, folder)


def draw_travel(runs, picture, folder):
    """Movement of the pipe at the tensioner."""
    lines = (("constant", CONSTANT, "ideal constant tension"), ("locked", OFF, "off (brake locked)"),
             ("controlled", ON, "on (controlled)"))
    chart = Chart(66, 300, (0, 120), (-0.25, 0.35), "Pipe movement at the tensioner, paid out positive", "Travel [m]", TIME)
    for run, colour, _ in lines:
        chart.line(*history(runs[run], "tensioner/travel"), colour, 2)
    write_chart([*legend([(colour, text, False) for _, colour, text in lines], 22), *chart.parts()], 418, picture, folder)


DRAWN = {
    "tensioner-tension": (draw_tension, ["locked", "controlled"]),
    "tensioner-travel": (draw_travel, ["locked", "controlled", "constant"]),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", nargs="?", default=ROOT / "build" / "release" / "overbend", type=pathlib.Path)
    parser.add_argument("--only", default="", help="pictures whose name holds this")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for the runs; those already in it are not run again")
    asked = parser.parse_args()
    if not shutil.which("chromium"):
        sys.exit("chromium is not installed")
    IMAGES.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        keep = asked.keep.resolve() if asked.keep else folder
        keep.mkdir(parents=True, exist_ok=True)
        done = {}

        def run(name):
            if name not in done:
                is_done = (keep / name / "results.h5").exists()
                done[name] = keep / name if is_done else run_example(asked.program.resolve(), name, keep)
            return done[name]

        for name, (source, figure, parts) in PICTURES.items():
            if asked.only in name:
                photograph_figure(run(source) / "report.html", figure, parts, IMAGES / f"{name}.png", folder)
        for name, (draw, needed) in DRAWN.items():
            if asked.only in name:
                draw({r: run(r) for r in needed}, IMAGES / f"{name}.png", folder)


if __name__ == "__main__":
    main()
