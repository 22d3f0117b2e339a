#!/usr/bin/env python3
"""Tests the program of an archive where it will run.

    program_test.py linux ARCHIVE      in a root with nothing but the archive: no libraries, no /proc, no /tmp, no /etc
    program_test.py aarch64 ARCHIVE    under qemu
    program_test.py windows ARCHIVE    under wine

OVERBEND_PROGRAM: the program of this machine, with which results are compared.
"""

import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.error
import urllib.request

KIND = sys.argv[1]
ARCHIVE = pathlib.Path(sys.argv[2]).resolve()
del sys.argv[1:]
LINUX, WINDOWS = KIND == "linux", KIND == "windows"
NATIVE = os.environ.get("OVERBEND_PROGRAM")
# Another root needs the rights of root, in a namespace of its own if need be.
ENTER = ["chroot"] if os.geteuid() == 0 else ["unshare", "--map-root-user", "chroot"]


WINE = next((name for name in ("/usr/lib/wine/wine64", "/usr/bin/wine64", "/usr/bin/wine") if os.path.exists(name)), "wine64")


def without_times(value):
    """A summary without what depends on the machine and the moment."""
    if isinstance(value, dict):
        return {key: without_times(inner) for key, inner in value.items()
                if not re.search("wall|real_time|program|written|machine|version|seconds", key)}
    return [without_times(inner) for inner in value] if isinstance(value, list) else value


def largest(value):
    """Largest number of a list or matrix; 0 of anything else."""
    if isinstance(value, list):
        return max(map(largest, value), default=0.0)
    return abs(value) if isinstance(value, float) else 0.0


class Program(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        subprocess.run(["cmake", "-E", "tar", "xf", ARCHIVE], cwd=cls.folder.name, check=True)
        cls.root = pathlib.Path(cls.folder.name, "overbend")
        cls.environment = dict(os.environ)
        if LINUX:
            cls.command = [*ENTER, str(cls.root), "/overbend"]
        elif WINDOWS:
            cls.command = [WINE, str(cls.root / "overbend.exe")]
            cls.environment.update(WINEDEBUG="-all", LC_ALL="C.UTF-8", WINEPREFIX=str(pathlib.Path(cls.folder.name, "wine")))
        else:
            cls.command = ["qemu-aarch64", str(cls.root / "overbend")]

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def path(self, name):
        """A path as the program sees it."""
        if WINDOWS:
            return "Z:" + str(self.root / name).replace("/", "\\")
        return f"/{name}" if LINUX else str(self.root / name)

    def start(self, *arguments):
        return subprocess.Popen([*self.command, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                encoding="utf-8", env=self.environment)

    def run_program(self, *arguments, code=0):
        """What the program says; `code` is its exit code, None for any but 0."""
        process = self.start(*arguments)
        said, _ = process.communicate(timeout=900)
        if code is None:
            self.assertNotEqual(process.returncode, 0, said)
        else:
            self.assertEqual(process.returncode, code, said)
        return said

    def summary(self, folder):
        return json.loads((self.root / folder / "summary.json").read_text(encoding="utf-8"))

    @unittest.skipIf(WINDOWS, "there are only libraries of the system")
    def test_the_program_is_one_file_without_libraries(self):
        said = subprocess.run(["file", self.root / "overbend"], capture_output=True, text=True, check=True).stdout
        self.assertRegex(said, "static-pie linked|statically linked")

    def compare(self, ours, theirs, place="", rounding=1e-7):
        """Same bits on Linux; elsewhere 1e-9 of the value, or what rounding leaves of a zero."""
        if isinstance(theirs, dict):
            if theirs.get("units") in ("N", "N m"):  # differences of forces of up to 1 MN
                rounding = 1e-5
            self.assertEqual(ours.keys(), theirs.keys(), place)
            for key, value in theirs.items():
                self.compare(ours[key], value, f"{place}/{key}", rounding)
        elif isinstance(theirs, list):
            self.assertEqual(len(ours), len(theirs), place)
            rounding = max(rounding, 1e-12 * largest(theirs))
            for i, value in enumerate(theirs):
                self.compare(ours[i], value, f"{place}/{i}", rounding)
        elif not LINUX and re.search("residual|imbalance|iterations|history", place):
            pass
        elif isinstance(theirs, str):
            ours = ours.replace("\\", "/").replace(f"Z:{self.root}", "") if WINDOWS else ours.replace(str(self.root), "")
            self.assertEqual(ours, theirs.replace(str(self.root), ""), place)
        elif LINUX or not isinstance(theirs, float):
            self.assertEqual(ours, theirs, place)
        else:
            self.assertLessEqual(abs(ours - theirs), max(1e-9 * abs(theirs), rounding), f"{place}: {ours}, {theirs}")

    def compare_with_native(self, folder, *arguments):
        """Compares the summary in `folder` with that of the program of this machine, run with the same arguments."""
        if not NATIVE:
            return
        with tempfile.TemporaryDirectory() as work:
            subprocess.run([NATIVE, *arguments, "-o", f"{work}/out"], check=True, capture_output=True)
            native = json.loads(pathlib.Path(work, "out/summary.json").read_text(encoding="utf-8"))
        self.compare(without_times(self.summary(folder)), without_times(native), folder)

    def test_statics_equal_those_of_the_shared_build(self):
        for model in ("bgl1", "jlay", "moored-barge"):
            self.run_program("static", self.path(f"examples/{model}.yaml"), "-o", self.path(f"out-{model}"))
            self.compare_with_native(f"out-{model}", "static", self.root / f"examples/{model}.yaml")

    def test_a_killed_run_resumes(self):
        model = self.path("examples/bgl1.yaml")
        arguments = ("dynamic", model, "--duration", "40 s", "--checkpoint", "1", "-o", self.path("killed"))
        process = self.start(*arguments)
        until = time.monotonic() + 300
        while time.monotonic() < until and not list((self.root / "killed").glob(".*/checkpoint*")) and not list(
                (self.root / "killed").glob("**/*checkpoint*")) and process.poll() is None:
            time.sleep(0.05)
        process.send_signal(signal.SIGKILL)
        process.communicate()
        self.run_program(*arguments, "--resume")
        self.assertEqual(self.summary("killed")["dynamic"]["duration"], 40.0)
        if LINUX:  # elsewhere impacts amplify rounding
            self.compare_with_native("killed", "dynamic", self.root / "examples/bgl1.yaml", "--duration", "40 s")

    @unittest.skipIf(KIND == "aarch64", "takes hours under the emulator")
    def test_seeds_and_a_study_use_all_cores_without_proc(self):
        text = (self.root / "examples/bgl1.yaml").read_text(encoding="utf-8")
        (self.root / "examples/seeds.yaml").write_text(text.replace("  dynamic: {", "  dynamic: {seeds: 2, "), encoding="utf-8")
        self.run_program("dynamic", self.path("examples/seeds.yaml"), "--duration", "5 s", "-o", self.path("seeds"))
        self.assertEqual(len(list((self.root / "seeds").glob("*/summary.json"))), 2)
        (self.root / "examples/tensions.yaml").write_text(
            "overbend_study: 1\nbase: first-model.yaml\nanalysis: static\naxes:\n"
            "  - {key: tensioner.tension, values: [240 kN, 250 kN, 260 kN]}\n", encoding="utf-8")
        self.run_program("study", self.path("examples/tensions.yaml"), "-o", self.path("study"))
        table = self.cases("study")
        self.assertEqual(len(table), 4)
        self.run_program("study", self.path("examples/tensions.yaml"), "--dry-run", "-o", self.path("study-dry"))
        for task in ("0/2", "1/2"):  # what tasks of a Slurm job run
            self.run_program("study", self.path("examples/tensions.yaml"), "--tasks", task, "-o", self.path("tasks"))
        self.run_program("study", self.path("examples/tensions.yaml"), "--gather", "-o", self.path("tasks"))
        self.assertEqual(self.cases("tasks"), table)

    def cases(self, folder):
        lines = (self.root / folder / "study.csv").read_text(encoding="utf-8").splitlines()
        return [line.rsplit(",", 1)[0] for line in lines]  # without the time that a case took

    @unittest.skipIf(WINDOWS, "a limit of POSIX")
    def test_a_full_disk_leaves_no_half_of_a_result(self):
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))  # met like a full disk
        done = subprocess.run([*self.command, "static", self.path("examples/bgl1.yaml"), "-o", self.path("full")],
                              capture_output=True, text=True, env=self.environment, preexec_fn=limit)
        self.assertNotEqual(done.returncode, 0)
        self.assertRegex(done.stderr, "(?i)too large|no space")
        self.assertFalse((self.root / "full" / "summary.json").exists())

    @unittest.skipUnless(WINDOWS and os.geteuid() == 0, "needs the rights of root: a small disk is mounted")
    def test_a_full_disk_under_wine_leaves_no_half_of_a_result(self):
        small = self.root / "small"
        small.mkdir()
        subprocess.run(["mount", "-t", "tmpfs", "-o", "size=200k", "tmpfs", small], check=True)
        try:
            said = self.run_program("static", self.path("examples/bgl1.yaml"), "-o", self.path("small/full"), code=None)
            self.assertRegex(said, "(?i)no space|disk full|not enough space")
            self.assertFalse((small / "full" / "summary.json").exists())
        finally:
            subprocess.run(["umount", "--lazy", small], check=True)

    def test_ctrl_c_leaves_a_run_that_resumes(self):
        arguments = ("dynamic", self.path("examples/bgl1.yaml"), "--duration", "30 s", "--checkpoint", "1", "-o", self.path("interrupted"))
        process = self.start(*arguments)
        until = time.monotonic() + 300
        while time.monotonic() < until and not list((self.root / "interrupted").glob("**/*checkpoint*")) and process.poll() is None:
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        said, _ = process.communicate(timeout=300)
        self.assertEqual(process.returncode, 130, said)
        self.assertIn("--resume", said)
        self.run_program(*arguments, "--resume")
        self.assertEqual(self.summary("interrupted")["dynamic"]["duration"], 30.0)

    @unittest.skipUnless(WINDOWS, "a terminal of its own is given by Windows")
    def test_a_double_click_opens_the_page(self):
        with tempfile.TemporaryDirectory() as work:  # wine hands addresses to xdg-open
            browser = pathlib.Path(work, "xdg-open")
            browser.write_text(f'#!/bin/sh\necho "$1" > {work}/part && mv {work}/part {work}/address\n', encoding="utf-8")
            browser.chmod(0o755)
            environment = dict(self.environment, PATH=f"{work}:{os.environ['PATH']}")
            process = subprocess.Popen([WINE, "start", "/wait", self.path("overbend.exe")], env=environment)
            try:
                until = time.monotonic() + 120
                while time.monotonic() < until and not pathlib.Path(work, "address").exists():
                    time.sleep(0.1)
                address = pathlib.Path(work, "address").read_text(encoding="utf-8").strip()
                self.assertRegex(address, r"^http://127\.0\.0\.1:\d+/open/\w+$")
                # This process is none of wine's, which knows its user; a browser of Windows is let in.
                with self.assertRaises(urllib.error.HTTPError) as rejected:
                    urllib.request.urlopen(address)
                self.assertEqual(rejected.exception.code, 403)
                self.assertIn(b"belongs to another user", rejected.exception.read())
            finally:
                subprocess.run([WINE, "taskkill", "/f", "/im", "overbend.exe"], env=environment, check=False)
                process.wait(timeout=60)

    @unittest.skipUnless(WINDOWS, "paths of Windows")
    def test_names_outside_ascii_work(self):
        folder = "Ærø-øre-Ölfeld-日本-𝄞"
        (self.root / folder).mkdir()
        text = (self.root / "examples/first-model.yaml").read_text(encoding="utf-8")
        (self.root / folder / "Modèle.yaml").write_text(text, encoding="utf-8")
        self.run_program("static", self.path(f"{folder}/Modèle.yaml"), "-o", self.path(f"{folder}/résultats"))
        self.assertEqual(self.summary(f"{folder}/résultats")["status"], "converged")
        self.assertTrue((self.root / folder / "résultats" / "results.h5").exists())

    @unittest.skipUnless(WINDOWS, "paths of Windows")
    def test_paths_above_260_characters_work(self):
        folder = "/".join(["a" * 60] * 5)
        (self.root / folder).mkdir(parents=True)
        text = (self.root / "examples/first-model.yaml").read_text(encoding="utf-8")
        (self.root / folder / "model.yaml").write_text(text, encoding="utf-8")
        for _ in range(2):  # the second run replaces the results of the first, which it lists
            self.run_program("static", self.path(f"{folder}/model.yaml"), "-o", self.path(f"{folder}/results"))
        self.assertEqual(self.summary(f"{folder}/results")["status"], "converged")

    @unittest.skipIf(KIND == "aarch64", "takes long under the emulator")
    def test_serve_answers_with_the_page_and_statics(self):
        process = self.start("serve", self.path("examples/bgl1.yaml"), "--no-browser")
        try:
            address = ""
            while not address:
                line = process.stdout.readline()
                self.assertNotEqual(line, "", "the program has ended")
                found = re.search(r"(http://127\.0\.0\.1:\d+)/\?token=(\w+)", line)
                address, token = found.groups() if found else ("", "")
            page = urllib.request.urlopen(f"{address}/?token={token}").read()
            self.assertIn(b"Overbend", page)
            for path, body in (("static", b"{}"), ("lay-table", b'{"vary": "tension", "range": "240 kN..260 kN/3"}')):
                request = urllib.request.Request(f"{address}/api/{path}", body,
                                                 {"X-Overbend-Token": token, "Content-Type": "application/json"})
                try:
                    self.assertEqual(urllib.request.urlopen(request).status, 200)
                except urllib.error.HTTPError as error:
                    self.fail(f"{path}: {error.read()}")
        finally:
            process.send_signal(signal.SIGINT)
            process.communicate(timeout=60)


unittest.main(verbosity=2)
