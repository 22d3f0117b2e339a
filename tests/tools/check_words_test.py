"""The word check must catch what it is there for: each test plants one offence in an otherwise clean tree."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOL = pathlib.Path(__file__).resolve().parents[2] / "tools" / "check_words.py"

CLEAN = {
    "src/overbend/mechanics/rod.cpp": "/// Returns the tension at arc length `s` [N].\ndouble tension(double s) { return table.at(s); }\n",
    "web/src/state/runs.ts": "/** Runs in their order. */\nexport const runs = list.map((run) => run.most_loaded);\n",
    "docs/guide/lay.md": "# Lay a pipe\n\nThe key `told` of the file and [the part](beside.md) are quoted.\n",
}


def run_on(files):
    """Exit code and output of the check on a tree given as {path: text}."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = pathlib.Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        command = [sys.executable, str(TOOL), "--root", folder]
        run = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)
        return run.returncode, run.stdout


class CheckVocabulary(unittest.TestCase):
    def assert_caught(self, name, text, kind, line=1):
        code, output = run_on({**CLEAN, name: text})
        self.assertEqual(code, 1, output)
        self.assertIn(f"{name}:{line}: {kind} ", output)
        self.assertIn("words: 1 to change", output)

    def test_a_clean_tree_passes(self):
        code, output = run_on(CLEAN)
        self.assertEqual((code, output), (0, "words: none to change\n"))

    def test_parameters_that_name_nothing_are_caught(self):
        self.assert_caught("src/overbend/a.h", "double f(double at);\n", "identifier")
        self.assert_caught("src/overbend/a.h", "double f(const Case& one);\n", "identifier")

    def test_functions_named_after_of_are_caught(self):
        self.assert_caught("src/overbend/a.h", "double length_of(int line);\n", "identifier")
        self.assert_caught("web/src/a.ts", "export const lengthOf = (line) => line.length;\n", "identifier")

    def test_terms_within_identifiers_are_caught(self):
        self.assert_caught("src/overbend/a.h", "constexpr int kMostSteps = 3;\n", "identifier")
        self.assert_caught("src/overbend/a.h", "\nstruct FileFault {};\n", "identifier", 2)

    def test_comments_that_open_with_a_question_are_caught(self):
        self.assert_caught("src/overbend/a.h", "/// Whether the pipe slides.\n", "comment")
        self.assert_caught("python/overbend/a.py", "# What the run wrote.\n", "comment")

    def test_private_terms_of_comments_messages_and_documents_are_caught(self):
        self.assert_caught("src/overbend/a.cpp", "// The tension told by the user.\n", "comment")
        self.assert_caught("src/overbend/a.cpp", 'fail("the file is refused");\n', "message")
        self.assert_caught("docs/guide/a.md", "# A\n\nThe result hangs on the mesh.\n", "document", 3)

    def test_a_text_between_double_quotes_is_no_code(self):
        code, output = run_on({**CLEAN, "src/overbend/a.cpp": 'const char* kText = R"(there at own one)";\n'})
        self.assertEqual(code, 0, output)


if __name__ == "__main__":
    unittest.main()
