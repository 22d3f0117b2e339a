"""The package is typed throughout, and users' mistakes are found by mypy before anything runs."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import overbend

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGES = pathlib.Path(overbend.__file__).resolve().parents[1]

RIGHT = """
import overbend as ob

model: ob.Model = ob.Model.read('lay.yaml').with_(title='Another', **{'tensioner.tension': '260 kN'})
static = model.static()
lay_back: float = static.lay_back
run = model.dynamic(duration='600 s', seed=2, progress=True)
names: list[str] = run.histories
try:
    model.static(start=static).save('results')
except ob.NoSolution as error:
    print(error.why)
"""

WRONG = {
    "model.static(begin=static)": 'Unexpected keyword argument "begin"',
    "model.statics()": '"Model" has no attribute "statics"',
    "model.dynamic(duration=[600])": "incompatible type",
    "model.write(5)": "incompatible type",
    "ob.Model.read('lay.yaml').title + 1": "Unsupported operand types",
}


class Types(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.holder.name)

    @classmethod
    def tearDownClass(cls):
        cls.holder.cleanup()

    def mypy(self, *arguments):
        environment = {**os.environ, "MYPYPATH": str(PACKAGES)}
        return subprocess.run(["mypy", "--config-file", str(ROOT / "python" / "mypy.ini"), "--cache-dir",
                               str(self.folder / "cache"), *arguments], capture_output=True, encoding="utf-8", env=environment,
                              cwd=self.folder, check=False)

    def script(self, text):
        path = self.folder / "user.py"
        path.write_text(text, encoding="utf-8")
        return self.mypy(str(path)).stdout

    def test_the_package_is_consistent(self):
        done = self.mypy("-p", "overbend")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_a_right_script_passes(self):
        self.assertIn("Success", self.script(RIGHT))

    def test_wrong_calls_are_found(self):
        reported = self.script(RIGHT + "\n".join(WRONG) + "\n")
        first = RIGHT.count("\n") + 1
        for line, (call, message) in enumerate(WRONG.items(), first):
            found = [item for item in reported.splitlines() if f"user.py:{line}:" in item]
            self.assertTrue(any(message in item for item in found), f"{call}: {found}")

    def test_the_types_of_the_extension_module_are_up_to_date(self):
        done = subprocess.run([sys.executable, str(ROOT / "tools" / "python_stubs.py"), "--check"], capture_output=True,
                              encoding="utf-8", check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_the_package_says_that_it_is_typed(self):
        package = PACKAGES / "overbend"
        self.assertTrue((package / "py.typed").exists() and (package / "_core.pyi").exists())


if __name__ == "__main__":
    unittest.main()
