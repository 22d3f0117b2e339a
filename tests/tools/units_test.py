#!/usr/bin/env python3
"""Sources are compiled together only where their names allow it: tools/units.py."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
from units import named_units, units  # noqa: E402

FOLDER = os.fsdecode("mit Leerzeichen und ü ".encode())  # as bytes, for any locale


def hiding(text):
    return "namespace {\n\n" + text + "\n\n}  // namespace\n"


class Units(unittest.TestCase):
    def together(self, first, second, **headers):
        """Whether two sources with these texts share a unit."""
        with tempfile.TemporaryDirectory() as folder:
            inside = pathlib.Path(folder) / "src" / "overbend"
            inside.mkdir(parents=True)
            for name, text in {"a.cpp": first, "b.cpp": second, **{k + ".h": v for k, v in headers.items()}}.items():
                (inside / name).write_text(text, encoding="utf-8")
            return len(units([inside / "a.cpp", inside / "b.cpp"], 8)) == 1

    def test_sources_that_share_no_name_stand_together(self):
        self.assertTrue(self.together(hiding("int one() {"), hiding("int other() {")))

    def test_two_helpers_of_one_name_stay_apart(self):
        self.assertFalse(self.together(hiding("int same(int) {"), hiding("[[noreturn]] void same(double) {")))

    def test_two_constants_and_two_types_of_one_name_stay_apart(self):
        self.assertFalse(self.together(hiding("constexpr double kStep = 1;"), hiding("constexpr int kStep = 2;")))
        self.assertFalse(self.together(hiding("struct Row {"), hiding("class Row : public Base {")))

    def test_the_second_constant_of_a_line_is_seen(self):
        self.assertFalse(self.together(hiding("constexpr double kLow = 1, kHigh = 2;"),
                                       hiding("constexpr double kLess = 1, kHigh = 3;")))

    def test_a_helper_does_not_hide_a_function_that_the_other_calls(self):
        self.assertFalse(self.together(hiding("int least(int) {"), "int f() { return least(2.0); }"))

    def test_a_helper_does_not_hide_a_function_of_a_header_that_the_other_includes(self):
        header = "inline int g() { return least(2.0); }"
        self.assertFalse(self.together(hiding("int least(int) {"), '#include "h.h"', h=header))
        for call in "return least(2.0);", "least(2.0);":
            header = "inline int g() {\n  " + call + "\n}\n"
            self.assertFalse(self.together(hiding("int least(int) {"), '#include "h.h"', h=header))

    def test_nothing_hides_what_a_header_names_within_its_types(self):
        inside = "struct Row {\n  int at(int i) const;\n  int first() const { return at(0); }\n};\n"
        a, b = hiding("int at(int) {"), '#include "h.h"'
        self.assertTrue(self.together(a, b, h=inside))
        self.assertFalse(self.together(a, b, h=inside + "int at(double);\n"))
        self.assertFalse(self.together(a, b, h=inside, unrelated="int at(double);\n"))

    def test_a_name_that_both_borrow_from_one_place_is_the_same(self):
        fixed = hiding("using html::fixed;")
        self.assertTrue(self.together(fixed, fixed + "int f() { return fixed(1); }"))
        self.assertFalse(self.together(fixed, hiding("using text::fixed;")))
        self.assertFalse(self.together(fixed, "int f() { return fixed(1); }"))
        self.assertTrue(self.together(hiding("using Row = std::map<A, B>;"), hiding("using Row = std::map<A, B>;")))
        self.assertFalse(self.together(hiding("using Row = std::map<A, B>;"), hiding("using Row = std::map<A, C>;")))

    def test_no_parameter_hides_what_the_other_borrows(self):
        self.assertFalse(self.together(hiding("using library::json;"), "int f(int json) { return json; }"))

    def test_members_and_comments_are_no_names(self):
        self.assertTrue(self.together(hiding("int least(int) {"), "int f() { return x.least(1); }  // least(2)"))

    def test_units_have_at_most_so_many_sources(self):
        with tempfile.TemporaryDirectory() as folder:
            paths = [pathlib.Path(folder) / f"{i}.cpp" for i in range(5)]
            for path in paths:
                path.write_text("", encoding="utf-8")
            self.assertEqual([len(unit) for unit in units(paths, 2)], [2, 2, 1])

    def test_what_folders_leave_over_shares_a_unit(self):
        with tempfile.TemporaryDirectory() as folder:
            paths = [pathlib.Path(folder) / place / f"{i}.cpp" for place in ("few", "many") for i in range(5)]
            paths = [path for path in paths if path.parent.name == "many" or path.stem in "01"]
            for path in paths:
                path.parent.mkdir(exist_ok=True)
                path.write_text("", encoding="utf-8")
            made = {name: [path.parent.name for path in unit] for name, unit in named_units(paths, 4)}
            self.assertEqual(sorted(made.values()), [["few", "few", "many"], ["many"] * 4])

    def test_names_of_units_are_plain_for_any_name_of_the_folder(self):
        with tempfile.TemporaryDirectory(prefix=FOLDER) as folder:
            paths = [pathlib.Path(folder) / "tests" / f"{i}.cpp" for i in range(4)]
            paths[0].parent.mkdir()
            for path in paths:
                path.write_text("", encoding="utf-8")
            for name, _ in named_units(paths, 4):
                self.assertRegex(name, r"^\w+$")
                self.assertTrue(name.isascii())


PROJECT = """
cmake_minimum_required(VERSION 3.25)
project(units CXX)
include("%s/tools/units.cmake")
set(sources "${PROJECT_SOURCE_DIR}/a.cpp" "${PROJECT_SOURCE_DIR}/b.cpp" "${PROJECT_SOURCE_DIR}/c.cpp")
add_library(together STATIC ${sources})
compile_in_units(together 8 ${sources})
"""


class Build(unittest.TestCase):
    def test_sources_in_a_folder_with_blanks_and_umlauts_share_units(self):
        with tempfile.TemporaryDirectory(prefix=FOLDER) as place:
            folder = pathlib.Path(place)
            (folder / "tools").mkdir()
            (folder / "tools" / "units.py").symlink_to(ROOT / "tools" / "units.py")
            (folder / "CMakeLists.txt").write_text(PROJECT % ROOT, encoding="utf-8")
            for name in "abc":
                (folder / f"{name}.cpp").write_text(f"int {name}() {{ return 1; }}\n", encoding="utf-8")
            done = subprocess.run(["cmake", "-G", "Ninja", "-S", folder, "-B", folder / "build"], capture_output=True,
                                  check=False)
            self.assertEqual(done.returncode, 0, done.stderr.decode(errors="replace"))
            steps = (folder / "build" / "build.ninja").read_text(encoding="utf-8")
            self.assertEqual(steps.count("unity_left_over_0_cxx.cxx.o: "), 1)
            self.assertNotIn("a.cpp.o: ", steps)


unittest.main()
