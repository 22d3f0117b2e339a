#!/usr/bin/env python3
"""Writes the figures of docs/tutorials from runs of the program.

    tools/tutorial_figures.py [PROGRAM] [--only WORD]      default: build/release/overbend; about two minutes

Runs commands on the models of the pages, those in their fenced blocks included, opens the reports in headless Chromium and
photographs single figures into docs/images/tutorials/. Requires Chromium and Pillow (Debian: chromium, python3-pil, and
what tools/example_figures.py requires; then /usr/bin/python3).
"""

import argparse
import pathlib
import shutil
import sys
import tempfile

from PIL import Image

import check_examples
import example_figures

TUTORIALS = check_examples.ROOT / "docs" / "tutorials"
IMAGES = check_examples.ROOT / "docs" / "images" / "tutorials"
PIXELS = 1440  # width of the pictures
COLOURS = 128

# picture: (page, command, figure of its report, parts in one column, share of the height to keep from the top if not all)
PICTURES = {
    "shallow-stinger": ("shallow-s-lay.md", "static examples/shallow-s-lay.yaml", "stinger", ["overbend"]),
    "shallow-bending": ("shallow-s-lay.md", "static examples/shallow-s-lay.yaml", "bending", ["whole"]),
    "shallow-table": ("shallow-s-lay.md", 'lay-table examples/shallow-s-lay.yaml --tension "300 kN..600 kN/6"', "lay_table", ["curves"], 0.5),
    "deep-stinger": ("deep-s-lay.md", "static deep.yaml", "stinger", ["overbend"]),
    "deep-strain": ("deep-s-lay.md", "static sharp.yaml", "strain", ["overbend"]),
    "deep-moment": ("deep-s-lay.md", "static sharp.yaml", "moment", ["whole"]),
    "jlay-geometry": ("j-lay.md", "static examples/jlay.yaml", "geometry", ["whole"]),
    "jlay-tension": ("j-lay.md", "dynamic examples/jlay.yaml", "envelope_tension", ["whole"]),
    "abandonment-stages": ("abandonment-and-recovery.md", "static abandonment.yaml", "stages", ["whole"], 0.86),
    "abandonment-curves": ("abandonment-and-recovery.md", "static abandonment.yaml", "stage_curves", ["curves"], 0.595),
    "moored-plan": ("moored-barge.md", "static moored.yaml", "mooring_plan", ["field"]),
    "moored-move": ("moored-barge.md", "dynamic ahead.yaml", "history", ["operation"], 0.493),
    "moored-tensions": ("moored-barge.md", "dynamic ahead.yaml", "history", ["moorings"], 0.488),
    "operability-chart": ("operability.md", "study chart.yaml", "operability_chart", ["chart"]),
    "operability-rose": ("operability.md", "study chart.yaml", "operability_rose", ["rose"]),
    "fatigue-rate": ("fatigue.md", 'dynamic examples/bgl1-fatigue.yaml --duration "60 s"', "fatigue", ["whole"]),
    "fatigue-stress": ("fatigue.md", 'dynamic examples/bgl1-fatigue.yaml --duration "60 s"', "history", ["stress"]),
    "tee-curves": ("in-line-structure.md", "static tee.yaml", "stage_curves", ["curves"]),
    "tee-bending": ("in-line-structure.md", 'static tee.yaml --stage "stage 5"', "bending", ["overbend"]),
}


def shrink(picture, share):
    with Image.open(picture) as image:
        image = image.crop((0, 0, image.width, round(share * image.height)))
        height = round(image.height * PIXELS / image.width)
        small = image.convert("RGB").resize((PIXELS, height), Image.LANCZOS)
    small.quantize(COLOURS, dither=Image.Dither.NONE).save(picture, optimize=True)


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
        results = {}
        for name, (page, command, figure, parts, *share) in PICTURES.items():
            if given.only not in name:
                continue
            if (page, command) not in results:
                print(f"{page}: overbend {command}", flush=True)
                folder = pathlib.Path(scratch) / str(len(results))
                folder.mkdir()
                files = check_examples.read_page(TUTORIALS / page).files
                example = check_examples.Example(TUTORIALS / page, 0, command, files)
                results[page, command] = check_examples.run_example(given.program.resolve(), example, folder)
            picture = IMAGES / f"{name}.png"
            report = results[page, command] / "report.html"
            example_figures.photograph_figure(report, figure, parts, picture, pathlib.Path(scratch))
            shrink(picture, *share or [1.0])


if __name__ == "__main__":
    main()
