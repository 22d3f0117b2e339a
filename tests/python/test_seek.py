"""Goal seek from Python against that of the command line."""

import os
import pathlib
import signal
import tempfile
import threading
import unittest

import numpy as np

import overbend as ob
from lays import EXAMPLES, overbend, small_lay, load_summary, without_times

STRESS = "static.sagbend.max_bending_stress"


class Seek(unittest.TestCase):
    def test_the_answer_is_that_of_the_command_line(self):
        wanted = ("\nseek:\n  vary: {key: tensioner.tension, from: 200 kN, to: 500 kN}\n"
                  f"  until: {{result: {STRESS}, equals: 120 MPa}}\n")
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "lay.yaml")
            file.write_text(small_lay().text + wanted, encoding="utf-8")
            overbend("seek", file, "-o", f"{folder}/sought")
            reported = load_summary(f"{folder}/sought")
        found = ob.seek(small_lay(), vary={"tensioner.tension": ("200 kN", "500 kN")}, until={STRESS: "120 MPa"})
        self.assertEqual(without_times(found.summary), without_times(reported["seek"]))
        self.assertEqual(found.answer, reported["seek"]["answer"])
        self.assertEqual(found.static.lay_back, reported["static"]["lay_back"])

    def test_a_key_without_bounds_is_sought_around_its_value(self):
        found = ob.seek(small_lay(), vary="tensioner.tension", until={STRESS: "120 MPa"})
        self.assertEqual(found.answer.units, "N")
        self.assertEqual(found.keys[0]["from"], 150e3)
        self.assertEqual(found.keys[0].to, 600e3)
        self.assertAlmostEqual(found.static.sagbend.max_bending_stress / 120e6, 1.0, places=6)
        self.assertEqual(found.goals[0].reached.units, "Pa")

    def test_the_model_of_the_answer_is_the_model_with_the_value_put_in(self):
        model = small_lay()
        found = ob.seek(model, vary="tensioner.tension", until={STRESS: "120 MPa"})
        self.assertEqual(model.get("tensioner.tension"), "300 kN")
        self.assertNotIn("seek", found.model.to_dict())
        value, unit = found.model.get("tensioner.tension").split()
        self.assertEqual(unit, "kN")
        self.assertAlmostEqual(float(value), found.answer / 1e3, places=5)
        self.assertAlmostEqual(found.model.static().sagbend.max_bending_stress / 120e6, 1.0, places=3)

    def test_limits_and_what_is_minimised(self):
        most = ob.seek(small_lay(), vary="tensioner.tension", until={STRESS: "<= 120 MPa"},
                       minimise="static.top_tension")
        same = ob.seek(small_lay(), vary="tensioner.tension", until={STRESS: {"at_most": "120 MPa"}})
        self.assertAlmostEqual(most.answer / same.answer, 1.0, places=3)
        self.assertEqual([goal["is"] for goal in most.goals], ["at_most", "minimised"])

    def test_several_keys_have_an_answer_each(self):
        box = "supports.stinger.boxes[1].z"
        wanted = small_lay().with_({"tensioner.tension": "330 kN", box: "-7.17 m"}).static()
        stress, reaction = wanted.sagbend.max_bending_stress, wanted.supports["stinger 2"].reaction
        found = ob.seek(small_lay(), vary={"tensioner.tension": ("250 kN", "400 kN"), box: {"within": "0.1 m"}},
                        until={STRESS: stress, "static.supports[4].reaction": reaction})
        self.assertEqual(found.answer.keys(), ["tensioner.tension", box])
        self.assertAlmostEqual(found.answer["tensioner.tension"] / 330e3, 1.0, places=2)
        self.assertAlmostEqual(found.static.supports["stinger 2"].reaction / reaction, 1.0, places=3)

    def test_the_path_has_every_model_that_was_solved(self):
        found = ob.seek(small_lay(), vary="tensioner.tension", until={STRESS: "120 MPa"})
        self.assertEqual(len(found.path), found.evaluations)
        self.assertEqual(found.path["tensioner.tension"].attrs["units"], "N")
        nearest = np.nanargmin(abs(found.path[STRESS].values - 120e6))
        self.assertAlmostEqual(found.path["tensioner.tension"].values[nearest], found.answer, delta=1.0)

    def test_without_an_answer_what_is_reached_is_reported(self):
        with self.assertRaises(ob.NoSolution) as raised:
            ob.seek(small_lay(), vary={"tensioner.tension": ("280 kN", "320 kN")}, until={STRESS: "20 MPa"})
        self.assertIn("MPa", raised.exception.why)
        self.assertFalse(raised.exception.results.found)
        self.assertIsNone(raised.exception.results.answer)
        self.assertGreater(len(raised.exception.results.path), 5)

    def test_a_result_found_before_is_a_value(self):
        lay_back = small_lay().with_({"tensioner.tension": "350 kN"}).static().lay_back
        found = ob.seek(small_lay(), vary="tensioner.tension", until={"static.lay_back": lay_back})
        self.assertAlmostEqual(found.answer / 350e3, 1.0, places=4)

    def test_errors_name_the_key_and_what_is_expected(self):
        with self.assertRaises(ob.ModelError) as raised:
            ob.seek(small_lay(), vary="tensioner.tensio", until={STRESS: "120 kN"})
        keys = [error.key for error in raised.exception.faults]
        self.assertTrue(any("vary" in key for key in keys) and any("until" in key for key in keys), keys)
        self.assertNotIn("first-model.yaml", str(raised.exception))
        with self.assertRaisesRegex(ob.ModelError, "did you mean 'static.lay_back'"):
            ob.seek(small_lay(), vary="tensioner.tension", until={"static.layback": "90 m"})
        with self.assertRaisesRegex(ob.ModelError, "from and to, or within"):
            ob.seek(small_lay(), vary="rollers.plain.friction.axial", until={"static.lay_back": "90 m"})
        with self.assertRaisesRegex(ob.ModelError, "expected the key"):
            ob.seek(small_lay(), until={"static.lay_back": "90 m"})

    def test_a_model_may_say_itself_what_is_sought(self):
        wanted = {"vary": {"key": "tensioner.tension", "from": "200 kN", "to": "500 kN"},
                  "until": {"result": STRESS, "equals": "120 MPa"}}
        found = ob.seek(small_lay().with_({"seek": wanted}))
        self.assertAlmostEqual(found.static.sagbend.max_bending_stress / 120e6, 1.0, places=6)
        with self.assertRaisesRegex(ob.ModelError, "no key seek"):
            ob.seek(small_lay())

    def test_the_files_are_those_of_the_command(self):
        found = ob.seek(small_lay(), vary="tensioner.tension", until={STRESS: "120 MPa"})
        with tempfile.TemporaryDirectory() as folder:
            found.save(pathlib.Path(folder, "sought"))
            self.assertEqual(load_summary(f"{folder}/sought")["seek"]["answer"], found.answer)
            self.assertEqual(ob.open(f"{folder}/sought").lay_back, found.static.lay_back)
            again = ob.Model.read(f"{folder}/sought/model.yaml").static()
            self.assertAlmostEqual(again.lay_back, found.static.lay_back, places=3)

    def test_ctrl_c_ends_a_long_search(self):
        model = ob.Model.read(EXAMPLES / "bgl1-stinger-setting.yaml")
        timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            ob.seek(model)
        timer.join()


if __name__ == "__main__":
    unittest.main()
