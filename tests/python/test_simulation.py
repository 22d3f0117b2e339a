"""Simulations step by step, and controllers of tensioner and winches, from Python."""

import ctypes
import math
import os
import pathlib
import pickle
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy as np

import overbend as ob

ROOT = pathlib.Path(__file__).resolve().parents[2]
WAVES = ROOT / "examples" / "bgl1-workable-sea.yaml"
MOORED = ROOT / "examples" / "bgl1-moored.yaml"
COARSE = {"analysis.mesh": {"overbend_element": "1 m", "touchdown_element": "3 m", "longest_element": "8 m"}}

SOURCE = """
#include <overbend_controller.h>
/* Pays out by the tension; counts in its memory how often it was asked. */
int law(const struct overbend_reading *seen, double *command, double *memory) {
  memory[1] += 1.0;
  *command = memory[0] * (seen->tension - 250e3);
  return seen->time > memory[2] ? 7 : OVERBEND_SPEED;
}
"""

INTERRUPTED = """
import sys, overbend as ob
sim = ob.Model.read(sys.argv[1]).simulation(duration='3000 s', controllers={'tensioner': lambda t, seen: None})
print('begun', flush=True)
try:
    sim.advance(3000)
except KeyboardInterrupt:
    at = float(sim.time)
    sim.advance(at + 0.5)
    print('went on', sim.time >= at + 0.5)
"""


def sea_model(**keys):
    """BGL-1 in a sea that a barge works in, coarse, for 4 s after a build-up of 2 s."""
    return ob.Model.read(WAVES).with_({**COARSE, "analysis.dynamic.build_up": "2 s", "analysis.dynamic.duration": "4 s",
                                       "environment.waves.components": 40, "tensioner.mode": "controlled",
                                       "tensioner.range": ["240 kN", "260 kN"],
                                       **keys})


def calm_model():
    """On calm water, the barge held in its place."""
    return sea_model(**{"environment.waves": {"type": "none"}, "vessel.motion": "fixed"})


class Steps(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.model = sea_model()

    def test_a_simulation_goes_from_the_build_up_to_the_end(self):
        sim = self.model.simulation()
        self.assertEqual((sim.time, sim.end, sim.finished), (-2.0, 4.0, False))
        self.assertEqual(sim.time.units, "s")
        self.assertTrue(sim.step())
        self.assertGreater(sim.time, -2.0)
        sim.advance(sim.next_row)
        self.assertEqual(sim.time, -1.5)
        sim.advance("1 s")
        self.assertEqual(sim.time, 1.0)
        sim.advance(1e9)
        self.assertEqual((sim.time, sim.finished, sim.step()), (4.0, True, False))
        self.assertGreater(sim.steps, 50)
        self.assertGreater(sim.wall_time, 0.0)

    def test_it_is_the_run_that_dynamic_makes(self):
        run = self.model.dynamic(seed=3)
        sim = self.model.simulation(seed=3)
        tension = run.history("top_tension")
        for time, value in zip(run.time[1:], tension.values[1:]):
            sim.advance(time)
            self.assertEqual(sim.time, time)
            self.assertAlmostEqual(sim.state.effective_tension.values[-1], value, delta=1e-6 * value)
            self.assertAlmostEqual(sim.tension, value, delta=1e-4 * value)
        self.assertLess(abs(sim.energy.error), 1e-2 * sim.energy.throughput)

    def test_the_state_has_labels_units_and_frames(self):
        sim = self.model.simulation()
        sim.advance(0.0)
        state = sim.state
        self.assertEqual(state.position.shape, (len(state.s), 3))
        self.assertEqual(state.position.dims, ("s", "axis"))
        self.assertEqual(state.position.attrs["units"], "m")
        self.assertEqual(state.position.attrs["frame"], "W")
        self.assertEqual(state.effective_tension.dims, ("s",))
        np.testing.assert_array_equal(state.effective_tension.coords["s"], state.s)
        self.assertFalse(state.position.values.flags.writeable)
        self.assertTrue(np.all(np.diff(state.s.values) > 0.0))
        length = np.linalg.norm(np.diff(state.position.values, axis=0), axis=1).sum()
        self.assertAlmostEqual(length, state.s.values[-1] - state.s.values[0], delta=1e-3 * length)
        kept = state.velocity.values.copy()
        sim.advance(1.0)
        np.testing.assert_array_equal(state.velocity.values, kept)  # the state of before stays
        self.assertGreater(np.abs(sim.state.velocity.values - kept).max(), 1e-3)
        with self.assertRaises(AttributeError) as caught:
            state.effective_tensoin
        self.assertIn("effective_tension", str(caught.exception))

    def test_supports_rollers_and_vessel_can_be_read(self):
        static = self.model.static()
        sim = self.model.simulation()
        self.assertEqual(list(sim.reactions.coords["support"]), [support.name for support in static.supports])
        for name in ("ramp 2", "stinger 3"):
            support_index = list(sim.reactions.coords["support"]).index(name)
            self.assertAlmostEqual(sim.reactions.values[support_index], static.supports[name].reaction,
                                   delta=0.02 * static.supports[name].reaction)
            forces = sim.rollers.values[[str(label).startswith(name + "/") for label in sim.rollers.coords["roller"].values]]
            self.assertGreater(forces.sum(), 0.9 * sim.reactions.values[support_index])
            self.assertAlmostEqual(np.linalg.norm(sim.reaction_forces.values[support_index]), sim.reactions.values[support_index], delta=1e-6)
        sim.advance(2.0)
        self.assertEqual(sim.vessel.heave.units, "m")
        self.assertNotEqual(sim.vessel.heave, 0.0)
        self.assertEqual(len(sim.vessel.axes), 3)

    def test_a_state_that_was_saved_can_be_gone_back_to_and_pickled(self):
        sim = self.model.simulation()
        sim.advance(1.0)
        saved = sim.save()
        self.assertEqual(saved.time, 1.0)
        sim.advance(3.0)
        position_before = sim.state.position.values
        sim.restore(pickle.loads(pickle.dumps(saved)))
        self.assertEqual(sim.time, 1.0)
        sim.advance(3.0)
        np.testing.assert_array_equal(sim.state.position.values, position_before)
        with self.assertRaises(ob.ModelError):
            self.model.simulation(seed=7).restore(saved)

    def test_other_threads_go_on_and_cannot_disturb_it(self):
        sim = self.model.simulation()
        errors = []

        def disturb():
            try:
                while True:
                    sim.time
            except RuntimeError as failure:
                errors.append(str(failure))

        thread = threading.Thread(target=disturb)
        thread.start()
        sim.advance(4.0)
        thread.join(10.0)
        self.assertEqual(errors, ["the simulation is being advanced by another thread"])

    def test_ctrl_c_ends_an_advance_between_two_steps(self):
        child = subprocess.Popen([sys.executable, "-c", INTERRUPTED, str(WAVES)], stdout=subprocess.PIPE, encoding="utf-8")
        self.assertEqual(child.stdout.readline(), "begun\n")
        threading.Event().wait(0.5)
        child.send_signal(signal.SIGINT)
        out, _ = child.communicate(timeout=60)
        self.assertEqual(out, "went on True\n")


class Controllers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.model = sea_model()
        cls.calm = calm_model()

    def test_a_function_is_asked_for_its_interval_and_sees_the_machine(self):
        seen = []
        sim = self.model.simulation(controllers={"tensioner": lambda t, observed: seen.append((t, observed))}, interval=0.2)
        sim.advance(4.0)
        np.testing.assert_allclose([t for t, _ in seen], np.arange(-2.0, 3.9, 0.2), atol=1e-12)
        observed = seen[-1][1]
        self.assertEqual(observed.time, seen[-1][0])
        self.assertGreater(observed.tension, 100e3)
        self.assertEqual(observed.set_tension, 250e3)
        self.assertEqual(observed.vessel.shape, (6,))
        self.assertEqual(observed.vessel_velocity.shape, (6,))

    def test_a_speed_is_paid_out(self):
        sim = self.calm.simulation(controllers={"tensioner": lambda t, seen: 0.1 if t > -1e-9 else 0.0})
        sim.advance(2.0)
        # 0.25 m/s in half a second: 0.1 m/s after 0.2 s
        self.assertAlmostEqual(sim.travel, 0.1 * (2.0 - 0.1), delta=1e-12)
        self.assertAlmostEqual(sim.tensioner.speed, 0.1, delta=1e-15)
        self.assertEqual(sim.tensioner.commanded_speed, 0.1)
        self.assertEqual(sim.tensioner.state, "pay_out")
        self.assertEqual(len(sim.assumptions), 1)

    def test_commands_between_steps_need_no_controller(self):
        sim = self.calm.simulation()
        sim.advance(0.0)
        sim.command("tensioner", 0.1)
        sim.advance(1.0)
        self.assertAlmostEqual(sim.travel, 0.1 * (1.0 - 0.1), delta=1e-12)
        sim.command("tensioner", None)
        self.assertIsNone(sim.tensioner.commanded_speed)
        sim.set_tension("245 kN")
        self.assertEqual(sim.tensioner.set_tension, 245e3)
        sim.command("tensioner", ob.SetTension(246e3))
        self.assertEqual(sim.tensioner.set_tension, 246e3)
        with self.assertRaises(ob.ModelError) as caught:
            sim.command("bow", 0.1)
        self.assertIn("'bow' takes no commands", str(caught.exception))

    def test_answers_that_are_none_are_reported(self):
        for answer, message in (("fast", "found 'fast', expected a speed"), (True, "found True"),
                              (math.nan, "is not a number"), (ob.SetTension(-1), "not a positive number")):
            sim = self.model.simulation(controllers={"tensioner": lambda t, seen, it=answer: it})
            with self.assertRaises(ob.ControllerError) as caught:
                sim.step()
            self.assertIn(message, str(caught.exception))
            self.assertEqual(caught.exception.what, "the controller of the tensioner failed")
            self.assertEqual(caught.exception.where, "at t = -2 s")

    def test_what_a_function_raises_comes_out_with_its_place(self):
        def law(t, seen):
            return 1.0 / (0.0 if t > 0.95 else math.inf)

        sim = self.model.simulation(controllers={"tensioner": law})
        with self.assertRaises(ZeroDivisionError) as caught:
            sim.advance(4.0)
        self.assertIn("the controller of the tensioner failed (at t = 1 s)", caught.exception.__notes__[0])
        self.assertAlmostEqual(sim.time, 1.0, delta=1e-12)
        with tempfile.TemporaryDirectory() as folder, self.assertRaises(ZeroDivisionError) as caught:
            self.model.dynamic(controllers={"tensioner": law}, out=pathlib.Path(folder, "run"))
        self.assertIn("the controller of the tensioner failed", caught.exception.__notes__[0])

    def test_a_controller_cannot_advance_what_asks_it_but_look_at_it(self):
        looks = []

        def law(t, seen):
            looks.append(float(sim.travel))
            sim.advance(t + 1.0)

        sim = self.model.simulation(controllers={"tensioner": law})
        with self.assertRaises(RuntimeError) as caught:
            sim.step()
        self.assertIn("a controller or another thread cannot advance it", str(caught.exception))
        self.assertEqual(looks, [0.0])

    def test_a_run_with_a_controller_says_so_and_keeps_what_it_did(self):
        with tempfile.TemporaryDirectory() as folder:
            run = self.model.dynamic(controllers={"tensioner": lambda t, seen: 1e-6 * (seen.tension - 250e3)},
                                     out=pathlib.Path(folder, "run"))
            self.assertTrue(any("An external controller, called every 0.1 s" in message for message in run.assumptions))
            speed, asked = run.history("tensioner/speed").values, run.history("tensioner/commanded_speed").values
            self.assertGreater(np.abs(speed).max(), 1e-3)
            self.assertLess(np.abs(asked - speed).max(), 0.06)  # within 0.1 s of 0.5 m/s2
            self.assertGreater(np.ptp(run.history("tensioner/travel").values), 1e-3)

    def test_a_run_that_was_begun_with_a_controller_is_not_gone_on_with_without_it(self):
        class Counting:
            def __init__(self, most=10**9):
                self.count, self.most = 0, most

            def __call__(self, t, seen):
                self.count += 1
                if self.count > self.most:
                    os.kill(os.getpid(), signal.SIGINT)
                    self.most = 10**9
                return 1e-6 * (seen.tension - 250e3)

            def save(self):
                return [self.count]

            def restore(self, numbers):
                self.count = int(numbers[0])

        longer = self.model.with_({"analysis.dynamic.duration": "12 s"})
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder, "run")
            with self.assertRaises(ob.Interrupted):
                longer.dynamic(controllers={"tensioner": Counting(25)}, out=out, checkpoint=0.0)
            with self.assertRaises(ob.OverbendError):
                longer.dynamic(out=out, resume=True)
            again = Counting()
            run = longer.dynamic(controllers={"tensioner": again}, out=out, resume=True)
            self.assertEqual(again.count, 140)  # of both parts: every 0.1 s from -2 to 12 s
            whole = longer.dynamic(controllers={"tensioner": Counting()})
            np.testing.assert_array_equal(run.history("top_tension").values, whole.history("top_tension").values)

    def test_machines_that_are_not_there_are_reported(self):
        with self.assertRaises(ob.ModelError) as caught:
            self.model.simulation(controllers={"bow": lambda t, seen: None})
        self.assertIn("there is no machine 'bow'", str(caught.exception))
        with self.assertRaises(TypeError):
            ob.Controller("fast")
        with self.assertRaises(TypeError):
            ob.Controller(lambda t, seen: None, memory=[1.0])


@unittest.skipUnless(shutil.which("cc"), "a C compiler")
class Compiled(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        source = pathlib.Path(cls.holder.name, "law.c")
        source.write_text(SOURCE, encoding="utf-8")
        library = source.with_suffix(".so")
        subprocess.run(["cc", "-shared", "-fPIC", "-Wall", "-Werror", "-O1", f"-I{ob.get_include()}", str(source), "-o",
                        str(library)], check=True)
        cls.law = ctypes.CDLL(str(library)).law
        cls.model = sea_model()

    @classmethod
    def tearDownClass(cls):
        cls.holder.cleanup()

    def test_a_compiled_controller_does_what_the_same_law_in_python_does(self):
        compiled = ob.Controller(self.law, memory=[1e-6, 0.0, 1e9])
        first = self.model.simulation(controllers={"tensioner": compiled})
        second = self.model.simulation(controllers={"tensioner": lambda t, seen: 1e-6 * (seen.tension - 250e3)})
        first.advance(4.0)
        second.advance(4.0)
        np.testing.assert_array_equal(first.state.position.values, second.state.position.values)
        self.assertNotEqual(first.travel, 0.0)
        self.assertEqual(compiled.memory, [1e-6, 60.0, 1e9])

    def test_its_memory_belongs_to_the_state(self):
        compiled = ob.Controller(self.law, memory=[1e-6, 0.0, 1e9])
        sim = self.model.simulation(controllers={"tensioner": compiled})
        sim.advance(0.0)
        saved = sim.save()
        sim.advance(1.0)
        self.assertEqual(compiled.memory[1], 30.0)
        sim.restore(saved)
        self.assertEqual(compiled.memory[1], 20.0)

    def test_an_answer_that_is_none_ends_the_run(self):
        sim = self.model.simulation(controllers={"tensioner": ob.Controller(self.law, memory=[1e-6, 0.0, 0.05])})
        with self.assertRaises(ob.ControllerError) as caught:
            sim.advance(4.0)
        self.assertEqual(caught.exception.why, "it returned 7 instead of 0, 1 or 2")
        self.assertEqual(caught.exception.where, "at t = 0.1 s")

    def test_a_function_of_ctypes_is_one(self):
        law = ob.controllers.CONTROLLER_TYPE(lambda seen, command, memory: 0)
        sim = self.model.simulation(controllers={"tensioner": law})
        sim.advance(-1.0)
        self.assertEqual(sim.travel, 0.0)
        with self.assertRaises(TypeError):
            ob.Controller(0)


class Winches(unittest.TestCase):
    def test_a_mooring_winch_pays_out_by_commands_and_by_a_controller(self):
        model = ob.Model.read(MOORED).with_({**COARSE, "environment.waves.components": 20, "analysis.dynamic": {
            "duration": "1 s", "build_up": "0.5 s"}})
        sim = model.simulation()
        names = list(sim.moorings)
        line = names[0]
        self.assertEqual(len(names), 8)
        self.assertGreater(sim.moorings[line].tension, 100e3)
        with self.assertRaises(ob.ModelError):
            sim.command(line, 0.05)
        driven = model.with_({"moorings.winches.main.acceleration_time": "0.5 s"})
        sim = driven.simulation(controllers={line: lambda t, seen: 0.05 if t > -1e-9 else None})
        sim.advance(1.0)
        self.assertAlmostEqual(sim.moorings[line].paid_out, 0.05 * (1.0 - 0.0625), delta=1e-9)
        self.assertEqual(sim.moorings[line].state, "pay_out")
        self.assertEqual(sim.moorings[names[1]].paid_out, 0.0)


if __name__ == "__main__":
    unittest.main()
