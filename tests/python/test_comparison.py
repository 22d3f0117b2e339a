"""Folders of results next to each other, from Python against the command line."""

import pathlib
import tempfile
import unittest

import overbend as ob
from lays import overbend, small_lay


class Comparisons(unittest.TestCase):
    def test_results_and_keys_that_differ(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            statics = {}
            for tension in ("300 kN", "330 kN"):
                statics[tension] = small_lay().with_({"tensioner.tension": tension}).static()
                statics[tension].save(folder / tension.replace(" ", ""))
            compared = ob.compare_folders([folder / "300kN", folder / "330kN"])
            self.assertEqual(compared.folders.names(), ["300kN", "330kN"])
            self.assertEqual([(key.key, key["values"]) for key in compared.keys],
                             [("tensioner.tension", ["300 kN", "330 kN"])])
            row = compared.results["static.lay_back"]
            self.assertEqual(row["values"], [item.lay_back for item in statics.values()])
            self.assertAlmostEqual(row["changes"][1], statics["330 kN"].lay_back / statics["300 kN"].lay_back - 1.0)
            self.assertEqual(compared.table["330kN"].shape, (len(compared.results),))
            compared.save(folder / "here")
            overbend("compare", folder / "300kN", folder / "330kN", "-o", folder / "there")
            tables = [(folder / place / "comparison.csv").read_bytes() for place in ("here", "there")]
            self.assertEqual(tables[0], tables[1])

    def test_what_is_no_folder_of_results_is_rejected(self):
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(ob.ResultsError, folder):
                ob.compare_folders([folder, folder])
        with self.assertRaisesRegex(ob.ModelError, "two or more"):
            ob.compare_folders(["one"])


if __name__ == "__main__":
    unittest.main()
