"""Import of OrcaFlex files."""

import pathlib
import tempfile
import unittest

import overbend as ob

CASES = pathlib.Path(__file__).resolve().parents[2] / "validation" / "orcaflex_cases"


class Import(unittest.TestCase):
    def test_a_lay_solves_to_the_top_tension_of_the_reference(self):
        imported = ob.import_orcaflex(CASES / "slay-simple.yml")
        self.assertAlmostEqual(float(imported.model.static().top_tension), 224998.53867170805, delta=0.3)
        self.assertTrue(imported.account.is_complete)
        self.assertTrue(any("supports" in line for line in imported.account.translated))

    def test_a_yield_stress_replaces_the_assumed_one(self):
        imported = ob.import_orcaflex(CASES / "slay-simple.yml", yield_stress=450e6)
        self.assertIn("yield_stress: 450 MPa", imported.model.text)
        self.assertFalse(any("yield stress" in text for text, _ in imported.account.left_out))

    def test_a_damaged_file_is_rejected_with_its_line(self):
        with self.assertRaisesRegex(ob.ModelError, "of-unit-unknown.yml:12"):
            ob.import_orcaflex(CASES / "of-unit-unknown.yml")
        with tempfile.TemporaryDirectory() as folder, self.assertRaises(ob.ModelError):
            ob.import_orcaflex(pathlib.Path(folder, "none.yml"))


if __name__ == "__main__":
    unittest.main()
