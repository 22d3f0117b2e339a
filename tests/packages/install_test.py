#!/usr/bin/env python3
"""A build installed into a folder of its own: everything lies where shells, man and Python look for it.

    install_test.py BUILD-FOLDER
"""

import gzip
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
WITH_PYTHON = any((BUILD / "python" / "overbend").glob("_core*.so"))
sys.path.insert(0, str(ROOT / "packages"))
sys.dont_write_bytecode = True

from python_folder import folder_below  # noqa: E402


def said(*arguments, **more):
    """What a program prints; its failure is that of the test."""
    done = subprocess.run([str(word) for word in arguments], capture_output=True, encoding="utf-8", **more)
    if done.returncode != 0:
        raise AssertionError(f"{arguments}: exit code {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done.stdout


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.prefix = pathlib.Path(cls.folder.name, "somewhere")
        cls.documents = cls.prefix / "share" / "doc" / "overbend"
        said("cmake", "--install", BUILD, "--prefix", cls.prefix)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_the_program_runs(self):
        self.assertTrue(said(self.prefix / "bin" / "overbend", "--version").startswith("overbend "))

    def test_shells_find_the_completions(self):
        for name, mark in (("bash-completion/completions/overbend", "complete -F _overbend"),
                           ("zsh/site-functions/_overbend", "#compdef overbend")):
            self.assertIn(mark, (self.prefix / "share" / name).read_text(encoding="utf-8"))

    def test_man_finds_the_manual_page(self):
        self.assertIn(".TH OVERBEND", gzip.open(self.prefix / "share/man/man1/overbend.1.gz", "rt", encoding="utf-8").read())

    def test_links_of_the_documents_lead_to_what_is_installed(self):
        dead = []
        for page in self.documents.rglob("*.md"):
            prose = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.M | re.S)
            for target in re.findall(r"\]\(([^)#\s]+)", prose):
                linked = (page.parent / target).resolve()
                of_the_sources = linked == self.documents.resolve() / "validation" / "README.md"
                if "://" not in target and not linked.exists() and not of_the_sources:
                    dead.append(f"{page.relative_to(self.documents)}: {target}")
        self.assertEqual(dead, [])
        self.assertTrue((self.documents / "docs" / "guide" / "installation.md").is_file())

    def test_examples_find_the_files_that_they_name(self):
        for name in ("bgl1.yaml", "moored-barge.yaml"):
            said(self.prefix / "bin" / "overbend", "check", self.documents / "examples" / name)

    def test_licences_of_what_is_compiled_in_are_there(self):
        text = (self.documents / "copyright").read_text(encoding="utf-8")
        for name in ("Overbend developers", "Eigen", "CLI11", "pybind11", "preact "):
            self.assertIn(name, text)

    def test_a_component_may_be_installed_alone(self):
        with tempfile.TemporaryDirectory() as alone:
            said("cmake", "--install", BUILD, "--prefix", alone, "--component", "program")
            self.assertTrue(pathlib.Path(alone, "bin", "overbend").is_file())
            self.assertFalse(pathlib.Path(alone, "lib").exists())

    @unittest.skipUnless(WITH_PYTHON, "this build has no Python package")
    def test_python_finds_the_package_and_what_it_says_of_itself(self):
        place = self.prefix / folder_below(str(self.prefix))
        code = "import overbend, importlib.metadata as m; print(overbend.__file__, m.version('overbend'))"
        reported = said("/usr/bin/python3", "-c", code, env={**os.environ, "PYTHONPATH": str(place)}, cwd="/")
        where, version = reported.split()
        self.assertEqual(pathlib.Path(where), place / "overbend" / "__init__.py")
        self.assertEqual("overbend " + version, said(self.prefix / "bin" / "overbend", "--version").strip())

    @unittest.skipUnless(WITH_PYTHON, "this build has no Python package")
    def test_python_finds_the_examples_that_are_installed_with_it(self):
        place = self.prefix / folder_below(str(self.prefix))
        reported = said("/usr/bin/python3", "-c", "import overbend; print(overbend.example('bgl1.yaml'))",
                    env={**os.environ, "PYTHONPATH": str(place)}, cwd="/")
        self.assertEqual(pathlib.Path(reported.strip()), self.documents / "examples" / "bgl1.yaml")

    @unittest.skipUnless(WITH_PYTHON, "this build has no Python package")
    def test_a_home_folder_needs_no_pythonpath(self):
        with tempfile.TemporaryDirectory() as home:
            said("cmake", "--install", BUILD, "--prefix", f"{home}/.local", "--component", "python")
            env = {"PATH": os.environ["PATH"], "HOME": home}
            reported = said("/usr/bin/python3", "-c", "import overbend; print(overbend.__file__)", env=env, cwd="/")
            self.assertTrue(reported.startswith(f"{home}/.local/"), reported)


class Folders(unittest.TestCase):
    def test_packages_lie_where_debians_python_looks(self):
        version = f"python{sys.version_info[0]}.{sys.version_info[1]}"
        self.assertEqual(folder_below("/usr"), "lib/python3/dist-packages")
        self.assertEqual(folder_below("/usr/local"), f"lib/{version}/dist-packages")
        self.assertEqual(folder_below("/home/anna/.local"), f"lib/{version}/site-packages")
        self.assertEqual(folder_below(sys.prefix + "/venv"), f"lib/{version}/site-packages")


if __name__ == "__main__":
    unittest.main()
