"""Several seeds and variants from Python against the command line."""

import pathlib
import tempfile
import unittest

import numpy as np

import overbend as ob
from lays import moving_lay, overbend, small_lay, load_summary, without_times


class Seeds(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.holder.name)
        moving_lay().with_({"analysis.dynamic.seeds": [2, 5]}).write(cls.folder / "lay.yaml")
        overbend("dynamic", cls.folder / "lay.yaml", "--duration", "3 s", "-o", cls.folder / "there")
        cls.reported = load_summary(cls.folder / "there")["seeds"]
        cls.results = moving_lay().seeds([2, 5], duration="3 s", out=cls.folder / "here")

    @classmethod
    def tearDownClass(cls):
        cls.holder.cleanup()

    def test_what_they_give_together_is_that_of_the_command_line(self):
        self.assertEqual(without_times(self.results.summary["seeds"]), without_times(self.reported))

    def test_the_table_has_a_row_for_each_seed(self):
        table = self.results.table
        self.assertEqual(list(table["seed"].values), [2, 5])
        name = next(iter(self.reported["statistics"]))
        self.assertEqual(list(table[name].values), [run[name] for run in self.reported["runs"]])
        self.assertEqual(table[name].attrs["units"], self.reported["statistics"][name]["units"])

    def test_statistics_have_units(self):
        name = next(name for name, item in self.reported["statistics"].items() if item["units"] == "N")
        item = self.results.statistics[name]
        self.assertEqual((item.mean, item.mean.units), (self.reported["statistics"][name]["mean"], "N"))
        self.assertEqual(item.max, self.results.table[name].values.max())

    def test_each_run_has_its_results(self):
        self.assertEqual(self.results.seeds, [2, 5])
        self.assertNotEqual(self.results[2].top_tension.max, self.results[5].top_tension.max)
        self.assertEqual([float(run.top_tension.max) for run in self.results],
                         list(self.results.values("dynamic.top_tension.max").values))
        with self.assertRaises(KeyError):
            self.results[3]

    def test_they_are_opened_as_they_were_left(self):
        for folder in ("here", "there"):
            again = ob.open(self.folder / folder)
            self.assertIsInstance(again, ob.SeedsResults)
            np.testing.assert_array_equal(again.table["seed"].values, [2, 5])

    def test_seeds_that_are_none_or_no_whole_numbers_are_rejected(self):
        for seeds in ([], 0, -2, [1, -3], [2.5]):
            with self.assertRaises(ob.ModelError, msg=str(seeds)):
                moving_lay().seeds(seeds, duration="1 s")
        with self.assertRaises(ob.ModelError):
            moving_lay().dynamic(duration="1 s", seed=-3)

    def test_runs_without_a_solution_say_why(self):
        with self.assertRaises(ob.OverbendError) as raised:
            moving_lay().with_({"tensioner.tension": "20 kN"}).seeds([1, 2], duration="1 s")
        self.assertIn("tension", str(raised.exception))


class Comparisons(unittest.TestCase):
    def test_variants_are_those_of_the_command_line(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            model = moving_lay()
            model.write(folder / "lay.yaml")
            overbend("compare", folder / "lay.yaml", "--of", "contact", "--duration", "2 s", "-o", folder / "there")
            results = model.compare("contact", duration="2 s", out=folder / "here")
            reported = load_summary(folder / "there", "comparison.json")
            self.assertEqual(without_times(results.summary), without_times(reported))
            self.assertEqual(results.variants, [item["name"] for item in reported["comparison"]["variants"]])
            column, runs = next(iter(reported["comparison"]["quantities"])), reported["comparison"]["variants"]
            self.assertEqual(list(results.table[column].values), [item[column] for item in runs])
            self.assertEqual(results.supports[0].name, reported["comparison"]["supports"][0]["name"])
            self.assertIsInstance(results[results.variants[0]], ob.DynamicResults)
            self.assertIsInstance(ob.open(folder / "there"), ob.ComparisonResults)

    def test_only_what_can_be_compared_is(self):
        with self.assertRaises(ValueError):
            small_lay().compare("roller")


if __name__ == "__main__":
    unittest.main()
