"""Runs in time from Python against those of the command line."""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

import overbend as ob

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ["OVERBEND_PROGRAM"]
WAVES = ROOT / "examples" / "bgl1-workable-sea.yaml"

INTERRUPTED = """
import sys, overbend as ob
model = ob.Model.read(sys.argv[1])
report = lambda done, runs, at, end, tension: print(at, flush=True)
try:
    model.dynamic(duration='3000 s', out=sys.argv[2], progress=report, checkpoint=1.0)
except ob.Interrupted as interruption:
    print('kept in', interruption.folder)
"""


def without_times(value):
    if isinstance(value, dict):
        return {key: without_times(item) for key, item in value.items()
                if key not in ("wall_time", "history", "real_time_ratio")}
    return [without_times(item) for item in value] if isinstance(value, list) else value


class Dynamics(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.holder.name, "storm")
        subprocess.run([PROGRAM, "dynamic", str(WAVES), "--duration", "10 s", "-o", str(cls.folder)], check=True,
                       capture_output=True)
        cls.reported = json.loads((cls.folder / "summary.json").read_text(encoding="utf-8"))
        cls.model = ob.Model.read(WAVES)
        cls.run_ = cls.model.dynamic(duration="10 s")

    @classmethod
    def tearDownClass(cls):
        cls.holder.cleanup()

    def test_a_run_is_that_of_the_command_line(self):
        self.assertEqual(without_times(self.run_.summary), without_times(self.reported))

    def test_key_results_are_attributes(self):
        self.assertEqual(self.run_.top_tension.max, self.reported["dynamic"]["top_tension"]["max"])
        self.assertEqual(self.run_.top_tension.max.units, "N")
        self.assertEqual(self.run_["dynamic.top_tension.max"], self.run_.top_tension.max)
        self.assertEqual(self.run_.static.lay_back, self.reported["static"]["lay_back"])

    def test_results_are_found_by_object(self):
        pipe = self.run_.objects.lines["pipe"]
        self.assertEqual(pipe.dynamic.top_tension.max, self.run_.top_tension.max)
        self.assertEqual((pipe.dynamic.top_tension.max.units, pipe.static.lay_back.units), ("N", "m"))
        self.assertEqual(self.run_.objects.run.dynamic.steps, self.reported["dynamic"]["steps"])
        self.assertEqual(self.run_["lines[pipe].dynamic.top_tension.max"], self.run_.top_tension.max)

    def test_checks_are_those_of_the_run(self):
        worst = self.reported["dynamic"]["checks"]["worst"]
        self.assertEqual(self.run_.checks.worst.utilisation, worst["utilisation"])
        self.assertEqual(self.run_.static.checks.worst.utilisation, self.reported["checks"]["worst"]["utilisation"])
        self.assertNotEqual(worst["utilisation"], self.reported["checks"]["worst"]["utilisation"])

    def test_histories_are_over_time(self):
        tension = self.run_.history("top_tension")
        self.assertEqual(tension.attrs["units"], "N")
        since = tension.values[self.run_.time >= 0.0]
        self.assertLessEqual(since.max(), float(self.run_.top_tension.max))
        self.assertEqual(tension.shape, self.run_.time.shape)
        with self.assertRaises(KeyError) as caught:
            self.run_.history("top_tensoin")
        self.assertIn("top_tension", str(caught.exception))

    def test_envelopes_enclose_the_mean_and_the_static_state_is_next_to_them(self):
        envelope = self.run_.envelope("von_mises")
        self.assertTrue(np.all(envelope["min"].values <= envelope["mean"].values * (1 + 1e-12)))
        self.assertTrue(np.all(envelope["mean"].values <= envelope["max"].values * (1 + 1e-12)))
        self.assertEqual(envelope["static"].shape, envelope["max"].shape)
        self.assertEqual(self.run_.envelope("effective_tension")["static"].attrs["units"], "N")

    def test_snapshots_show_the_line_at_instants(self):
        shape = self.run_.snapshots("z")
        part = self.run_.snapshots("z", first=1, count=2)
        self.assertEqual(shape.shape[1], len(self.run_.stations))
        np.testing.assert_array_equal(part.values, shape.values[1:3])
        since = np.asarray(shape.coords["time"]) > 0.0  # envelopes count the steps from there
        self.assertTrue(np.all(shape.values[since] >= self.run_.stations.z_min.values - 1e-6))
        self.assertTrue(np.all(shape.values[since] <= self.run_.stations.z_max.values + 1e-6))

    def test_results_in_a_temporary_folder_go_with_their_object_and_can_be_kept(self):
        run = self.model.dynamic(duration="1 s")
        folder = run.folder
        with tempfile.TemporaryDirectory() as place:
            kept = ob.open(run.save(pathlib.Path(place, "kept")))
            tension = run.history("top_tension").values
            del run
            self.assertFalse(folder.exists())
            np.testing.assert_array_equal(kept.history("top_tension").values, tension)
            self.assertIsInstance(kept, ob.DynamicResults)
            with self.assertRaises(ob.ResultsError):
                kept.save(place)

    def test_warnings_are_those_of_the_run_and_of_its_statics(self):
        of_statics = self.reported["warnings"]
        self.assertTrue(of_statics)
        self.assertEqual(self.run_.warnings, self.reported["dynamic"]["warnings"] + of_statics)
        self.assertTrue(set(self.reported["assumptions"]) <= set(self.run_.assumptions))
        self.assertEqual(len(self.run_.assumptions), len(set(self.run_.assumptions)))

    def test_progress_is_reported_and_another_thread_goes_on(self):
        reported, ticks, done = [], [], threading.Event()

        def tick():
            while not done.is_set():
                ticks.append(time.monotonic())
                time.sleep(0.01)

        thread = threading.Thread(target=tick)
        thread.start()
        self.model.dynamic(duration="20 s", progress=lambda *state: reported.append(state))
        done.set()
        thread.join()
        self.assertTrue(reported)
        self.assertTrue(all(end == 20.0 for _, _, _, end, _ in reported))
        self.assertGreater(len(ticks), 5)

    def test_what_progress_raises_ends_the_run(self):
        def raise_error(*_):
            raise RuntimeError("enough")

        with tempfile.TemporaryDirectory() as folder, self.assertRaisesRegex(RuntimeError, "enough"):
            self.model.dynamic(duration="2000 s", out=pathlib.Path(folder, "run"), progress=raise_error)

    def test_ctrl_c_keeps_a_checkpoint_from_which_the_run_goes_on(self):
        with tempfile.TemporaryDirectory() as folder:
            place = pathlib.Path(folder, "run")
            process = subprocess.Popen([sys.executable, "-c", INTERRUPTED, str(WAVES), str(place)],
                                       stdout=subprocess.PIPE, encoding="utf-8")
            line_time = -100.0
            while line_time < -58.0:  # the build-up begins at -60 s
                line_time = float(process.stdout.readline())
            process.send_signal(signal.SIGINT)
            rest, _ = process.communicate()
            self.assertEqual(process.returncode, 0)
            self.assertIn(f"kept in {place}", rest)
            with self.assertRaises(ob.ResultsError) as caught:
                self.model.dynamic(duration="3000 s", out=place)
            self.assertIn("resume=True", str(caught.exception))

    def test_seeds_run_side_by_side(self):
        results = self.model.seeds([1, 2], duration="2 s")
        self.assertEqual(results.seeds, [1, 2])
        values = results.values("dynamic.top_tension.max")
        self.assertEqual(values.shape, (2,))
        self.assertEqual(values.attrs["units"], "N")
        self.assertNotEqual(float(values[0]), float(values[1]))
        self.assertEqual(results[2].top_tension.max, float(values[1]))

    def test_lines_by_themselves_run_and_have_the_histories_of_their_ends(self):
        run = ob.Model.read(ROOT / "examples" / "jumper.yaml").dynamic(duration="5 s")
        self.assertIn("line/jumper/first_tension", run.histories)
        tension = run.history("line/jumper/first_tension")
        self.assertEqual(tension.shape, run.time.shape)
        self.assertGreater(float(tension.values.max()), 0.0)
        self.assertEqual(run.history("jumper/first_tension").values.tolist(), tension.values.tolist())

    def test_a_hull_on_its_moorings_runs_without_a_pipe(self):
        barge = ob.Model.read(ROOT / "examples" / "moored-barge.yaml").with_({"environment.waves.components": 30})
        run = barge.dynamic(duration="5 s")
        self.assertIn("mooring/port bow/fairlead_tension", run.histories)
        tension = run.history("mooring/port bow/fairlead_tension")
        self.assertEqual(tension.shape, run.time.shape)
        line = run.moorings["port bow"]
        self.assertLessEqual(line.fairlead_tension.min, float(tension.values[run.time >= 0.0].min()) * (1 + 1e-9))
        self.assertEqual(line.fairlead_tension.max.units, "N")
        self.assertGreater(run.vessel.pitch.max, run.vessel.pitch.min)
        self.assertEqual(len(run.mooring_lines), 8)
        self.assertEqual(run.static.moorings["port bow"].name, "port bow")
        self.assertFalse(hasattr(run, "top_tension"))

    def test_a_duration_that_is_none_is_an_error(self):
        for duration in ("10 kN", "soon", -1.0, 0):
            with self.assertRaises(ob.ModelError):
                self.model.dynamic(duration=duration)


if __name__ == "__main__":
    unittest.main()
