"""The comparison of documents and program catches what it is for."""

import pathlib
import sys
import unittest

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[2] / "tools")]
sys.dont_write_bytecode = True

import check_docs  # noqa: E402

KEYS = check_docs.Keys("""
| `waves.type` | `none or airy` | `none` |  | Sea. |
| `waves.components` | whole number | `200` |  | Number. |
| `boxes[].x` | length (m) | **required** |  | Place. |
| `friction` | number | `0.3` |  | Friction. |
""")
SCHEMA = check_docs.loose({"type": "object", "additionalProperties": False, "required": ["waves", "title"], "properties": {
    "title": {"type": "string"},
    "waves": {"type": "object", "additionalProperties": False, "properties": {"type": {"enum": ["none", "airy"]}}}}})
OPTIONS = {"static": {"-o", "--output", "--strict"}}


class CheckDocs(unittest.TestCase):
    def keys(self, text):
        return check_docs.key_problems("page", text, KEYS, {"peak", "rows"})

    def test_unknown_keys_are_caught(self):
        self.assertEqual(self.keys("`waves.type`, `boxes[2].x`, `boxes[].x`, `waves.peak`, `waves.csv`, `other.thing`"), [])
        self.assertEqual(len(self.keys("`waves.typ`")), 1)

    def test_unknown_choices_are_caught(self):
        self.assertEqual(self.keys("`waves.type: airy`"), [])
        self.assertEqual(len(self.keys("`waves.type: stokes`")), 1)

    def defaults(self, text):
        return check_docs.default_problems("page", text, KEYS)

    def test_other_defaults_are_caught(self):
        for text in ("`waves.components`, 200 by default", "`waves.components` (default 200)", "`waves.type: none` (default)"):
            self.assertEqual(self.defaults(text), ([], 1), text)
        for text in ("`waves.components`, 100 by default", "The default of `waves.components` is 20.",
                     "`waves.type: airy`, the default"):
            self.assertTrue(self.defaults(text)[0], text)

    def models(self, block):
        text = f"```yaml\n{block}\n```\n"
        return check_docs.model_problems("page", text, SCHEMA, list(check_docs.groups(SCHEMA)), {"axes"})[0]

    def test_parts_of_models_follow_the_schema(self):
        for block in ("waves: {type: airy}", "waves: {...: ...}", "  type: airy", "axes: {}", "waves:\n  type: none\nwaves: {type: airy}"):
            self.assertEqual(self.models(block), [], block)
        for block in ("waves: {typ: airy}", "waves: {type: stokes}", "other: 1", "waves: {type: a[0].b}"):
            self.assertEqual(len(self.models(block)), 1, block)

    def test_unknown_commands_and_options_are_caught(self):
        def problems(call):
            return check_docs.command_problems("page", call, OPTIONS)

        self.assertEqual(problems("static model.yaml -o out --strict  # comment"), [])
        for call in ("statics model.yaml", "static model.yaml --stric", "static examples/gone.yaml", "static 'model.yaml"):
            self.assertEqual(len(problems(call)), 1, call)
        self.assertEqual(len(check_docs.option_problems("page", "`--strict` and `--lax`", OPTIONS)), 1)

    def test_calls_are_found_in_blocks_and_in_prose(self):
        text = "`overbend static a.yaml`\n```sh\nX=1 build/release/overbend static b.yaml \\\n  --strict\n```\n"
        self.assertEqual([call.split() for call in check_docs.command_lines(text)],
                         [["static", "b.yaml", "--strict"], ["static", "a.yaml"]])


if __name__ == "__main__":
    unittest.main()
