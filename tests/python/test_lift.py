"""Stages of a lift from Python against those of the command line."""

import pathlib
import tempfile
import unittest

import numpy as np

import overbend as ob
from lays import EXAMPLES, overbend, load_summary

MODEL = EXAMPLES / "davit-level.yaml"


class Lift(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.holder.name)
        overbend("static", MODEL, "-o", cls.folder / "there")
        cls.reported = load_summary(cls.folder / "there")["operation"]["stages"]
        cls.operation = ob.Model.read(MODEL).operation()

    @classmethod
    def tearDownClass(cls):
        cls.holder.cleanup()

    def test_lines_and_davits_are_those_of_the_summary_with_units(self):
        stage, reported = self.operation["level"], self.reported[3]
        end, davit = stage.lines["pipe"].first_end, stage.davits["davit 2"]
        self.assertEqual((end.z, end.z.units), (reported["lines"]["pipe"]["first_end"]["z"], "m"))
        self.assertEqual(end.inclination.units, "rad")
        self.assertEqual((davit.tension_upper, davit.tension_upper.units), (reported["davits"]["davit 2"]["tension_upper"], "N"))
        self.assertEqual(davit.force_on_pipe.x.units, "N")
        self.assertEqual(stage.lines["pipe"].largest_bending_moment.value.units, "N m")
        self.assertEqual(stage.lines.keys(), ["pipe"])
        self.assertEqual(stage.davits.keys(), ["davit 1", "davit 2", "davit 3"])
        with self.assertRaisesRegex(KeyError, "did you mean 'davit 1'"):
            stage.davits["davt 1"]
        with self.assertRaisesRegex(KeyError, "there is no 'cable'"):
            stage.lines["cable"]

    def test_shapes_are_arrays_along_the_line(self):
        pipe = self.operation["level"].lines["pipe"]
        nodes = pipe.nodes
        self.assertEqual(nodes.keys()[:4], ["arc_length", "x", "y", "z"])
        self.assertEqual(nodes.z.values[0], pipe.first_end.z)
        self.assertEqual(nodes.z.attrs["units"], "m")
        self.assertAlmostEqual(np.hypot(nodes.sagging_moment.values, nodes.sideways_moment.values).max()
                               / pipe.largest_bending_moment.value, 1.0, places=2)
        length = np.sum(np.sqrt(sum(np.diff(nodes[name].values) ** 2 for name in "xyz")))
        self.assertAlmostEqual(length, 380.0, delta=0.05)  # the pipe's, but for its stretch

    def test_the_table_has_columns_of_lines_and_davits(self):
        table = self.operation.table
        self.assertEqual(table["davit 1.tension_upper"].attrs["units"], "N")
        self.assertEqual([*table["davit 1.tension_upper"].values],
                         [stage["davits"]["davit 1"]["tension_upper"] for stage in self.reported])
        self.assertEqual([*table["pipe.first_end.z"].values],
                         [stage["lines"]["pipe"]["first_end"]["z"] for stage in self.reported])

    def test_stored_stages_have_the_same(self):
        self.operation.save(self.folder / "here")
        for folder in ("here", "there"):
            again = ob.open(self.folder / folder)["level"]
            self.assertEqual(again.lines["pipe"].first_end.z, self.operation["level"].lines["pipe"].first_end.z)
            np.testing.assert_array_equal(again.lines["pipe"].nodes.sagging_moment.values,
                                          self.operation["level"].lines["pipe"].nodes.sagging_moment.values)

    def test_a_stage_has_its_checks_as_statics(self):
        stage = self.operation["level"]
        self.assertEqual(stage.static.checks.worst.utilisation, stage.checks.worst.utilisation)
        self.assertTrue(stage.stands)

    def test_gap_and_weld(self):
        operation = ob.Model.read(EXAMPLES / "davit-lift.yaml").operation()
        gap, join = operation["above the water"].gap, operation["welded"].join
        self.assertEqual((gap.dx.units, gap.angle.units, join.moment.units), ("m", "rad", "N m"))
        self.assertAlmostEqual(join.inclination, 0.0, places=6)  # both ends alike, no kink

    def test_lengths_are_sought(self):
        end = "operation.stages[level].lines.pipe.first_end."
        found = ob.seek(ob.Model.read(MODEL), vary={"operation.stages[level].lengths.davit 1": ("5 m", "9 m"),
                                                    "operation.stages[level].lengths.davit 2": ("6 m", "14 m")},
                        until={end + "z": "2 m", end + "inclination": "3 deg"})
        self.assertIsNone(found.static)
        reached = found.operation["level"].lines["pipe"].first_end
        self.assertAlmostEqual(reached.z, 2.0, places=5)
        self.assertAlmostEqual(np.degrees(reached.inclination), 3.0, places=4)
        self.assertRegex(found.stages[0], r"^- \{name: level, lengths: \{davit 1: ")


if __name__ == "__main__":
    unittest.main()
