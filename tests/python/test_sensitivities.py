"""Sensitivities of results, from Python against the command line."""

import tempfile
import unittest

import overbend as ob
from lays import EXAMPLES, overbend, small_lay, load_summary, without_times


class Sensitivities(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.found = small_lay().sensitivities()

    def test_derivatives_are_those_of_the_command_line(self):
        with tempfile.TemporaryDirectory() as folder:
            overbend("static", EXAMPLES / "first-model.yaml", "--sensitivities", "-o", f"{folder}/first")
            reported = load_summary(f"{folder}/first")["sensitivities"]
        summary_here = {key: value for key, value in self.found.summary.items() if key != "effects"}
        self.assertEqual(without_times(summary_here), without_times(reported))

    def test_a_derivative_is_what_a_small_change_gives(self):
        slope = self.found.derivative("static.lay_back", "tensioner.tension")
        self.assertEqual(slope.units, "m/N")
        ends = [small_lay().with_({"tensioner.tension": tension}).static().lay_back
                for tension in ("299.5 kN", "300.5 kN")]
        self.assertAlmostEqual((ends[1] - ends[0]) / 1e3 / slope, 1.0, delta=0.02)

    def test_arrays_have_a_row_for_each_result(self):
        array = self.found.derivatives
        self.assertEqual(array.dims, ("result", "input"))
        self.assertEqual(float(array.sel(result="static.lay_back", input="tensioner.tension")),
                         float(self.found.derivative("static.lay_back", "tensioner.tension")))
        self.assertEqual(array.shape, (len(self.found.results), len(self.found.inputs)))

    def test_the_foremost_inputs_move_a_result_most(self):
        foremost = self.found.foremost("static.lay_back", 4)
        effects = [effect for _, effect in foremost]
        self.assertEqual(effects, sorted(effects, reverse=True))
        self.assertEqual(effects[0], self.found.effects.sel(result="static.lay_back").values.max())
        self.assertEqual(effects[0].units, "m")
        row = self.found.inputs[foremost[0][0]]
        self.assertGreater(row.tolerance, 0.0)

    def test_keys_may_be_chosen(self):
        few = small_lay().sensitivities(["tensioner.tension", "supports.stinger.boxes[stinger 3].z"])
        self.assertEqual(few.inputs.names(), ["tensioner.tension", "supports.stinger.boxes[stinger 3].z"])
        self.assertEqual(few.inputs[0].value.units, "N")

    def test_names_that_are_none_are_rejected(self):
        with self.assertRaisesRegex(KeyError, "did you mean 'static.lay_back'"):
            self.found.derivative("static.layback", "tensioner.tension")
        with self.assertRaises(ob.ModelError):
            small_lay().sensitivities(["tensioner.tensio"])


if __name__ == "__main__":
    unittest.main()
