"""Studies from Python against those of the command line."""

import pathlib
import tempfile
import threading
import unittest
import warnings

import h5py
import numpy as np

import overbend as ob
from lays import moving_lay, overbend, small_lay

TENSION, DEPTH = "tensioner.tension", "environment.water_depth"
STRESS = "static.sagbend.max_bending_stress"
AXES = {TENSION: {"from": "260 kN", "to": "340 kN", "steps": 5}, DEPTH: ["39 m", "40 m", "41 m"]}


class Interrupter:
    """Progress that is interrupted once so many cases are done."""

    def __init__(self, after):
        self.after = after

    def __call__(self, done, cases, failed):
        if done >= self.after:
            raise KeyboardInterrupt


class Studies(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def test_the_table_is_that_of_the_command_line(self):
        gathered = [STRESS, "static.lay_back", "checks.governing"]
        results = ob.study(small_lay(), AXES, gather=gathered, out=self.folder / "here")
        overbend("study", self.folder / "here" / "study.yaml", "-o", self.folder / "there")
        with h5py.File(self.folder / "there" / "study.h5") as file:
            np.testing.assert_array_equal(results.table[STRESS].values, file[f"outputs/{STRESS}"][:])
            np.testing.assert_array_equal(results.table[TENSION].values, file[f"inputs/{TENSION}"][:])
            self.assertEqual(list(results.table.governing.values), list(file["case/governing"].asstr()[:]))
        self.assertEqual(results.table[STRESS].attrs["units"], "Pa")
        self.assertEqual(results.table.keys()[:4], ["case", TENSION, DEPTH, STRESS])
        self.assertEqual(len(results), 15)

    def test_the_command_line_finds_a_study_of_python_finished(self):
        ob.study(small_lay(), AXES, out=self.folder / "here")
        before = (self.folder / "here/cases/0000/000000007/case.json").read_bytes()
        overbend("study", self.folder / "here" / "study.yaml", "-o", self.folder / "here")
        self.assertEqual((self.folder / "here/cases/0000/000000007/case.json").read_bytes(), before)

    def test_cases_agree_with_statics_by_themselves(self):
        results = ob.study(small_lay(), {TENSION: ["270 kN", "330 kN"]}, gather=["static.lay_back"])
        for row in results:
            alone = small_lay().with_({TENSION: f"{row[TENSION]} N"}).static()
            self.assertAlmostEqual(row["static.lay_back"] / alone.lay_back, 1.0, places=4)
            self.assertEqual(row["static.lay_back"].units, "m")

    def test_a_grid_lies_over_the_axes(self):
        axes = {**AXES, "pipe.steel.yield_stress": {"values": ["400 MPa", "414 MPa", "430 MPa"], "with": DEPTH}}
        results = ob.study(small_lay(), axes, gather=["static.lay_back"])
        grid = results.grid("static.lay_back")
        self.assertEqual(grid.dims, (TENSION, DEPTH))
        self.assertEqual(grid.shape, (5, 3))
        self.assertEqual(list(grid.coords[DEPTH].values), [39.0, 40.0, 41.0])
        self.assertEqual(list(grid.coords["pipe.steel.yield_stress"].values), [400e6, 414e6, 430e6])
        self.assertEqual([grid.coords[key].attrs["units"] for key in AXES], ["N", "m"])
        cell = grid.sel({TENSION: 280e3, DEPTH: 41.0})
        self.assertEqual(float(cell), float(results.table["static.lay_back"].values[5]))
        self.assertEqual(results.table[TENSION].values[5], 280e3)
        with self.assertRaisesRegex(KeyError, "did you mean 'static.lay_back'"):
            results.grid("static.layback")

    def test_a_grid_is_a_labelled_array_without_xarray(self):
        results = ob.study(small_lay(), AXES, gather=["static.lay_back"])
        ob.use_xarray(False)
        self.addCleanup(ob.use_xarray, True)
        grid = ob.open(results.folder).grid("static.lay_back")
        self.assertIsInstance(grid, ob.LabelledArray)
        self.assertEqual((grid.shape, list(grid.coords)), ((5, 3), [TENSION, DEPTH]))

    def test_a_sample_draws_keys_at_random(self):
        keys = {TENSION: {"distribution": "normal", "mean": "300 kN", "std": "10 kN"},
                "supports.stinger.boxes[1].z": {"from": "-7.3 m", "to": "-7.1 m"}}
        sample = {"count": 6, "seed": 2, "keys": keys}
        results = ob.study(small_lay(), {DEPTH: ["39 m", "40 m"]}, sample=sample, gather=["static.lay_back"])
        grid = results.grid(TENSION)
        self.assertEqual((grid.dims, grid.shape), ((DEPTH, "draw"), (2, 6)))
        np.testing.assert_array_equal(grid.values[0], grid.values[1])
        self.assertEqual(len(np.unique(grid.values[0])), 6)
        again = ob.study(small_lay(), sample=sample, gather=["static.lay_back"])
        np.testing.assert_array_equal(again.table[TENSION].values, grid.values[0])

    def test_a_case_without_a_solution_fails_alone(self):
        with warnings.catch_warnings(record=True) as reported:
            warnings.simplefilter("always")
            results = ob.study(small_lay(), {TENSION: ["20 kN", "300 kN"]}, gather=["static.lay_back"])
        self.assertIn("1 of 2 cases have no solution", str(reported[0].message))
        self.assertEqual([row["case"] for row in results.failed], [0])
        self.assertIn("tension", results.failed[0].reason)
        self.assertTrue(np.isnan(results.grid("static.lay_back").values[0]))
        self.assertEqual(results.failed[0].folder, "cases/0000/000000000")

    def test_errors_name_file_line_and_key_and_leave_nothing(self):
        with self.assertRaises(ob.ModelError) as raised:
            ob.study(small_lay(), {"tensioner.tensio": ["1 kN"]}, gather=["static.layback"], out=self.folder / "none")
        keys = [error.key for error in raised.exception.faults]
        self.assertEqual(keys, ["gather[0]", "axes[0].key"])
        self.assertEqual(raised.exception.file, str(self.folder / "none" / "study.yaml"))
        self.assertEqual([error.line for error in raised.exception.faults], [3, 5])
        self.assertFalse((self.folder / "none").exists())
        with self.assertRaisesRegex(ob.ModelError, "expected a list of values"):
            ob.study(small_lay(), {TENSION: "300 kN"})
        with self.assertRaisesRegex(ob.ModelError, "a unit|its unit|unit"):
            ob.study(small_lay(), {TENSION: [300]})

    def test_another_study_in_the_folder_is_rejected(self):
        ob.study(small_lay(), {TENSION: ["300 kN"]}, out=self.folder / "one")
        with self.assertRaisesRegex(ob.ResultsError, "study file"):
            ob.study(small_lay(), {TENSION: ["310 kN"]}, out=self.folder / "one")
        with self.assertRaisesRegex(ob.ResultsError, "base model"):
            ob.study(small_lay().with_({DEPTH: "41 m"}), {TENSION: ["300 kN"]}, out=self.folder / "one")

    def test_an_interrupted_study_goes_on_to_the_same_results(self):
        depths = {"from": "36 m", "to": "44 m", "step": "2 m"}
        axes = {TENSION: {"from": "250 kN", "to": "350 kN", "steps": 41}, DEPTH: depths}
        whole = ob.study(small_lay(), axes, gather=["static.lay_back"])
        with self.assertRaises(ob.Interrupted) as raised:
            ob.study(small_lay(), axes, gather=["static.lay_back"], out=self.folder / "one", progress=Interrupter(5))
        self.assertEqual(raised.exception.folder, self.folder / "one")
        so_far = ob.open(self.folder / "one")
        self.assertTrue(5 <= len(so_far) - len(so_far.open) < 205, len(so_far.open))
        again = ob.study(small_lay(), axes, gather=["static.lay_back"], out=self.folder / "one")
        self.assertEqual(len(again.open), 0)
        np.testing.assert_array_equal(again.grid("static.lay_back").values, whole.grid("static.lay_back").values)

    def test_a_study_file_is_run_as_it_stands(self):
        ob.study(small_lay(), {TENSION: ["300 kN", "310 kN"]}, gather=["static.lay_back"], out=self.folder / "one")
        results = ob.study(self.folder / "one" / "study.yaml", out=self.folder / "two")
        self.assertEqual(len(results), 2)
        with self.assertRaisesRegex(ob.ModelError, "in addition to a study file"):
            ob.study(self.folder / "one" / "study.yaml", gather=["static.lay_back"])
        with self.assertRaisesRegex(ob.ModelError, "no such file"):
            ob.study(self.folder / "nothing.yaml")

    def test_the_files_of_a_model_are_found_from_the_folder_of_the_study(self):
        (self.folder / "lay").mkdir()
        (self.folder / "lay" / "bed.csv").write_text("east,north,depth\n-3000,-3000,40\n3000,-3000,40\n-3000,3000,40\n"
                                                     "3000,3000,40\n", encoding="utf-8")
        model = ob.Model.from_text(small_lay().text, self.folder / "lay" / "lay.yaml")
        model = model.with_({"environment.seabed.bathymetry": "bed.csv"})
        results = ob.study(model, {TENSION: ["300 kN"]}, gather=["static.lay_back"], out=self.folder / "deep" / "one")
        self.assertEqual([row.reason for row in results.failed], [])
        self.assertIn("../../lay/bed.csv", (self.folder / "deep/one/model.yaml").read_text(encoding="utf-8"))

    def test_the_files_of_one_case_are_made_when_they_are_asked_for(self):
        results = ob.study(small_lay(), {TENSION: ["300 kN", "320 kN"]}, gather=["static.lay_back"])
        static = results.case(1)
        self.assertAlmostEqual(static.top_tension, 320e3, delta=1.0)
        self.assertAlmostEqual(static.lay_back, float(results.table["static.lay_back"].values[1]), places=3)
        with self.assertRaises(IndexError):
            results.case(2)

    def test_saved_results_are_whole(self):
        results = ob.study(small_lay(), {TENSION: ["300 kN", "320 kN"]}, gather=["static.lay_back"])
        results.save(self.folder / "kept")
        self.assertTrue((self.folder / "kept" / "report.html").is_file())
        again = ob.open(self.folder / "kept")
        np.testing.assert_array_equal(again.table["static.lay_back"].values, results.table["static.lay_back"].values)

    def test_other_threads_go_on_meanwhile(self):
        counted, stop = [0], threading.Event()

        def count():
            while not stop.wait(0.001):
                counted[0] += 1

        counter = threading.Thread(target=count)
        counter.start()
        reported = []
        axes = {TENSION: {"from": "250 kN", "to": "350 kN", "steps": 301}}
        ob.study(small_lay(), axes, progress=lambda *progress_values: reported.append(progress_values))
        stop.set()
        counter.join()
        self.assertGreater(counted[0], 20)
        self.assertEqual(reported[-1], (301, 301, 0))


class DynamicStudies(unittest.TestCase):
    def test_seeds_are_a_dimension_and_have_extremes(self):
        results = ob.study(moving_lay(), {TENSION: ["300 kN", "310 kN"]}, seeds=[4, 7], analysis="dynamic", duration=4,
                           gather=["dynamic.top_tension.max"])
        grid = results.grid("dynamic.top_tension.max")
        self.assertEqual((grid.dims, grid.shape), ((TENSION, "seed"), (2, 2)))
        self.assertEqual(list(grid.coords["seed"].values), [4, 7])
        self.assertEqual(len(results.extremes), 2)
        self.assertEqual(results.extremes.worst.values[1], grid.values[1].max())
        alone = moving_lay().with_({TENSION: "310 kN"}).dynamic(duration=4, seed=7)
        self.assertEqual(float(grid.values[1, 1]), float(alone.top_tension.max))

    def test_h5py_may_be_used_in_other_threads(self):
        with tempfile.TemporaryDirectory() as folder:
            stop, errors, used = threading.Event(), [], []

            def use(file):
                try:
                    while not stop.is_set():
                        with h5py.File(file, "w") as counter:
                            counter["values"] = np.arange(1000.0)
                        with h5py.File(file) as counter:
                            assert counter["values"][999] == 999.0
                        used.append(file)
                except Exception as error:  # noqa: BLE001
                    errors.append(error)

            users = [threading.Thread(target=use, args=(pathlib.Path(folder, name),)) for name in ("a.h5", "b.h5")]
            for user in users:
                user.start()
            try:
                axes = {TENSION: {"from": "290 kN", "to": "310 kN", "steps": 6}}
                results = ob.study(moving_lay(), axes, analysis="dynamic", duration="1 s", keep=True,
                                   gather=["dynamic.top_tension.max"])
            finally:
                stop.set()
                for user in users:
                    user.join()
            self.assertEqual(errors, [])
            self.assertGreater(len(used), 10)
            self.assertEqual(results.case(3).top_tension.max, float(results.table["dynamic.top_tension.max"].values[3]))

    def test_limits_are_looked_for_over_the_other_axes(self):
        limit = {"over": DEPTH, "resolution": "1 m", "criterion": {"static.lay_back": "<= 177 m"}}
        axes = {DEPTH: ["30 m", "50 m"], TENSION: ["280 kN", "300 kN", "320 kN"]}
        results = ob.study(small_lay(), axes, operability=limit)
        found = results.operability
        self.assertEqual((found.limit.dims, found.limit.shape), ((TENSION,), (3,)))
        self.assertEqual(found.limit.attrs["units"], "m")
        for tension, depth in zip(found.limit.coords[TENSION].values, found.limit.values):
            lays = [small_lay().with_({TENSION: f"{tension} N", DEPTH: f"{deep} m"}).static().lay_back
                    for deep in (depth, depth + 1.0)]
            self.assertLessEqual(lays[0], 177.0)
            self.assertGreater(lays[1], 177.0)
        self.assertTrue(found.decided.values.all())
        self.assertIn("static.lay_back at most 177 m", str(found.governing.values[0]))
        self.assertIsNone(found.workability)


if __name__ == "__main__":
    unittest.main()
