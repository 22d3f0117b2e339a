"""What cannot be taken is an exception of Python, and never the end of the process."""

import math
import os
import pathlib
import pickle
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import overbend as ob
from lays import moving_lay, small_lay
from overbend import _core

SCRIPT = pathlib.Path(__file__).with_name("wrong_arguments.py")


class Arguments(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.model, cls.moving = small_lay(), moving_lay()

    def assert_rejected(self, of, message, call):
        with self.assertRaisesRegex(of, message):
            call()

    def every_call(self, of, least):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, SCRIPT, of], capture_output=True, encoding="utf-8", cwd=folder,
                                  env={**os.environ, "PYTHONWARNINGS": "ignore"}, check=False)
        lines = done.stdout.splitlines()
        self.assertEqual(done.returncode, 0, (lines[-1:], done.stderr[-2000:]))
        self.assertEqual(lines[-1], "done")
        self.assertGreater(len(lines), least)
        self.assertEqual([item for item in lines if item.startswith("no ")], [])

    def test_no_binding_is_upset_by_what_it_cannot_take(self):
        self.every_call("core", 5000)

    def test_no_function_of_the_package_is_either(self):
        self.every_call("package", 1000)

    def test_none_is_no_model(self):
        for call in (lambda: ob.Model(None).static(), lambda: _core.Statics(None), lambda: _core.Operation(None),
                     lambda: _core.LayTable(None), lambda: _core.Simulation(None), lambda: _core.seek(None, ""),
                     lambda: _core.run(None, "x"), lambda: _core.Statics.tree(None), lambda: _core.Model.text.fget(None)):
            self.assert_rejected(TypeError, "None", call)

    def test_an_object_that_was_not_initialised_is_none(self):
        self.assert_rejected(TypeError, "incompatible", lambda: _core.Statics.__new__(_core.Statics).tree())
        self.assert_rejected(TypeError, "incompatible", lambda: _core.Model.__new__(_core.Model).text)

    def test_a_controller_is_a_function(self):
        self.assert_rejected(TypeError, "None", lambda: _core.Simulation(self.moving._core, controllers={"tensioner": None}))
        self.assert_rejected(TypeError, "the number 3", lambda: self.moving.dynamic(controllers={"tensioner": 3}))
        self.assert_rejected(TypeError, "ctypes function", lambda: _core.Controller.compiled(3, 0.1))
        self.assert_rejected(TypeError, "null pointer", lambda: _core.Controller.compiled(ob.controllers.CONTROLLER_TYPE(), 0.1))
        self.assert_rejected(TypeError, "save", lambda: _core.Controller(len, 0.1, save=3))

    def test_numbers_are_within_their_bounds(self):
        for duration in (math.inf, math.nan, -1.0, 0.0, 1e12, "1e9 s", "inf s"):
            self.assert_rejected(ob.ModelError, "duration|found", lambda: self.moving.simulation(duration=duration))
            self.assert_rejected(ob.ModelError, "duration|found", lambda: self.moving.dynamic(duration=duration))
        for checkpoint in (math.nan, -1.0, math.inf):
            self.assert_rejected(ob.ModelError, "checkpoint", lambda: self.moving.dynamic(checkpoint=checkpoint))
        for seed in (2**63, -1, 1.5, math.nan, math.inf, "1", 2**70):
            self.assert_rejected(ob.ModelError, "seeds", lambda: self.moving.seeds([seed]))
            self.assert_rejected(ob.ModelError, "seeds", lambda: self.moving.simulation(seed=seed))
        self.assert_rejected(ob.ModelError, "seeds", lambda: self.moving.seeds(10**12))
        self.assert_rejected(ob.ModelError, "seeds", lambda: _core.run(self.moving._core, "x", seeds=[2**63]))
        self.assert_rejected(ob.ModelError, "threads", lambda: self.moving.seeds(2, threads=10**6))
        self.assert_rejected(ob.ModelError, "threads", lambda: self.moving.seeds(2, threads=-1))
        self.assert_rejected(ob.ModelError, "until", lambda: self.moving.simulation().advance(math.nan))
        self.assert_rejected(ob.ModelError, "out of range", lambda: _core.quantity("1e308 km", "m"))

    def test_indices_are_those_of_something(self):
        sim = _core.Simulation(self.moving._core)
        self.assert_rejected(IndexError, "0 mooring lines", lambda: sim.mooring(99))
        self.assert_rejected(TypeError, "incompatible", lambda: sim.mooring(-1))
        self.assert_rejected(ob.ModelError, "two or more", lambda: _core.FolderComparison([]))
        run = self.moving.dynamic(duration="1 s")
        self.assert_rejected(IndexError, "rows", lambda: run.snapshots("z", first=10**6))

    def test_a_state_that_was_changed_is_rejected(self):
        sim = self.moving.simulation()
        state = list(sim.save().__getstate__())
        name = next(iter(state[2]))
        state[2] = {**state[2], name: np.zeros(3)}
        saved = ob.simulation.SavedSimulation
        self.assert_rejected(ValueError, "damaged", lambda: saved.__new__(saved).__setstate__(tuple(state)))
        self.assert_rejected(ValueError, "not a state", lambda: saved.__new__(saved).__setstate__(()))
        sim.restore(pickle.loads(pickle.dumps(sim.save())))

    def test_a_compiled_controller_keeps_the_size_of_its_memory(self):
        law = ob.controllers.CONTROLLER_TYPE(lambda seen, command, memory: 0)
        sim = self.moving.simulation(controllers={"tensioner": ob.Controller(law, memory=[1.0, 2.0])})
        second = self.moving.simulation(controllers={"tensioner": ob.Controller(law, memory=[1.0])})
        self.assert_rejected(RuntimeError, "memory of 1 numbers", lambda: second.restore(sim.save()))


if __name__ == "__main__":
    unittest.main()
