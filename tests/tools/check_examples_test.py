"""tools/check_examples.py finds wrong numbers in pages. The program is a stand-in that writes a fixed summary.json."""

import pathlib
import stat
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOL = ROOT / "tools" / "check_examples.py"

PROGRAM = """#!/bin/sh
for folder; do :; done  # the last argument
cat "$2" || exit 2
grep -q invalid "$2" && exit 2
mkdir "$folder"
cat > "$folder/summary.json" <<END
{"static": {"top_tension": 560012.3, "departure_angle": 0.5235987755982988, "last_support": "stinger 2",
            "supports": [{"name": "ramp 1", "reaction": 1234567.0}, {"name": "stinger 2", "reaction": 61e3}]},
 "objects": {"lines": {"pipe": {"lay_back": 120.04}}}, "checks": {"worst": {"utilisation": 0.8149}}}
END
"""

PAGE = """# Page

```yaml file=model.yaml
overbend: 1
```

```yaml file=model.yaml
title: model in two parts
```

```text
<!-- example: static inside-a-code-block.yaml -->
```

<!-- example: static model.yaml -->
| result | value | meaning |
|---|---|---|
| `static.top_tension` | 560.0 kN | at the tensioner |
| `static.departure_angle` | 30.00 deg | |
| `static.last_support` | stinger 2 | |
| `static.supports[ramp 1].reaction` | 1,235 kN | |
| `static.supports[1].reaction` | 0.06 MN | |
| `lines[pipe].lay_back` | 120.0 m | |
| `checks.worst.utilisation` | 0.81 | |
<!-- /example -->
"""


class CheckExamples(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program = pathlib.Path(folder.name) / "program"
        self.program.write_text(PROGRAM, encoding="utf-8")
        self.program.chmod(self.program.stat().st_mode | stat.S_IXUSR)
        self.page = pathlib.Path(folder.name) / "page.md"

    def check(self, text, *options):
        self.page.write_text(text, encoding="utf-8")
        done = subprocess.run([sys.executable, TOOL, self.program, self.page, *options], capture_output=True,
                              encoding="utf-8", check=False)
        self.assertEqual(done.stderr, "")
        return done.returncode, done.stdout

    def test_right_numbers_pass(self):
        code, output = self.check(PAGE)
        self.assertEqual(code, 0, output)
        self.assertIn("1 examples, 7 values, 0 messages", output)

    def test_a_number_that_is_off_by_one_in_its_last_digit_fails(self):
        code, output = self.check(PAGE.replace("560.0 kN", "560.1 kN"))
        self.assertEqual(code, 1)
        self.assertIn("page.md:18: static.top_tension: expected 560.1 kN, found 560.0 kN", output)

    def test_another_name_fails(self):
        code, output = self.check(PAGE.replace("| stinger 2 |", "| stinger 3 |"))
        self.assertEqual(code, 1)
        self.assertIn("expected stinger 3, found stinger 2", output)

    def test_updated_pages_pass(self):
        wrong = PAGE.replace("560.0 kN", "1.0 kN").replace("1,235 kN", "9,999 kN").replace("| stinger 2 |", "| ? |")
        self.assertEqual(self.check(wrong, "--write")[0], 1)
        self.assertEqual(self.page.read_text(encoding="utf-8"), PAGE)

    def test_a_block_replaces_groups_of_its_base(self):
        text = PAGE.replace("overbend: 1\n```\n\n", "overbend: 1\npipe: {length: 1 m}\ntensioner:\n  tension: invalid\n```\n\n")
        code, output = self.check(text)
        self.assertEqual(code, 1)
        self.assertIn("pipe: {length: 1 m}\ntensioner:\n  tension: invalid", output)
        block = ("```yaml file=other.yaml base=model.yaml\ntensioner:\n  tension: 1 kN\nreport: {}\n```\n\n"
                 "<!-- example: static model")
        text = text.replace("<!-- example: static model", block).replace("static model.yaml", "static other.yaml")
        self.assertEqual(self.check(text)[0], 0)
        code, output = self.check(text.replace("static other.yaml", "static other.yaml extra").replace("1 kN", "invalid, too"))
        self.assertIn("overbend: 1\npipe: {length: 1 m}\ntensioner:\n  tension: invalid, too\ntitle: model in two parts\nreport: {}", output)
        self.assertIn("base=none.yaml: neither a file", self.check(text.replace("base=model.yaml", "base=none.yaml"))[1])

    def test_a_part_of_a_file_must_be_in_it(self):
        part = "```yaml of=examples/first-model.yaml\nenvironment:\n  water_depth: 40 m   # shallow\n```\n"
        self.assertEqual(self.check(PAGE + part)[0], 0)
        code, output = self.check(PAGE + part.replace("40 m", "41 m"))
        self.assertEqual(code, 1)
        self.assertIn("examples/first-model.yaml has no such line, or has it earlier: water_depth: 41 m", output)

    def test_mistakes_in_the_mark_up_are_reported(self):
        for change, message in (
            (("static.top_tension", "static.top"), "static.top: no 'top', there is: top_tension"),
            (("supports[ramp 1]", "supports[ramp 9]"), "no item 'ramp 9'"),
            (("560.0 kN", "560.0 kilonewton"), "unknown unit 'kilonewton'"),
            (("560.0 kN", "some kN"), "expected a number"),
            (("<!-- /example -->", ""), "page.md:15: the example has no end"),
            (("example: static model", "example: check model"), "the command must be one of"),
            (("example: static model", "example: static absent"), "exit code 2"),
        ):
            with self.subTest(message=message):
                code, output = self.check(PAGE.replace(*change))
                self.assertEqual(code, 1)
                self.assertIn(message, output)


if __name__ == "__main__":
    unittest.main()
