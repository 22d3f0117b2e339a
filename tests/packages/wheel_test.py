#!/usr/bin/env python3
"""`pip install .` without a network: the wheel, what it says of itself, and that it works in a virtual environment.

    wheel_test.py BUILD-FOLDER
"""

import base64
import csv
import hashlib
import io
import os
import pathlib
import subprocess
import sys
import tarfile
import tempfile
import unittest
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "packages"))

import build_backend  # noqa: E402

# No settings of the user, no network: a proxy at a port without a listener.
CLOSED = {"PATH": os.environ["PATH"], "HOME": "/nonexistent", "PIP_CONFIG_FILE": os.devnull, "PIP_NO_CACHE_DIR": "1",
          "https_proxy": "http://127.0.0.1:9", "http_proxy": "http://127.0.0.1:9",
          "PIP_DISABLE_PIP_VERSION_CHECK": "1", "PIP_ROOT_USER_ACTION": "ignore"}


def run(*arguments, env=CLOSED, cwd="/"):
    return subprocess.run([str(word) for word in arguments], capture_output=True, encoding="utf-8", env=env, cwd=cwd)


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        place = pathlib.Path(cls.folder.name)
        # pip is Debian's, seen through --system-site-packages, like numpy.
        cls.check(run("/usr/bin/python3", "-m", "venv", "--system-site-packages", "--without-pip", place / "venv"))
        cls.python = place / "venv/bin/python"
        settings = f"--config-settings=build-dir={BUILD}"
        cls.check(run(cls.python, "-m", "pip", "wheel", "--no-deps", settings, "-w", place, ROOT))
        cls.wheel = next(place.glob("*.whl"))
        cls.check(run(cls.python, "-m", "pip", "install", "--no-index", cls.wheel))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @staticmethod
    def check(done):
        if done.returncode != 0:
            raise AssertionError(f"{done.args}: exit code {done.returncode}\n{done.stdout}\n{done.stderr}")
        return done.stdout

    def said(self, code):
        return self.check(run(self.python, "-c", code)).strip()

    def test_it_is_of_this_python_and_machine(self):
        python = f"cp{sys.version_info[0]}{sys.version_info[1]}"
        version = self.check(run(BUILD / "overbend", "--version")).split()[1]
        self.assertEqual(self.wheel.name, f"overbend-{version}-{python}-{python}-linux_{os.uname().machine}.whl")

    def test_it_solves_a_lay_in_a_virtual_environment(self):
        model = ROOT / "examples/first-model.yaml"
        self.assertTrue(self.said("import overbend; print(overbend.__file__)").startswith(str(self.python.parents[1])))
        lay_back = self.said(f"import overbend; print(float(overbend.Model.read('{model}').static().lay_back))")
        with tempfile.TemporaryDirectory() as out:
            self.check(run(BUILD / "overbend", "static", model, "-o", out))
            self.assertIn(f"\"lay_back\": {lay_back}", pathlib.Path(out, "summary.json").read_text(encoding="utf-8"))

    def test_pip_knows_version_needs_and_licence(self):
        reported = self.check(run(self.python, "-m", "pip", "show", "overbend"))
        self.assertIn(f"Version: {build_backend.version()}", reported)
        self.assertIn("Requires: numpy", reported)
        self.assertIn("License: MIT", reported)

    def test_its_record_holds_for_every_file(self):
        with zipfile.ZipFile(self.wheel) as archive:
            record = f"overbend-{build_backend.version()}.dist-info/RECORD"
            rows = {row[0]: row[1:] for row in csv.reader(io.StringIO(archive.read(record).decode()))}
            self.assertEqual(sorted(rows), sorted(archive.namelist()))
            for name, (digest, size) in rows.items():
                content = archive.read(name)
                right = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
                self.assertEqual((digest, size), ("", "") if name == record else (f"sha256={right}", str(len(content))))

    def test_it_has_the_package_its_types_and_its_licences_and_nothing_else(self):
        names = zipfile.ZipFile(self.wheel).namelist()
        info = f"overbend-{build_backend.version()}.dist-info"
        self.assertTrue(all(name.startswith(("overbend/", info + "/")) for name in names), names)
        self.assertIn(f"{info}/LICENSE", names)
        sources = {f"overbend/{file.relative_to(ROOT / 'python/overbend')}"
                   for file in (ROOT / "python/overbend").rglob("*") if file.suffix in (".py", ".pyi", ".typed")}
        header = "overbend/include/overbend_controller.h"
        others = {name for name in names if name.startswith("overbend/") and not name.endswith(".so")}
        self.assertEqual(others, sources | {header})
        self.assertEqual(sum(name.endswith(".so") for name in names), 1)

    def test_no_file_names_a_folder_of_the_machine_it_was_built_on(self):
        with zipfile.ZipFile(self.wheel) as archive:
            for name in archive.namelist():
                self.assertFalse(str(ROOT).encode() in archive.read(name), name)

    def test_controllers_in_c_find_their_header(self):
        folder = self.said("import overbend; print(overbend.get_include())")
        self.assertTrue(folder.startswith(str(self.python.parents[1])), folder)
        self.check(run("cc", "-fsyntax-only", "-x", "c", f"{folder}/overbend_controller.h"))

    def test_uninstalling_leaves_nothing(self):
        site = self.python.parents[1] / f"lib/python{sys.version_info[0]}.{sys.version_info[1]}/site-packages"
        self.assertNotEqual(list(site.glob("overbend*")), [])
        try:
            self.check(run(self.python, "-m", "pip", "uninstall", "-y", "overbend"))
            self.assertEqual(list(site.glob("overbend*")), [])
        finally:
            self.check(run(self.python, "-m", "pip", "install", "--no-index", self.wheel))

    def test_an_editable_installation_is_the_package_in_the_build_folder(self):
        pip, settings = (self.python, "-m", "pip"), f"--config-settings=build-dir={BUILD}"
        try:
            self.check(run(*pip, "install", "--no-index", "--no-deps", settings, "-e", ROOT))
            self.assertEqual(self.said("import overbend; print(overbend.__file__)"),
                             str(BUILD / "python/overbend/__init__.py"))
        finally:
            self.check(run(*pip, "install", "--no-index", "--force-reinstall", "--no-deps", self.wheel))


class BackEnd(unittest.TestCase):
    """What does not need a build."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def cache(self, **changes):
        entries = {"CMAKE_HOME_DIRECTORY:INTERNAL": str(ROOT), "OVERBEND_PYTHON:FILEPATH": sys.executable,
                   "OVERBEND_PYTHON_MODULE:BOOL": "ON", "CMAKE_BUILD_TYPE:STRING": "Release"}
        entries.update({name.replace("__", ":"): value for name, value in changes.items()})
        text = "// a comment\n" + "".join(f"{name}={value}\n" for name, value in entries.items())
        (self.folder / "CMakeCache.txt").write_text(text, encoding="utf-8")
        return self.folder

    def test_a_build_of_these_sources_for_this_python_is_used_again(self):
        self.assertTrue(build_backend.fits(self.cache()))

    def test_no_other_build_is_used(self):
        self.assertFalse(build_backend.fits(self.folder / "nothing"))
        self.assertFalse(build_backend.fits(self.cache(CMAKE_HOME_DIRECTORY__INTERNAL="/elsewhere")))
        self.assertFalse(build_backend.fits(self.cache(OVERBEND_PYTHON_MODULE__BOOL="OFF")))
        self.assertFalse(build_backend.fits(self.cache(CMAKE_BUILD_TYPE__STRING="Debug")))
        second = self.folder / "python"
        second.write_text("#!/bin/sh\necho .cpython-399-other.so\n", encoding="utf-8")
        second.chmod(0o755)
        self.assertFalse(build_backend.fits(self.cache(OVERBEND_PYTHON__FILEPATH=str(second))))
        self.assertFalse(build_backend.fits(self.cache(OVERBEND_PYTHON__FILEPATH="/nowhere/python3")))

    def test_a_machine_without_cmake_shows_what_to_install(self):
        before = os.environ["PATH"]
        os.environ["PATH"] = str(self.folder)
        try:
            with self.assertRaisesRegex(build_backend.BuildFailed, "cmake is not installed.*scripts/install.sh"):
                build_backend.configure(self.folder / "build")
        finally:
            os.environ["PATH"] = before

    def test_a_build_that_fails_says_which_command_did(self):
        with self.assertRaisesRegex(build_backend.BuildFailed, "`false --now` failed"):
            build_backend.run("false", "--now")

    @unittest.skipUnless((ROOT / ".git").exists(), "these sources are no clone")
    def test_a_source_archive_has_what_the_build_needs(self):
        with tarfile.open(self.folder / build_backend.build_sdist(self.folder)) as archive:
            names = set(archive.getnames())
        top = f"overbend-{build_backend.version()}"
        for name in ("PKG-INFO", "pyproject.toml", "packages/build_backend.py", "CMakeLists.txt",
                     "web/package-lock.json", "python/overbend/__init__.py"):
            self.assertIn(f"{top}/{name}", names)
        self.assertFalse([name for name in names if name.startswith((f"{top}/build/", f"{top}/.git/"))])

    def test_metadata_has_version_and_readme(self):
        name = build_backend.prepare_metadata_for_build_wheel(self.folder)
        text = (self.folder / name / "METADATA").read_text(encoding="utf-8")
        self.assertIn(f"Version: {build_backend.version()}\n", text)
        self.assertTrue(text.endswith((ROOT / "README.md").read_text(encoding="utf-8")))


if __name__ == "__main__":
    unittest.main()
