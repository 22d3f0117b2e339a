"""Uses an installed package as a user does:  wheel_test.py EXAMPLES"""

import pathlib
import sys
import tempfile

import numpy as np

import overbend as ob

examples = pathlib.Path(sys.argv[1])
static = ob.Model.read(examples / "bgl1.yaml").static()
# Lay-back of the example (docs/validation.md): the same on every machine, but for rounding.
assert abs(float(static.lay_back) - 335.614274) < 1e-5, static.lay_back
assert len(static.pipe.effective_tension) > 100
dynamic = ob.Model.read(examples / "bgl1-workable-sea.yaml").dynamic(duration="3 s")
assert np.isfinite(float(dynamic.top_tension.max)), dynamic
try:
    ob.Model.from_text("overbend: 1\npipe: 3\n")
except ob.ModelError as error:
    assert "pipe" in str(error), error
else:
    raise AssertionError("a wrong model was accepted")
with tempfile.TemporaryDirectory() as folder:
    static.save(pathlib.Path(folder, "static"))
    assert pathlib.Path(folder, "static", "report.html").stat().st_size > 100_000
print(f"Python {sys.version.split()[0]}, NumPy {np.__version__}: lay-back {static.lay_back!r} m")
