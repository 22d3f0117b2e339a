"""Operations on the line from Python against those of the command line."""

import pathlib
import tempfile
import unittest

import numpy as np

import overbend as ob
from lays import overbend, small_lay, load_summary, without_times

OPERATION = {"type": "abandonment", "head": {"length": "3 m", "weight_in_air": "20 kN", "weight_submerged": "16 kN"},
             "cable": {"diameter": "76 mm", "weight_in_air": "240 N/m", "weight_submerged": "205 N/m",
                       "axial_stiffness": "2.7e5 kN", "breaking_load": "4200 kN"},
             "stages": [{"name": "at the tensioner", "cable_out": "20 m", "tension": "300 kN"},
                        {"name": "on the ramp", "cable_out": "30 m", "tension": "300 kN"},
                        {"name": "too slack", "cable_out": "35 m", "tension": "15 kN"}]}


class Operations(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.holder.name)
        cls.model = small_lay().with_({"operation": OPERATION})
        cls.model.write(cls.folder / "lay.yaml")
        overbend("static", cls.folder / "lay.yaml", "-o", cls.folder / "there")
        cls.reported = load_summary(cls.folder / "there")
        cls.operation = cls.model.operation()

    @classmethod
    def tearDownClass(cls):
        cls.holder.cleanup()

    def test_the_summary_is_that_of_the_command_line(self):
        self.assertEqual(without_times(self.operation.summary), without_times(self.reported))

    def test_stages_are_found_by_name_and_have_units(self):
        self.assertEqual(self.operation.names, ["at the tensioner", "on the ramp", "too slack"])
        stage = self.operation["on the ramp"]
        self.assertEqual((stage.tension, stage.tension.units), (300e3, "N"))
        self.assertEqual((stage.barge_ahead.units, stage.lay_back.units), ("m", "m"))
        self.assertEqual(stage.lay_back, self.reported["operation"]["stages"][1]["lay_back"])
        self.assertIs(self.operation[1], stage)
        with self.assertRaisesRegex(KeyError, "did you mean 'on the ramp'"):
            self.operation["on the ram"]

    def test_stages_have_their_results_by_object(self):
        stage, reported = self.operation.objects.stages["on the ramp"], self.operation["on the ramp"]
        self.assertEqual((stage.tension, stage.tension.units), (300e3, "N"))
        self.assertEqual(stage.lines["pipe"].static.lay_back, reported.lay_back)
        self.assertEqual(stage.lines["pipe"].static.lay_back.units, "m")
        self.assertEqual([*self.operation.objects.stages], self.operation.names)

    def test_every_stage_has_statics(self):
        static = self.operation["on the ramp"].static
        self.assertEqual(static.lay_back, self.operation["on the ramp"].lay_back)
        self.assertEqual(static.pipe.effective_tension.dims, ("s",))
        self.assertEqual(static.checks.worst.utilisation, self.operation["on the ramp"].checks.worst.utilisation)
        static.save(self.folder / "ramp")
        self.assertEqual(ob.open(self.folder / "ramp").lay_back, static.lay_back)

    def test_a_stage_without_an_equilibrium_says_why(self):
        stage = self.operation["too slack"]
        self.assertFalse(stage.stands)
        with self.assertRaises(ob.NoSolution) as raised:
            stage.static
        self.assertEqual(raised.exception.what, stage.failure.what)

    def test_the_table_has_a_row_for_each_stage(self):
        table = self.operation.table
        self.assertEqual(list(table["name"].values), self.operation.names)
        self.assertEqual(list(table["status"].values), ["converged", "converged", "failed"])
        self.assertEqual(table["cable_out"].attrs["units"], "m")
        self.assertEqual(list(table["cable_out"].values), [20.0, 30.0, 35.0])
        self.assertTrue(np.isnan(table["lay_back"].values[2]))
        self.assertEqual(self.operation.worst.stage, self.reported["checks"]["worst"]["stage"])

    def test_saved_results_are_those_that_are_opened(self):
        self.operation.save(self.folder / "here")
        for folder in ("here", "there"):
            again = ob.open(self.folder / folder)
            self.assertIsInstance(again, ob.OperationResults)
            self.assertEqual(without_times(again.summary), without_times(self.reported))
            self.assertEqual(again[0].static.lay_back, self.operation[0].lay_back)

    def test_progress_counts_the_stages_and_may_end_them(self):
        reported = []
        self.model.operation(progress=lambda *progress_values: reported.append(progress_values))
        self.assertEqual(reported[-1], (3, 3, "too slack"))

        def interrupt(*progress_values):
            raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            self.model.operation(progress=interrupt)

    def test_a_model_without_an_operation_says_so(self):
        with self.assertRaisesRegex(ob.ModelError, "operation.stages"):
            small_lay().operation()


if __name__ == "__main__":
    unittest.main()
