"""Files with bytes that do not belong there: errors that name the file, never a traceback about bytes."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import overbend as ob
from lays import ROOT, small_lay
from test_operation import OPERATION

DATA = ROOT / "data"


class Bytes(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)

    def tearDown(self):
        self.holder.cleanup()

    def lay(self, name, content, **keys):
        """The error of a lay that names the file with that content."""
        (self.folder / name).write_bytes(content)
        (self.folder / "lay.yaml").write_text(small_lay().text, encoding="utf-8")
        waves = {"environment.waves": {"type": "jonswap", "hs": "1 m", "tp": "7 s", "from": "60 deg"}}
        with self.assertRaises(ob.ModelError) as raised:
            ob.Model.read(self.folder / "lay.yaml").with_({**waves, **keys})
        self.assertIn(name, str(raised.exception))
        return raised.exception

    def test_a_history_names_its_line(self):
        error = self.lay("f.csv", b"time_s,heave_m\n0,0\n1,\xc65\n", **{"vessel.motion": {"history": "f.csv"}})
        self.assertEqual(error.line, 3)
        self.assertIn("'\\xc65'", error.found)

    def test_raos_do(self):
        raos = (DATA / "bgl1" / "rao.csv").read_bytes().replace(b"\n", b"\n\xff", 3)
        self.lay("f.csv", raos, **{"vessel.motion": {"raos": "f.csv"}})

    def test_spectra_do(self):
        waves = {"type": "user", "spectrum_file": "f.csv", "from": "60 deg"}
        error = self.lay("f.csv", b"omega_rad_s,density_m2s\n0.1,\xe2\x82\n", **{"environment.waves": waves})
        self.assertEqual(error.line, 2)

    def test_depths_do(self):
        error = self.lay("f.csv", b"east,north,depth\n0,0,4\xc60\n", **{"environment.seabed.bathymetry": "f.csv"})
        self.assertIn("\\xc6", error.found)

    def test_the_model_itself_does(self):
        for byte in (b"\xc6", b"\xed\xa0\x80"):  # a surrogate is no character either
            (self.folder / "lay.yaml").write_bytes(small_lay().text.encode().replace(b"title: ", b"title: " + byte, 1))
            with self.assertRaisesRegex(ob.ModelError, "lay.yaml.*UTF-8"):
                ob.Model.read(self.folder / "lay.yaml")

    def test_the_terminal_prints_valid_text(self):
        (self.folder / "f.csv").write_bytes(b"time_s,heave_m\n0,0\n1,\xc65\n")
        text = small_lay().text.replace("vessel:\n", "vessel:\n  motion: {history: f.csv}\n", 1)
        (self.folder / "lay.yaml").write_text(text, encoding="utf-8")
        done = subprocess.run([os.environ["OVERBEND_PROGRAM"], "check", self.folder / "lay.yaml"], capture_output=True,
                              check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("\\xc65", done.stderr.decode("utf-8"))


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.holder.name)
        model = small_lay().with_({"operation": OPERATION})
        model.operation().save(cls.folder / "operation")
        small_lay().static().save(cls.folder / "static")

    @classmethod
    def tearDownClass(cls):
        cls.holder.cleanup()

    def damaged(self, kind, file, change):
        shutil.rmtree(self.folder / "damaged", ignore_errors=True)
        shutil.copytree(self.folder / kind, self.folder / "damaged")
        path = self.folder / "damaged" / file
        path.write_bytes(change(path.read_bytes()))
        return self.folder / "damaged"

    def assert_rejected(self, kind, file, change):
        with self.assertRaises(ob.ResultsError) as raised:
            results = ob.open(self.damaged(kind, file, change))
            results.static if kind == "operation" else results.pipe
        self.assertIn("damaged", str(raised.exception))

    def test_of_operations_and_lays_are_results_errors(self):
        def middle(content):
            return content[:len(content) // 2] + bytes([content[len(content) // 2] ^ 1]) + content[len(content) // 2 + 1:]

        for kind in ("operation", "static"):
            for change in (middle, lambda content: content[:-100], lambda content: b"", lambda content: b"\xff" * 100):
                self.assert_rejected(kind, "results.h5", change)

    def test_of_summaries_too(self):
        for change in (lambda content: b"\xff" + content, lambda content: content[:50], lambda content: b"[]",
                       lambda content: b"null"):
            self.assert_rejected("operation", "summary.json", change)

    def test_comparisons_name_the_folder(self):
        folder = self.damaged("static", "results.h5", lambda content: content[:1000])
        with self.assertRaisesRegex(ob.ResultsError, "damaged"):
            ob.compare_folders([self.folder / "static", folder])


if __name__ == "__main__":
    unittest.main()
