"""Lay tables from Python against those of the command line."""

import pathlib
import tempfile
import unittest

import numpy as np

import overbend as ob
from lays import overbend, small_lay, load_summary, without_times, EXAMPLES


class LayTables(unittest.TestCase):
    def test_rows_are_those_of_the_command_line(self):
        with tempfile.TemporaryDirectory() as folder:
            first = EXAMPLES / "first-model.yaml"
            overbend("lay-table", first, "--tension", "280 kN..360 kN/4", "-o", f"{folder}/table")
            reported = load_summary(f"{folder}/table")
        table = small_lay().lay_table("tension", from_="280 kN", to="360 kN", step="20 kN")
        self.assertEqual(without_times(table.summary), without_times(reported))
        rows = reported["lay_table"]["rows"]
        self.assertEqual(list(table["lay_back"].values), [row["lay_back"] for row in rows])
        self.assertEqual(table["lay_back"].attrs["units"], "m")
        self.assertEqual([row.verdict for row in table], [row["verdict"] for row in rows])

    def test_steps_are_the_rows_that_were_asked_for(self):
        table = small_lay().lay_table("depth", from_="38 m", to="42 m", steps=4)
        np.testing.assert_allclose(table.steps["depth"].values, [38.0, 39.0, 40.0, 41.0, 42.0])
        self.assertEqual(table.vary, "depth")
        self.assertTrue((np.diff(table.steps["lay_back"].values) > 0.0).all())

    def test_limits_pass_and_lie_around_the_lays_that_do(self):
        table = small_lay().lay_table("tension", from_="280 kN", to="360 kN", steps=2)
        for limit in (table.least, table.largest):
            if limit is not None:
                self.assertEqual(limit.verdict, "passed")
        self.assertIsNotNone(table.least or table.largest)

    def test_points_of_a_route_are_given_or_read(self):
        points = [(0.0, 38.0), (1500.0, 40.0)]
        table = small_lay().lay_table(depths=points)
        self.assertEqual(table.vary, "route")
        self.assertEqual(list(table["distance"].values), [0.0, 1500.0])
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "depths.csv")
            file.write_text("distance_m,depth_m\n0,38\n1500,40\n", encoding="utf-8")
            read = small_lay().lay_table(depths=file)
            file.write_text("distance_m,depth_m\n0,38\n1500,deep\n", encoding="utf-8")
            with self.assertRaises(ob.ModelError) as raised:
                small_lay().lay_table(depths=file)
        np.testing.assert_array_equal(read["lay_back"].values, table["lay_back"].values)
        self.assertEqual((raised.exception.file, raised.exception.line), (str(file), 3))

    def test_a_row_without_a_lay_says_why(self):
        table = small_lay().lay_table("tension", from_="10 kN", to="300 kN", steps=1)
        self.assertEqual(table[0].verdict, "no lay")
        self.assertTrue(np.isnan(table["lay_back"].values[0]))
        self.assertIn("tension", table[0].reason)

    def test_values_that_cannot_be_are_rejected(self):
        for given in ({"vary": "tensions"}, {"vary": "tension", "from_": "200 kN"}, {"steps": 3},
                      {"vary": "depth", "from_": "2 kN", "to": "3 kN"},
                      {"vary": "tension", "from_": "200 kN", "to": "300 kN", "step": "30 kN"}):
            with self.subTest(given), self.assertRaises(ob.ModelError):
                small_lay().lay_table(**given)

    def test_numbers_without_a_unit_are_rejected_with_the_text_to_write(self):
        with self.assertRaisesRegex(ob.ModelError, "lay_table: from_: found 200 without a unit.*'200 kN'"):
            small_lay().lay_table("tension", from_=200, to="400 kN", steps=2)
        with self.assertRaisesRegex(ob.ModelError, "lay_table: step: found 2.5 without a unit.*'2.5 m'"):
            small_lay().lay_table("depth", from_="38 m", to="43 m", step=2.5)
        given = small_lay().lay_table("tension", from_=ob.Number(300e3, "N"), to="320 kN", steps=1)
        self.assertAlmostEqual(given.steps["tension"].values[0], 300e3)

    def test_files_and_progress(self):
        reported = []
        table = small_lay().lay_table("tension", from_="280 kN", to="360 kN", steps=4,
                                      progress=lambda *progress_values: reported.append(progress_values))
        self.assertTrue(reported and reported[-1][0] >= 5, reported)
        with tempfile.TemporaryDirectory() as folder:
            table.save(f"{folder}/table")
            self.assertTrue(pathlib.Path(folder, "table", "lay-table.xlsx").is_file())
            with self.assertRaisesRegex(ob.ResultsError, "lay table"):
                ob.open(f"{folder}/table")


if __name__ == "__main__":
    unittest.main()
