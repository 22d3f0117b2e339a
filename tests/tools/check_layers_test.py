"""The layer check must catch what it is there for: each test plants one include in an otherwise clean tree."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOL = pathlib.Path(__file__).resolve().parents[2] / "tools" / "check_layers.py"

CLEAN = {
    "base/units.cpp": ["#include <yaml-cpp/yaml.h>", "#include <vector>"],
    "model/model.h": ['#include "base/vec.h"', "#include <Eigen/Core>"],
    "mechanics/rod.cpp": ['#include "model/model.h"', '#include "mechanics/rod.h"'],
    "modelfile/reading/reader.cpp": ["#include <yaml-cpp/yaml.h>", "#include \"seafiles/rao.h\""],
    "resultfiles/hdf5/writer.cpp": ["#include <hdf5.h>", "#include <xlsxwriter.h>", "#include \"results/fields.h\""],
    "platform/posix/file.cpp": ['#include "platform/file.h"', "#include <unistd.h>", "#include <sys/stat.h>"],
    "platform/windows/file.cpp": ['#include "platform/windows/system.h"', "#include <windows.h>"],
    "app/main.cpp": ['#include "statics/solver/statics.h"', "#include <CLI/CLI.hpp>"],
}


def run_on(files):
    """Exit code and output of the check on a tree of files given as {path under src/overbend: lines}."""
    with tempfile.TemporaryDirectory() as folder:
        for name, lines in files.items():
            path = pathlib.Path(folder, "src", "overbend", name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        run = subprocess.run([sys.executable, str(TOOL), folder], capture_output=True, encoding="utf-8", check=False)
        return run.returncode, run.stdout


class CheckLayers(unittest.TestCase):
    def assert_caught(self, name, include, line=2):
        code, output = run_on({**CLEAN, name: ["#pragma once", include]})
        self.assertEqual(code, 1, output)
        self.assertIn(f"src/overbend/{name}:{line}: ", output)
        self.assertIn("1 offences", output)

    def test_a_clean_tree_passes(self):
        code, output = run_on(CLEAN)
        self.assertEqual(code, 0, output)

    def test_an_upward_include_is_caught(self):
        self.assert_caught("model/bad.h", '#include "statics/solver/statics.h"')

    def test_an_analysis_that_knows_its_checks_or_its_recorder_is_caught(self):
        self.assert_caught("statics/solver/bad.cpp", '#include "checks/run_checks.h"')
        self.assert_caught("dynamics/run/bad.cpp", '#include "recording/pipe_recorder.h"')

    def test_a_sideways_include_is_caught(self):
        self.assert_caught("numerics/bad.h", '#include "model/model.h"')

    def test_an_include_of_a_later_sub_room_is_caught(self):
        self.assert_caught("statics/equations/bad.cpp", '#include "statics/solver/statics.h"')
        self.assert_caught("model/pipe/bad.h", '#include "model/model.h"')

    def test_an_include_of_an_earlier_sub_room_passes(self):
        code, output = run_on({**CLEAN, "statics/solver/good.cpp": ['#include "statics/equations/static_system.h"']})
        self.assertEqual(code, 0, output)

    def test_a_file_next_to_the_sub_rooms_is_caught(self):
        self.assert_caught("statics/bad.cpp", "#include <vector>", line=1)
        self.assert_caught("statics/elsewhere/bad.cpp", "#include <vector>", line=1)

    def test_a_spaced_include_is_caught(self):
        self.assert_caught("base/bad.h", '  #  include "model/model.h"')

    def test_yaml_outside_the_files_read_is_caught(self):
        self.assert_caught("model/bad.cpp", "#include <yaml-cpp/yaml.h>")

    def test_hdf5_outside_result_files_is_caught(self):
        self.assert_caught("system/bad.cpp", "#include <hdf5_hl.h>")

    def test_udunits_is_caught_everywhere(self):
        self.assert_caught("base/bad.cpp", "#include <udunits2.h>")

    def test_an_unplanned_library_is_caught(self):
        self.assert_caught("system/bad.cpp", "#include <boost/any.hpp>")

    def test_a_header_of_an_operating_system_outside_its_sources_is_caught(self):
        for header in ("unistd.h", "sys/stat.h", "fcntl.h", "poll.h", "netinet/in.h", "csignal", "signal.h", "dlfcn.h", "windows.h"):
            self.assert_caught("runstore/bad.cpp", f"#include <{header}>")
        self.assert_caught("platform/bad.h", "#include <unistd.h>")
        self.assert_caught("platform/posix/bad.cpp", "#include <winsock2.h>")
        self.assert_caught("platform/windows/bad.cpp", "#include <unistd.h>")

    def test_a_function_of_an_operating_system_outside_platform_is_caught(self):
        for line in ("std::thread::hardware_concurrency();", "localtime_r(&time, &local);", "mkdtemp(name.data());",
                     "fs::temp_directory_path();", 'std::ifstream lines("/proc/net/tcp");'):
            self.assert_caught("serve/http/bad.cpp", line)

    def test_platform_includes_no_other_room(self):
        self.assert_caught("platform/bad.cpp", '#include "base/require.h"')
        self.assert_caught("model/bad.cpp", '#include "platform/file.h"')

    def test_a_relative_include_is_caught(self):
        self.assert_caught("model/bad.cpp", '#include "section.h"')

    def test_a_file_outside_the_layers_is_caught(self):
        self.assert_caught("misc/bad.h", "#include <vector>", line=1)

    def test_an_empty_tree_does_not_pass(self):
        self.assertEqual(run_on({})[0], 2)


if __name__ == "__main__":
    unittest.main()
