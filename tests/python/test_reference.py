"""The reference of the Python interface is made from its docstrings, and all of it is there."""

import importlib.util
import pathlib
import unittest

import overbend

ROOT = pathlib.Path(__file__).resolve().parents[2]


def tool():
    """tools/python_reference.py as a module."""
    spec = importlib.util.spec_from_file_location("python_reference", ROOT / "tools" / "python_reference.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Reference(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tool = tool()

    def test_the_page_is_up_to_date(self):
        stored = self.tool.PAGE.read_text(encoding="utf-8")
        self.assertEqual(stored, self.tool.page(), "run tools/python_reference.py")

    def test_every_public_name_has_a_docstring(self):
        self.assertEqual(self.tool.undocumented(), [])

    def test_every_class_and_function_is_on_the_page(self):
        page = self.tool.page()
        names = [name for name in overbend.__all__ if callable(getattr(overbend, name))]
        self.assertEqual([name for name in names if f"\n### {name}\n" not in page], [])

    def test_a_docstring_becomes_paragraphs_lists_and_code(self):
        doc = """What it is.

            code()

        Args:
            one, two: [m], and
                more.

        Raises: ValueError where it cannot be.
        """
        self.assertEqual("\n".join(self.tool.described(doc)).strip().split("\n\n"),
                         ["What it is.", "```python\ncode()\n```", "*Args*:", "- `one`, `two`: [m], and more.",
                          "*Raises*: ValueError where it cannot be."])

    def test_a_function_without_a_docstring_is_found(self):
        def bare():
            pass

        overbend.bare, bare.__module__ = bare, "overbend.model"
        overbend.__all__.append("bare")
        try:
            self.assertEqual(self.tool.undocumented(), ["overbend.model.bare"])
        finally:
            overbend.__all__.remove("bare")
            del overbend.bare


if __name__ == "__main__":
    unittest.main()
