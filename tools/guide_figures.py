#!/usr/bin/env python3
"""Writes the figures of docs/guide from runs of the program.

    tools/guide_figures.py [PROGRAM] [--only WORD]      default: build/release/overbend; some minutes

Runs commands on the examples and on the models in the fenced blocks of the pages, opens the reports in headless Chromium
and photographs single figures into docs/images/guide/. Requires Chromium and Pillow (Debian: chromium, python3-pil, and
what tools/example_figures.py requires; then /usr/bin/python3), and for the figure of the page on Python matplotlib and the
package overbend on PYTHONPATH.
"""

import argparse
import pathlib
import shutil
import sys
import tempfile

from PIL import Image

import check_examples
import example_figures

GUIDE = check_examples.ROOT / "docs" / "guide"
IMAGES = check_examples.ROOT / "docs" / "images" / "guide"
PIXELS = 1280  # width of the pictures

# picture: (page, command, figure of its report, parts in one column)
PICTURES = {
    "first-model": ("first-model.md", "static examples/first-model.yaml", "configuration", ["whole"]),
    "uneven-seabed": ("lays.md", "static examples/uneven-seabed.yaml", "configuration", ["whole"]),
    "stinger-angle": ("stinger-motion.md", "dynamic floating.yaml", "history", ["stinger_angle"]),
    "mooring-plan": ("moorings.md", "static examples/moored-barge.yaml", "mooring_plan", ["field"]),
    "lay-table": ("lay-tables.md", "lay-table examples/first-model.yaml --tension '200 kN..400 kN/20'", "lay_table", ["curves"]),
    "study-maps": ("studies.md", "study study.yaml", "study_maps", ["all"]),
    "operability": ("operability.md", "study depth.yaml", "operability_chart", ["chart"]),
    "passage": ("in-line-structures.md", "static passage.yaml", "stage_curves", ["curves"]),
    "pull-ahead": ("pull-ahead.md", "dynamic move.yaml", "history", ["tensioner"]),
    "abandonment": ("operations.md", "static examples/bgl1-abandonment.yaml", "stage_curves", ["curves"]),
    "points-on-pipe": ("on-the-pipe.md", "static examples/buoys-on-pipe.yaml", "moment", ["whole"]),
    "lift-stages": ("lifts.md", "static examples/davit-lift.yaml", "curves", ["whole"]),
    "hawser-tension": ("bodies.md", "dynamic examples/tugs.yaml", "line_tension", ["0"]),
    "shore-pull": ("shore-pull.md", "static examples/shore-pull.yaml", "stage_curves", ["curves"]),
    "fatigue-rate": ("fatigue.md", "dynamic examples/bgl1-fatigue.yaml", "fatigue", ["overbend"]),
    "seek-path": ("seek.md", "seek sagbend.yaml", "seek_path", ["0"]),
    "utilisation": ("checks.md", "static examples/bgl1.yaml", "checks", ["overbend"]),
}
KEPT = {"shore-pull": 0.332}  # part of the height that is kept, from the top


def write_picture(program, name, scratch):
    page, command, figure, parts = PICTURES[name]
    print(f"{page}: overbend {command}", flush=True)
    folder = scratch / name
    folder.mkdir()
    example = check_examples.Example(GUIDE / page, 0, command, check_examples.read_page(GUIDE / page).files)
    results = check_examples.run_example(program, example, folder)
    picture = IMAGES / f"{name}.png"
    example_figures.photograph_figure(results / "report.html", figure, parts, picture, scratch)
    shrink(picture)


def shrink(picture):
    with Image.open(picture) as image:
        image = image.crop((0, 0, image.width, round(KEPT.get(picture.stem, 1.0) * image.height)))
        small = image.convert("RGB").resize((PIXELS, round(image.height * PIXELS / image.width)), Image.LANCZOS)
    small.quantize(64, dither=Image.Dither.NONE).save(picture, optimize=True)


def draw_with_python(picture):
    """The figure of the page on Python."""
    import matplotlib

    matplotlib.use("Agg")
    import overbend

    axes = overbend.Model.read(check_examples.ROOT / "examples" / "bgl1.yaml").static().plot.stress(part="overbend")
    axes.figure.set_size_inches(9, 3.6)
    axes.figure.tight_layout()
    axes.figure.savefig(picture, dpi=160)
    shrink(picture)


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    default = check_examples.ROOT / "build" / "release" / "overbend"
    options.add_argument("program", nargs="?", default=default, type=pathlib.Path)
    options.add_argument("--only", default="", help="pictures whose name contains this")
    given = options.parse_args()
    if not shutil.which("chromium"):
        sys.exit("chromium is not installed")
    IMAGES.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        for name in PICTURES:
            if given.only in name:
                write_picture(given.program.resolve(), name, pathlib.Path(scratch))
    if given.only in "python-stress":
        draw_with_python(IMAGES / "python-stress.png")


if __name__ == "__main__":
    main()
