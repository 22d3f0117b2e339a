#!/usr/bin/env python3
"""The figures of the examples' pages and of docs/reproduction.md, from runs of the program.

    tools/example_figures.py [PROGRAM] [--only WORD]      default: build/release/overbend; some three minutes

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

# name: (kind, example, further words, change of its text)
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


def results_of(program, name, folder):
    """Folder with the results of a run."""
    kind, example, words, change = RUNS[name]
    out = folder / name
    text = (ROOT / "examples" / example).read_text(encoding="utf-8")
    if change:
        text, found = re.subn(*change, text, flags=re.M)
        if found != 1:
            sys.exit(f"{example}: {change[0]!r} found {found} times")
    model = folder / f"{name}.yaml"
    model.write_text(text.replace("../data/", f"{ROOT}/data/"), encoding="utf-8")
    print(f"{kind} {example} for {name}", flush=True)
    subprocess.run([program, kind, model, *words, "-o", out], check=True, capture_output=True, timeout=600)
    return out


# Leaves of the report's page only the panels wanted, one below the other, and tells their height.
ALONE = """<script>
(() => {
  const kept = %s.map((p) => document.querySelector(`.panel[data-figure="%s"][data-part="${p}"]`));
  document.body.replaceChildren(...kept);
  document.body.style.cssText = 'background:#fff;margin:0;padding:8px 0;width:%dpx';
  document.querySelectorAll('.hint').forEach((hint) => hint.remove());
  document.title = 'height ' + Math.ceil(document.body.getBoundingClientRect().height);
})();
</script>"""


def chromium(words, folder):
    done = subprocess.run(["chromium", *FLAGS, f"--user-data-dir={folder}/profile", *words], capture_output=True, text=True, timeout=120, check=True)
    return done.stdout


def photographed(page, picture, folder, height=None):
    """Writes the page as a picture, as tall as its own title says unless told."""
    if height is None:
        height = int(re.search(r"<title>height (\d+)", chromium(["--dump-dom", page.as_uri()], folder))[1])
    chromium([f"--window-size={WIDTH},{height}", "--force-device-scale-factor=2", f"--screenshot={picture}", page.as_uri()], folder)


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
    """A frame with axes; y grows upwards from lo to hi."""

    def __init__(self, top, height, x, y, title, y_label, x_label=None):
        self.top, self.height, self.x_range, self.y_range = top, height, x, y
        self.out = [f'<text x="{LEFT}" y="{top - 14}" font-size="15" font-weight="600">{title}</text>']
        self.grid = []
        for t in ticks(*x, 12):
            self.grid.append(f'<line x1="{self.x(t):.1f}" x2="{self.x(t):.1f}" y1="{top}" y2="{top + height}" stroke="#d5dce3"/>'
                             f'<text x="{self.x(t):.1f}" y="{top + height + 17}" text-anchor="middle" fill="#5b6b7a">{t:g}</text>')
        for v in ticks(*y, height / 40):
            self.grid.append(f'<line x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{self.y(v):.1f}" y2="{self.y(v):.1f}" stroke="#d5dce3"/>'
                             f'<text x="{LEFT - 8}" y="{self.y(v) + 4:.1f}" text-anchor="end" fill="#5b6b7a">{round(v, 9):g}</text>')
        self.grid.append(f'<text transform="translate(20,{top + height / 2}) rotate(-90)" text-anchor="middle" fill="#5b6b7a">{y_label}</text>')
        if x_label:
            self.grid.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{top + height + 38}" text-anchor="middle" fill="#5b6b7a">{x_label}</text>')

    def x(self, t):
        return LEFT + (t - self.x_range[0]) / (self.x_range[1] - self.x_range[0]) * (WIDTH - LEFT - RIGHT)

    def y(self, v):
        return self.top + self.height * (self.y_range[1] - v) / (self.y_range[1] - self.y_range[0])

    def band(self, lo, hi, colour):
        self.grid.insert(0, f'<rect x="{LEFT}" width="{WIDTH - LEFT - RIGHT}" y="{self.y(hi):.1f}" height="{self.y(lo) - self.y(hi):.1f}" fill="{colour}"/>')

    def line(self, time, value, colour, width=1.8, dash=""):
        points = " ".join(f"{self.x(t):.1f},{self.y(v):.1f}" for t, v in zip(time, value) if self.x_range[0] <= t <= self.x_range[1])
        self.out.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="{width}" stroke-linejoin="round" stroke-dasharray="{dash}"/>')

    def states(self, time, state, y):
        """A strip of colours at the pixel height y: what the machine does."""
        begin = 0
        for i in range(1, len(time) + 1):
            if i == len(time) or state[i] != state[begin]:
                t0, t1 = time[begin], time[min(i, len(time) - 1)]
                if int(state[begin]) in STATES and t1 > self.x_range[0] and t0 < self.x_range[1]:
                    x0, x1 = self.x(max(t0, self.x_range[0])), self.x(min(t1, self.x_range[1]))
                    self.out.append(f'<rect x="{x0:.1f}" width="{x1 - x0:.1f}" y="{y}" height="9" fill="{STATES[int(state[begin])][0]}"/>')
                begin = i

    def svg(self):
        return "\n".join(self.grid + [f'<rect x="{LEFT}" y="{self.top}" width="{WIDTH - LEFT - RIGHT}" height="{self.height}" fill="none" stroke="#8794a0"/>'] + self.out)


def legend(entries, y):
    """Words with their colours, in one line."""
    out, x = [], LEFT
    for colour, text, block in entries:
        out.append(f'<rect x="{x}" y="{y - (10 if block else 6)}" width="18" height="{12 if block else 3}" fill="{colour}"/><text x="{x + 24}" y="{y}">{text}</text>')
        x += 24 + 7.2 * len(text) + 22
    return "\n".join(out)


def drawn(parts, height, picture, folder):
    page = folder / "chart.html"
    page.write_text(f'<!doctype html><meta charset="utf-8"><body style="margin:0"><svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" '
                    'font-family="Liberation Sans, Arial, sans-serif" font-size="13" fill="#1b2733"><rect width="100%" height="100%" fill="#fff"/>'
                    + "\n".join(parts) + "</svg></body>", encoding="utf-8")
    photographed(page, picture, folder, height)


OFF, ON, CONSTANT = "#7b8794", "#0b5394", "#d9720a"


def draw_tension(runs, picture, folder):
    """Top tension, tensioner off against on: the whole run, and two waves of it with what the machine does."""
    parts = [legend([("#d6ead9", "range 240 to 260 kN", True), (OFF, "off (brake locked)", False), (ON, "on (controlled)", False),
                     *((colour, text, True) for colour, text in STATES.values())], 22)]
    for top, height, span, title in ((66, 200, (0, 300), "Top tension"), (334, 250, (216, 252), "Three waves of it; the strip shows what the machine does")):
        chart = Chart(top, height, span, (180, 310), title, "Tension [kN]", "Time from the end of the build-up [s]" if top > 300 else None)
        chart.band(240, 260, "#d6ead9")
        for run, colour in (("locked", OFF), ("controlled", ON)):
            time, value = history(runs[run], "tensioner/tension")
            chart.line(time, value / 1e3, colour, 1.3 if span[1] == 300 else 2)
        if top > 300:
            chart.states(*history(runs["controlled"], "tensioner/state"), top + height - 12)
        parts.append(chart.svg())
    drawn(parts, 636, picture, folder)


def draw_travel(runs, picture, folder):
    """Movement of the pipe at the tensioner."""
    parts = [legend([(OFF, "off (brake locked)", False), (ON, "on (controlled)", False), (CONSTANT, "ideal constant tension", False)], 22)]
    chart = Chart(66, 300, (0, 120), (-0.25, 0.35), "Pipe movement at the tensioner, paid out positive", "Travel [m]", "Time from the end of the build-up [s]")
    for run, colour in (("constant", CONSTANT), ("locked", OFF), ("controlled", ON)):
        chart.line(*history(runs[run], "tensioner/travel"), colour, 2)
    drawn([*parts, chart.svg()], 418, picture, folder)


DRAWN = {"tensioner-tension": (draw_tension, ["locked", "controlled"]), "tensioner-travel": (draw_travel, ["locked", "controlled", "constant"])}


def main():
    words = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    words.add_argument("program", nargs="?", default=ROOT / "build" / "release" / "overbend", type=pathlib.Path)
    words.add_argument("--only", default="", help="pictures whose name holds this")
    words.add_argument("--keep", type=pathlib.Path, help="folder for the runs; those already in it are not run again")
    asked = words.parse_args()
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
                done[name] = keep / name if (keep / name / "results.h5").exists() else results_of(asked.program.resolve(), name, keep)
            return done[name]

        for name, (source, figure, parts) in PICTURES.items():
            if asked.only in name:
                photograph_figure(run(source) / "report.html", figure, parts, IMAGES / f"{name}.png", folder)
        for name, (draw, needed) in DRAWN.items():
            if asked.only in name:
                draw({r: run(r) for r in needed}, IMAGES / f"{name}.png", folder)


if __name__ == "__main__":
    main()
