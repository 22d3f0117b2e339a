"""What the guide says is rejected or reported is rejected or reported by the program.

    claims_test.py PROGRAM

A claim names the page, a model of examples with a change, the command, its exit code and words of its output. When a claim
fails, either the program or the page is wrong.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else None

FIRST = "first-model.yaml"
CHECK = ("check",)
SHORT_RUN = ("dynamic", "--duration", "1 s", "-o", "out")

# Page, claim, model, (pattern, replacement) or text to append, command, exit code, words of the output.
CLAIMS = [
    ("README.md", "an unknown key is rejected", FIRST, ("tension: 300 kN", "tensoin: 300 kN"), CHECK, 2, "tensoin"),
    ("README.md", "a missing unit is rejected", FIRST, ("tension: 300 kN", "tension: 300"), CHECK, 2, "unit"),
    ("README.md", "a wall thicker than the pipe is rejected", FIRST, ("wall_thickness: 12.7 mm", "wall_thickness: 200 mm"), CHECK,
     2, "wall_thickness"),
    ("README.md", "the file and line of an error are given", FIRST, ("tension: 300 kN", "tension: 300 m"), CHECK, 2,
     "model.yaml:"),
    ("docs/guide/model.md", "a wrong dimension is an error", FIRST, ("water_depth: 40 m", "water_depth: 40 kN"), CHECK, 2,
     "water_depth"),
    ("docs/guide/errors.md", "a mesh of more than 50,000 elements is rejected by key", FIRST,
     (r"water_depth: 40 m((?s:.*))tension: 300 kN((?s:.*))$",
      r"water_depth: 600 m\1tension: 2000 kN\2\nanalysis: {mesh: {longest_element: 0.02 m}}\n"),
     ("static", "-o", "out"), 2, "analysis.mesh.longest_element"),
    ("docs/guide/errors.md", "a folder without results is rejected", FIRST, ("", ""), ("report", "."), 2, "results.h5"),
    ("docs/guide/shore-pull.md", "a dynamic analysis of a stage is rejected", "shore-pull.yaml",
     "analysis: {dynamic: {duration: 1 s}}\n", ("dynamic", "--stage", "3", "-o", "out"), 2, ""),
    ("docs/guide/shore-pull.md", "a route that bends is rejected", "shore-pull.yaml",
     "route: {points: [{x: 500 m, y: 0 m}, {x: 1500 m, y: -200 m}], corner_radius: 1200 m}\n", CHECK, None, "route"),
    ("docs/guide/operations.md", "a cable on a route that bends is rejected", "bgl1-abandonment.yaml",
     "route: {points: [{x: 500 m, y: 0 m}, {x: 1500 m, y: -200 m}], corner_radius: 1200 m}\n", ("static", "-o", "out"), 2, "route"),
    ("docs/theory/fatigue.md", "fatigue is rejected in a pull-ahead", "bgl1-pull-ahead.yaml", "fatigue: {}\n", SHORT_RUN, 2,
     "fatigue"),
    ("docs/theory/yielding.md", "numbers of a law without the law are rejected", FIRST,
     ("yield_stress: 414 MPa}", "yield_stress: 414 MPa, material: {exponent: 20}}"), CHECK, 2, "law"),
    ("docs/theory/waves.md", "seas above 40 m are rejected", FIRST,
     ("water_depth: 40 m", "water_depth: 40 m\n  waves: {type: jonswap, hs: 41 m, tp: 20 s, from: 0 deg}"), CHECK, 2, "hs"),
    ("docs/theory/waves.md", "a regular wave of 0.78 of the depth is rejected", FIRST,
     ("water_depth: 40 m", "water_depth: 40 m\n  waves: {type: airy, height: 35 m, period: 20 s, from: 0 deg}"), CHECK, 2, "height"),
    ("docs/theory/waves.md", "stokes5 is rejected where H L^2/d^3 exceeds 40", FIRST,
     ("water_depth: 40 m", "water_depth: 10 m\n  waves: {type: stokes5, height: 4 m, period: 20 s, from: 0 deg}"), CHECK, 2,
     "H L^2/d^3"),
    ("docs/guide/stinger-motion.md", "a radius in addition to listed boxes is a finding", FIRST,
     ("  stinger:\n    roller: plain\n", "  stinger:\n    roller: plain\n    radius: 100 m\n"), CHECK, 0, "radius"),
]


class Claims(unittest.TestCase):
    pass


def add_claim(number, page, claim, model, change, command, code, expected):
    def test(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(ROOT / "data", pathlib.Path(folder, "data"))
            examples = pathlib.Path(folder, "examples")
            examples.mkdir()
            text = (ROOT / "examples" / model).read_text(encoding="utf-8")
            if isinstance(change, str):
                # A key that the example has already is replaced.
                name = re.match(r"\w+:", change).group()
                text = re.sub(rf"^{name}.*?(?=^\w|\Z)", "", text, flags=re.M | re.S) + "\n" + change
            else:
                changed = re.sub(change[0], change[1], text, count=1)
                self.assertTrue(change[0] == "" or changed != text, f"{change[0]} is not in {model}")
                text = changed
            (examples / "model.yaml").write_text(text, encoding="utf-8")
            arguments = [command[0], *([] if command[0] in ("report", "check-results") else ["model.yaml"]), *command[1:]]
            done = subprocess.run([PROGRAM, *arguments], cwd=examples, capture_output=True, encoding="utf-8",
                                  stdin=subprocess.DEVNULL, env={**os.environ, "OVERBEND_UNITS": "metric"})
            output = done.stdout + done.stderr
            if code is not None:
                self.assertEqual(done.returncode, code, f"{page}: {claim}\n{output[-2000:]}")
            self.assertIn(expected, output, f"{page}: {claim}")

    test.__doc__ = f"{page}: {claim}"
    setattr(Claims, "test_%02d_%s" % (number, re.sub(r"\W+", "_", claim)), test)


for number, claim in enumerate(CLAIMS):
    add_claim(number, *claim)


if __name__ == "__main__":
    unittest.main()
