#!/usr/bin/env python3
"""The Debian packages: what is in them, what they need, and that they work from where they are unpacked.

    debian_test.py BUILD-FOLDER
"""

import gzip
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
PYTHON = "usr/lib/python3/dist-packages"


def said(*arguments, **more):
    """What a program prints; its failure is that of the test."""
    done = subprocess.run([str(word) for word in arguments], capture_output=True, encoding="utf-8", **more)
    if done.returncode != 0:
        raise AssertionError(f"{arguments}: exit code {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done.stdout


def list_libraries(file):
    return re.findall(r"NEEDED.*\[(.*)\]", said("readelf", "--dynamic", file))


def find_package(library):
    """The Debian package that brings a shared library on this machine."""
    reported = said("dpkg-query", "--search", f"*/{sysconfig.get_config_var('MULTIARCH')}/{library}")
    return reported.split(":")[0]


class DebianPackages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        place = pathlib.Path(cls.folder.name)
        said("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", place / "made", "-D",
             "CPACK_DEBIAN_COMPRESSION_TYPE=gzip", cwd=BUILD, umask=0o077)
        cls.packages = {said("dpkg-deb", "--field", file, "Package").strip(): file
                        for file in (place / "made").glob("*.deb")}
        cls.root = place / "root"
        for file in cls.packages.values():
            said("dpkg-deb", "--extract", file, cls.root)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def field(self, package, name):
        return said("dpkg-deb", "--field", self.packages[package], name).strip()

    def contents(self, package):
        """Mode, owner and name of every entry."""
        return [(line.split()[0], line.split()[1], line.split(maxsplit=5)[5].removeprefix("./"))
                for line in said("dpkg-deb", "--contents", self.packages[package]).splitlines()]

    def test_there_are_two_with_names_that_debian_expects(self):
        version, machine = self.field("overbend", "Version"), said("dpkg", "--print-architecture").strip()
        self.assertEqual({name: file.name for name, file in self.packages.items()},
                         {name: f"{name}_{version}_{machine}.deb" for name in ("overbend", "python3-overbend")})

    def test_the_program_runs_from_where_it_is_unpacked(self):
        version = self.field("overbend", "Version")
        self.assertEqual(said(self.root / "usr/bin/overbend", "--version").strip(), f"overbend {version}")
        examples = self.root / "usr/share/doc/overbend/examples"
        said(self.root / "usr/bin/overbend", "check", examples / "moored-barge.yaml")

    def test_the_python_package_solves_a_lay_from_where_it_is_unpacked(self):
        model = self.root / "usr/share/doc/overbend/examples/first-model.yaml"
        code = ("import overbend; model = overbend.example('first-model.yaml'); "
                "print(overbend.__file__, model, overbend.Model.read(model).static().lay_back)")
        env = {**os.environ, "PYTHONPATH": str(self.root / PYTHON), "PYTHONDONTWRITEBYTECODE": "1"}
        where, found, lay_back = said("/usr/bin/python3", "-c", code, env=env, cwd="/").split()
        self.assertEqual(pathlib.Path(where), self.root / PYTHON / "overbend/__init__.py")
        self.assertEqual(pathlib.Path(found), model)
        with tempfile.TemporaryDirectory() as out:
            reported = said(self.root / "usr/bin/overbend", "static", model, "-o", out)
            summary = pathlib.Path(out, "summary.json").read_text(encoding="utf-8")
        self.assertIn(f"\"lay_back\": {float(lay_back)}", summary, reported)

    def test_they_need_the_packages_of_their_libraries(self):
        module = next((self.root / PYTHON / "overbend").glob("_core*.so"))
        for package, file in (("overbend", self.root / "usr/bin/overbend"), ("python3-overbend", module)):
            needs = re.findall(r"(?:^|, )([^ ,|]+)", self.field(package, "Depends"))
            for library in list_libraries(file):
                self.assertIn(find_package(library), needs, f"{package} uses {library}")
        depends = self.field("python3-overbend", "Depends")
        minor = sys.version_info[1]
        for need in ("python3-numpy", f"python3 (>= 3.{minor}~)", f"python3 (<< 3.{minor + 1})"):
            self.assertIn(need, depends)
        self.assertIn("python3-xarray", self.field("python3-overbend", "Recommends"))

    def test_they_say_who_made_them_and_what_they_are(self):
        for package, section in (("overbend", "science"), ("python3-overbend", "python")):
            self.assertEqual(self.field(package, "Section"), section)
            self.assertRegex(self.field(package, "Maintainer"), r"^.+ <.+@.+>$")
            first, *rest = self.field(package, "Description").splitlines()
            self.assertLess(len(first), 80)
            self.assertTrue(rest and all(line.startswith(" ") for line in rest), rest)

    def test_manual_page_completions_documents_and_licences_are_in_their_places(self):
        share = self.root / "usr/share"
        self.assertIn(".TH OVERBEND", gzip.open(share / "man/man1/overbend.1.gz", "rt", encoding="utf-8").read())
        for name in ("bash-completion/completions/overbend", "zsh/site-functions/_overbend",
                     "doc/overbend/docs/input.md", "doc/overbend/docs/guide/README.md",
                     "doc/overbend/examples/bgl1.yaml"):
            self.assertTrue((share / name).is_file(), name)
        for package in self.packages:
            self.assertIn("MIT", (share / "doc" / package / "copyright").read_text(encoding="utf-8"))
            reported = said("dpkg-parsechangelog", "--show-field", "Version", "-l-",
                        input=gzip.open(share / "doc" / package / "changelog.gz", "rt", encoding="utf-8").read())
            self.assertEqual(reported.strip(), self.field(package, "Version"))

    def test_files_are_roots_and_no_user_but_root_may_write_them(self):
        for package in self.packages:
            for mode, owner, name in self.contents(package):
                self.assertEqual(owner, "root/root", name)
                runs = mode.startswith("d") or name == "usr/bin/overbend"
                wanted = ("drwxr-xr-x",) if mode.startswith("d") else ("-rwxr-xr-x",) if runs else ("-rw-r--r--",)
                self.assertIn(mode, wanted, name)

    def test_no_file_names_a_folder_of_the_machine_it_was_built_on(self):
        build_paths = {str(ROOT).encode(), str(BUILD).encode()}
        for file in self.root.rglob("*"):
            if file.is_file():
                content = file.read_bytes()
                self.assertFalse([path for path in build_paths if path in content], file.relative_to(self.root))

    def test_what_is_run_is_stripped(self):
        for file in (self.root / "usr/bin/overbend", next((self.root / PYTHON / "overbend").glob("_core*.so"))):
            self.assertNotIn(".symtab", said("readelf", "--sections", "--wide", file))

    def test_installing_compiles_the_package_and_removing_leaves_nothing(self):
        with tempfile.TemporaryDirectory() as control:
            said("dpkg-deb", "--control", self.packages["python3-overbend"], control)
            for script, tool in (("postinst", "py3compile"), ("prerm", "py3clean")):
                file = pathlib.Path(control, script)
                said("sh", "-n", file)
                self.assertIn(f"{tool} -p python3-overbend", file.read_text(encoding="utf-8"))
                self.assertEqual(file.stat().st_mode & 0o777, 0o755)
            self.assertTrue(pathlib.Path(control, "md5sums").is_file())


if __name__ == "__main__":
    unittest.main()
