"""Statics from Python against those of the command line."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

import overbend as ob

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ["OVERBEND_PROGRAM"]
BGL1 = ROOT / "examples" / "bgl1.yaml"


def load_summary(folder):
    return json.loads(pathlib.Path(folder, "summary.json").read_text(encoding="utf-8"))


def without_times(value):
    """A summary without what differs from run to run."""
    if isinstance(value, dict):
        return {key: without_times(item) for key, item in value.items() if key not in ("wall_time", "history")}
    return [without_times(item) for item in value] if isinstance(value, list) else value


class Statics(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.holder.name, "bgl1")
        subprocess.run([PROGRAM, "static", str(BGL1), "-o", str(cls.folder)], check=True, capture_output=True)
        cls.reported = load_summary(cls.folder)
        cls.static_model = ob.Model.read(BGL1)
        cls.static = cls.static_model.static()

    @classmethod
    def tearDownClass(cls):
        cls.holder.cleanup()

    def test_the_summary_is_that_of_the_command_line(self):
        self.assertEqual(without_times(self.static.summary), without_times(self.reported))

    def test_key_results_are_attributes_with_units(self):
        self.assertEqual(self.static.lay_back, self.reported["static"]["lay_back"])
        self.assertEqual(self.static.lay_back.units, "m")
        self.assertIn("stern shoe", self.static.lay_back.description)
        self.assertEqual(self.static.sagbend.max_bending_stress, self.reported["static"]["sagbend"]["max_bending_stress"])
        self.assertEqual(self.static.sagbend.max_bending_stress.units, "Pa")
        self.assertEqual(self.static.touchdown.x.units, "m")
        self.assertEqual(str(self.static.lay_back), str(float(self.static.lay_back)))

    def test_tables_have_their_columns_in_the_order_of_the_tables_of_text(self):
        heading = pathlib.Path(self.folder, "pipe.csv").read_text(encoding="utf-8").splitlines()[0].split(",")
        shared = {"s [m]": "s", "x [m]": "x", "z [m]": "z", "tension [kN]": "effective_tension",
                  "bending moment [kN m]": "bending_moment", "curvature [1/m]": "curvature",
                  "bending stress [MPa]": "bending_stress", "von Mises stress [MPa]": "von_mises", "strain [%]": "strain",
                  "inclination [deg]": "inclination", "wall tension [kN]": "wall_tension", "region": "region"}
        expected = [shared[name] for name in heading if name in shared]
        self.assertEqual(len(expected), len(shared))
        for static in (self.static, ob.open(self.folder)):
            self.assertEqual([name for name in static.pipe.keys() if name in shared.values()], expected)

    def test_a_table_becomes_a_frame_with_units(self):
        pandas = self.pandas()
        frame = self.static.pipe.to_pandas()
        self.assertIsInstance(frame, pandas.DataFrame)
        self.assertEqual(list(frame.columns), self.static.pipe.keys()[1:])
        self.assertEqual(frame.attrs["units"]["effective_tension"], "N")
        self.assertEqual(frame.attrs["units"]["s"], "m")
        self.assertIn("tension", frame.attrs["descriptions"]["effective_tension"].lower())
        boxes = self.static.supports.to_pandas()
        self.assertEqual(boxes.loc[boxes["name"] == "ramp 1", "reaction"].item(), self.static.supports["ramp 1"].reaction)

    def test_checks_become_a_frame_in_the_order_of_their_table(self):
        pandas = self.pandas()
        frame = self.static.checks.to_pandas()
        table = pandas.read_csv(pathlib.Path(self.folder, "checks.csv"))
        names = {"check": "name", "reserve factor": "reserve", "from tensioner [m]": "from_top", "s [m]": "s", "x [m]": "x",
                 "y [m]": "y", "z [m]": "z", "time [s]": "time"}
        self.assertEqual([name for name in frame.columns if name != "id"], [names.get(name, name) for name in table.columns])
        self.assertEqual(list(frame["name"]), list(table["check"]))
        np.testing.assert_allclose(frame["utilisation"].astype(float), table["utilisation"], rtol=1e-9)
        np.testing.assert_allclose(frame["x"].astype(float), table["x [m]"], rtol=1e-9)
        self.assertEqual(frame.attrs["units"]["x"], "m")
        self.assertEqual(frame["inputs"][0].split("=")[0], table["inputs"][0].split("=")[0])

    def test_the_radius_of_a_listed_stinger_is_a_result_and_no_key(self):
        first = ob.Model.read(ROOT / "examples" / "first-model.yaml").static()  # boxes on an arc of 150 m, to a centimetre
        self.assertAlmostEqual(first.stinger_fitted_radius, 150.0, delta=3.0)
        self.assertEqual(self.static.stinger_fitted_radius.units, "m")
        reported = ob.Model.read(BGL1).with_({"supports.stinger.radius": "120 m"}).findings
        self.assertEqual([row.object for row in reported if "not used for listed boxes" in row.message], ["supports.stinger.radius"])

    def pandas(self):
        try:
            import pandas
        except ImportError:
            self.skipTest("pandas is not installed")
        return pandas

    def test_the_pipe_is_a_table_over_its_arc_length(self):
        pipe = self.static.pipe
        self.assertEqual(pipe.effective_tension.shape, (len(pipe),))
        self.assertEqual(pipe.effective_tension.attrs["units"], "N")
        self.assertEqual(pipe.effective_tension.dims, ("s",))
        self.assertEqual(float(pipe.effective_tension.values[-1]), self.static.top_tension)
        self.assertTrue(np.all(np.diff(pipe.s.values) > 0.0))
        self.assertEqual(pipe["bending_moment"].values.tolist(), pipe.bending_moment.values.tolist())

    def test_arrays_are_not_copied_and_cannot_be_written(self):
        first, again = self.static.pipe.z.values, self.static.pipe.z.values
        self.assertTrue(np.shares_memory(first, again))
        with self.assertRaises(ValueError):
            first[0] = 1.0

    def test_arrays_outlive_the_results_that_they_are_of(self):
        array = ob.Model.read(ROOT / "examples" / "first-model.yaml").static().pipe.z
        self.assertTrue(np.all(np.isfinite(array.values)))

    def test_supports_are_found_by_name(self):
        reported = self.reported["static"]["supports"]
        for box in reported:
            self.assertEqual(self.static.supports[box["name"]].reaction, box["reaction"])
        self.assertEqual(self.static.supports.reaction.values.tolist(), [box["reaction"] for box in reported])
        self.assertEqual(self.static.supports[0].reaction.units, "N")
        with self.assertRaises(KeyError) as caught:
            self.static.supports[reported[0]["name"] + "x"]
        self.assertIn(reported[0]["name"], str(caught.exception))

    def test_results_are_found_by_the_names_of_goal_seek(self):
        reported = self.reported["static"]["supports"]
        names = [box["name"] for box in reported if box["name"].startswith("stinger")]
        reactions = self.static["static.supports[stinger *].reaction"]
        self.assertEqual(reactions.tolist(), [box["reaction"] for box in reported if box["name"] in names])
        self.assertEqual(self.static["max(static.supports[stinger *].reaction)"], max(reactions))
        self.assertEqual(self.static["static.sagbend.max_bending_stress"], self.static.sagbend.max_bending_stress)
        with self.assertRaises(KeyError):
            self.static["static.sagbend.max_bending_stres"]

    def test_results_are_found_by_object(self):
        objects = self.static.objects
        self.assertEqual(objects.keys(), list(self.reported["objects"]))
        self.assertEqual(objects.lines.keys(), ["pipe"])
        self.assertEqual(objects.lines["pipe"].static.lay_back, self.static.lay_back)
        self.assertEqual(objects.lines["pipe"].static.lay_back.units, "m")
        self.assertEqual(objects.lines["pipe"].static.lay_back.description, self.static.lay_back.description)
        self.assertEqual(objects.supports["stinger 3"].static.reaction, self.static.supports["stinger 3"].reaction)
        self.assertEqual(objects.supports["stinger 3"].static.reaction.units, "N")
        self.assertEqual(objects.run.static.balance.force_residual.units, "1")
        with self.assertRaisesRegex(KeyError, "did you mean 'stinger 3'"):
            objects.supports["stingr 3"]
        self.assertEqual(self.static["lines[pipe].static.lay_back"], self.static.lay_back)
        self.assertEqual(self.static["lines[pipe].static.lay_back"].units, "m")

    def test_results_of_an_earlier_version_say_that_they_have_no_objects(self):
        with tempfile.TemporaryDirectory() as folder:
            old = {key: value for key, value in self.reported.items() if key != "objects"}
            pathlib.Path(folder, "summary.json").write_text(json.dumps(old), encoding="utf-8")
            with self.assertRaisesRegex(ob.ResultsError, "earlier version"):
                ob.open(folder).objects

    def test_an_unknown_name_says_what_might_be_meant(self):
        with self.assertRaises(AttributeError) as caught:
            self.static.layback
        self.assertIn("lay_back", str(caught.exception))

    def test_the_calculation_sheet_of_a_check_ends_with_its_utilisation(self):
        sheet = self.static.checks.worst.sheet
        self.assertEqual(sheet[-1].symbol, "U")
        self.assertEqual(sheet[-1].value, self.static.checks.worst.utilisation)
        self.assertTrue(all(line.origin or line.formula for line in sheet))

    def test_checks_have_the_governing_one(self):
        self.assertEqual(self.static.checks.worst.utilisation, self.reported["checks"]["worst"]["utilisation"])
        self.assertEqual(len(self.static.checks), len(self.reported["checks"]["list"]))
        self.assertEqual(self.static.checks.passed, not self.static.checks.exceeded)

    def test_findings_are_records_and_the_verdict_is_that_of_the_files(self):
        self.assertEqual(self.static.verdict, self.reported["verdict"]["kind"])
        self.assertEqual(self.static.warnings, [finding.message for finding in self.static.findings])
        first = self.static.findings[0]
        self.assertEqual((first.code, first.severity, first.object), ("pipe-at-roller-end", "caution", "stinger 8"))
        self.assertEqual((first.numbers[0].name, first.numbers[0].unit), ("distance", "m"))
        self.assertIn("[pipe-at-roller-end]", str(first))
        across = ob.Model.read(BGL1).with_({"tensioner.tension": "300 kN"}).static()
        self.assertEqual(across.verdict, "reserved")
        self.assertIn("pipe-off-rollers", [row.code for row in across.findings if row.severity == "serious"])

    def test_without_xarray_arrays_are_numpy_with_the_same_labels(self):
        ob.use_xarray(False)
        try:
            plain = ob.Model.read(BGL1).static().pipe.effective_tension
        finally:
            ob.use_xarray(True)
        self.assertIsInstance(plain, ob.LabelledArray)
        self.assertEqual(plain.attrs["units"], "N")
        self.assertEqual(plain.values.tolist(), self.static.pipe.effective_tension.values.tolist())
        self.assertEqual(plain.coords["s"].tolist(), self.static.pipe.s.values.tolist())
        self.assertIsInstance(plain / 1e3, np.ndarray)
        self.assertEqual(float(plain.max()), float(plain.values.max()))

    def test_what_is_saved_is_what_the_command_line_writes(self):
        with tempfile.TemporaryDirectory() as folder:
            saved = self.static.save(pathlib.Path(folder, "results"))
            self.assertEqual(without_times(load_summary(saved)), without_times(self.reported))
            self.assertEqual(pathlib.Path(saved, "pipe.csv").read_bytes(), (self.folder / "pipe.csv").read_bytes())
            self.assertTrue((saved / "report.html").is_file())

    def test_a_folder_of_results_opens_to_the_same(self):
        opened = ob.open(self.folder)
        self.assertIsInstance(opened, ob.StaticResults)
        self.assertEqual(opened.lay_back, self.static.lay_back)
        for name in self.static.pipe.keys():
            ours, stored = self.static.pipe[name], opened.pipe[name]
            np.testing.assert_array_equal(ours.values, stored.values)
            self.assertEqual(ours.attrs, stored.attrs)
        self.assertEqual(opened.model.text, BGL1.read_text(encoding="utf-8"))

    def test_a_lay_started_from_one_close_by_is_the_same_lay(self):
        model = ob.Model.read(ROOT / "examples" / "first-model.yaml")
        start = model.static()
        closer = model.with_({"tensioner.tension": "310 kN"})
        self.assertAlmostEqual(closer.static(start=start).lay_back / closer.static().lay_back, 1.0, places=4)

    def test_a_lay_across_a_current_that_was_started_from_another_says_so(self):
        across = self.static.model.with_({"tensioner.tension": "252 kN"})
        self.assertTrue(any("found from the given start" in warning for warning in across.static(start=self.static).warnings))
        self.assertFalse(any("found from the given start" in warning for warning in across.static().warnings))

    def test_where_there_is_no_equilibrium_the_reason_is_reported(self):
        with self.assertRaises(ob.NoSolution) as caught:
            ob.Model.read(ROOT / "examples" / "first-model.yaml").with_({"tensioner.tension": "1 kN"}).static()
        self.assertTrue(caught.exception.why)
        self.assertIn(caught.exception.what, str(caught.exception))

    def test_a_table_of_what_is_not_there_is_empty(self):
        tower = ob.Model.read(ROOT / "validation" / "static_cases" / "J12-D400-T560.yaml").static()
        self.assertEqual(len(tower.supports), 0)
        self.assertEqual(list(tower.supports), [])
        self.assertNotIn("supports", dir(tower.pipe))
        with self.assertRaises(KeyError):
            tower.supports["ramp 1"]

    def test_a_folder_without_results_is_an_error(self):
        with tempfile.TemporaryDirectory() as folder, self.assertRaises(ob.ResultsError):
            ob.open(folder)

    def test_moored_barges_and_lines_by_themselves_have_results_too(self):
        moored = ob.Model.read(ROOT / "examples" / "moored-barge.yaml").static()
        self.assertTrue(len(moored.moorings) >= 3)
        self.assertGreater(moored.moorings[0].fairlead_tension, 0.0)
        first = moored.objects.lines[moored.moorings[0].name]
        self.assertEqual((first.kind, first.static.fairlead_tension), ("mooring", moored.moorings[0].fairlead_tension))
        self.assertEqual((first.static.fairlead_tension.units, moored.objects.bodies["vessel"].static.surge.units), ("N", "m"))
        lines = ob.Model.read(ROOT / "examples" / "jumper.yaml").static()
        self.assertTrue(lines.lines[0].first)
        name = lines.lines[0].name
        self.assertEqual(lines.objects.lines[name].static.largest_tension, lines.lines[0].largest_tension)
        self.assertEqual(lines.objects.lines[name].static.largest_tension.units, "N")


if __name__ == "__main__":
    unittest.main()
