"""docs/sensitivity.csv and its diagrams are those that tools/sensitivity.py writes for the examples as they are."""

import csv
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import sensitivity  # noqa: E402


class Sensitivity(unittest.TestCase):
    def test_every_change_still_finds_its_place_in_the_examples(self):
        for study, name in (("static", "bgl1.yaml"), ("tensioner", "bgl1-tensioner.yaml")):
            text = (ROOT / "examples" / name).read_text(encoding="utf-8")
            for label, _, changes, static in sensitivity.INPUTS:
                for value, change in changes if static or study == "tensioner" else []:
                    self.assertNotEqual(change(text), text, f"{name}: {label} {value}")

    def test_the_table_has_every_change_of_every_result(self):
        with sensitivity.TABLE.open(encoding="utf-8", newline="") as file:
            found = {(row["study"], row["result"], row["input"], row["value"]) for row in csv.DictReader(file)}
        wanted = {
            (study, key, label, value)
            for key, study, *_ in sensitivity.RESULTS
            for label, _, changes, static in sensitivity.INPUTS if static or study == "tensioner"
            for value, _ in changes
        }
        self.assertEqual(found, wanted)

    def test_the_diagrams_show_the_table(self):
        for name, drawing in sensitivity.drawings(sensitivity.kept()):
            self.assertEqual((sensitivity.IMAGES / name).read_text(encoding="utf-8"), drawing, name)


if __name__ == "__main__":
    unittest.main()
