"""Models from Python: read, changed, rejected."""

import copy
import pathlib
import pickle
import tempfile
import unittest

import overbend as ob

ROOT = pathlib.Path(__file__).resolve().parents[2]
BGL1 = ROOT / "examples" / "bgl1.yaml"


class Models(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.model = ob.Model.read(BGL1)

    def test_a_model_is_read_with_its_text(self):
        self.assertEqual(self.model.text, BGL1.read_text(encoding="utf-8"))
        self.assertIn("BGL-1", self.model.title)
        self.assertEqual(self.model.file, str(BGL1))

    def test_a_model_made_of_a_path_says_how_models_are_made(self):
        with self.assertRaisesRegex(TypeError, r"Model\.read"):
            ob.Model(str(BGL1))

    def test_a_model_goes_through_pickle_and_copies_as_it_is(self):
        second = pickle.loads(pickle.dumps(self.model))
        self.assertEqual(second.text, self.model.text)
        self.assertEqual(second.file, self.model.file)
        self.assertEqual(copy.deepcopy([self.model])[0]["title"], self.model["title"])

    def test_a_key_set_anew_gives_another_model_and_leaves_the_first(self):
        second = self.model.with_({"tensioner.tension": "260 kN"})
        self.assertEqual(second["tensioner.tension"], "260 kN")
        self.assertNotEqual(self.model["tensioner.tension"], "260 kN")
        self.assertIn("260 kN", second.text)
        self.assertEqual(ob.Model.from_text(second.text, BGL1)["tensioner.tension"], "260 kN")

    def test_comments_and_layout_stay_when_keys_are_set_one_after_the_other(self):
        second = self.model.with_({"tensioner.tension": "260 kN"}).with_({"environment.water_depth": "90 m"})
        changed = [(a, b) for a, b in zip(self.model.text.splitlines(), second.text.splitlines()) if a != b]
        self.assertEqual(len(changed), 2)
        self.assertEqual(len(second.text.splitlines()), len(self.model.text.splitlines()))

    def test_items_of_lists_are_chosen_by_name_and_pattern(self):
        boxes = self.model["supports.stinger.boxes"]
        name = boxes[0]["name"] if "name" in boxes[0] else "0"
        second = self.model.with_({f"supports.stinger.boxes[{name}].offset": "0.1 m"})
        self.assertEqual(second["supports.stinger.boxes"][0]["offset"], "0.1 m")

    def test_groups_lists_and_truth_values_can_be_given(self):
        second = self.model.with_({"environment.seabed": {"stiffness": "50 kN/m^2", "friction": 0.4}})
        self.assertEqual(second["environment.seabed"], {"stiffness": "50 kN/m^2", "friction": "0.4"})

    def test_none_removes_a_key(self):
        self.assertIsNone(self.model.with_({"title": None}).get("title"))

    def test_a_key_that_no_model_has_cannot_be_removed(self):
        with self.assertRaises(ob.ModelError) as caught:
            self.model.with_({"environment.curent": None})
        self.assertIn("did you mean 'environment.current'", str(caught.exception))
        self.assertEqual(self.model.with_({"fatigue": None}).text, self.model.text)  # one that is left out is none

    def test_a_value_that_cannot_be_is_an_error_with_its_place(self):
        with self.assertRaises(ob.ModelError) as caught:
            self.model.with_({"tensioner.tension": "260 m"})
        error = caught.exception
        self.assertEqual(error.key, "tensioner.tension")
        self.assertEqual(error.file, str(BGL1))
        self.assertIn("260 m", error.found)
        self.assertIn("tension", BGL1.read_text(encoding="utf-8").splitlines()[error.line - 1])

    def test_an_unknown_key_is_an_error_that_says_what_might_be_meant(self):
        with self.assertRaises(ob.ModelError) as caught:
            self.model.with_({"tensioner.tensoin": "260 kN"})
        self.assertIn("tension", str(caught.exception))

    def test_an_item_that_is_not_there_is_an_error_that_lists_those_that_are(self):
        with self.assertRaises(ob.ModelError) as caught:
            self.model.with_({"supports.stinger.boxes[no such box].offset": "1 m"})
        self.assertIn("no such box", str(caught.exception))

    def test_all_errors_of_a_file_are_reported(self):
        text = BGL1.read_text(encoding="utf-8").replace("overbend: 1", "overbend: 1\nnonsense: 3\nrubbish: 4")
        with self.assertRaises(ob.ModelError) as caught:
            ob.Model.from_text(text, BGL1)
        self.assertEqual([error.key for error in caught.exception.faults], ["nonsense", "rubbish"])
        self.assertIsInstance(caught.exception, ValueError)

    def test_a_file_that_is_not_there_is_an_error(self):
        with self.assertRaises(ob.ModelError) as caught:
            ob.Model.read("no/such/model.yaml")
        self.assertIn("no/such/model.yaml", str(caught.exception))

    def test_a_model_is_written_and_not_over_another_unasked(self):
        with tempfile.TemporaryDirectory() as folder:
            path = self.model.write(pathlib.Path(folder, "model.yaml"))
            written = ob.Model.read(path)
            self.assertEqual(written.title, self.model.title)
            self.assertEqual(written["tensioner"], self.model["tensioner"])
            with self.assertRaises(FileExistsError):
                self.model.write(path)
            self.model.with_(title="Another").write(path, overwrite=True)
            self.assertIn("Another", path.read_text(encoding="utf-8"))

    def test_a_model_written_elsewhere_finds_the_files_that_it_names(self):
        moored = ob.Model.read(ROOT / "examples" / "moored-barge.yaml")
        with tempfile.TemporaryDirectory() as folder:
            written = ob.Model.read(moored.write(pathlib.Path(folder, "model.yaml")))
            self.assertNotEqual(written.text, moored.text)
            self.assertEqual(len(written.static().moorings), len(moored.static().moorings))

    def test_assumptions_and_warnings_are_sentences(self):
        self.assertTrue(self.model.assumptions)
        self.assertTrue(all(isinstance(sentence, str) for sentence in self.model.assumptions + self.model.warnings))


if __name__ == "__main__":
    unittest.main()
