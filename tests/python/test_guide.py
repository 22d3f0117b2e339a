"""The Python examples in the documentation do what they say: every block is executed, page by page."""

import os
import pathlib
import re
import tempfile
import unittest

os.environ.setdefault("MPLBACKEND", "Agg")
ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs" / "guide").glob("*.md")), ROOT / "docs" / "python" / "README.md"]
BLOCK = re.compile(r"^```python\n(.*?)^```", flags=re.M | re.S)
IN_C = re.compile(r"^```c\n(.*?)^```", flags=re.M | re.S)


def blocks(page):
    """Number of the first line and text of each Python block that uses the package."""
    text = page.read_text(encoding="utf-8")
    return [(text.count("\n", 0, found.start(1)) + 1, found[1]) for found in BLOCK.finditer(text)]


class Guide(unittest.TestCase):
    def run_page(self, page):
        """Runs the blocks of a page one after the other, as a reader would, in a folder that holds the examples."""
        names = {"__name__": "__main__"}
        if not any("ob." in text for _, text in blocks(page)):
            return False
        start = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            for name in ("examples", "data"):
                os.symlink(ROOT / name, pathlib.Path(folder) / name)
            for text in IN_C.findall(page.read_text(encoding="utf-8")):  # what the example compiles
                pathlib.Path(folder, "law.c").write_text(text, encoding="utf-8")
            os.chdir(folder)
            try:
                for line, text in blocks(page):
                    if "h5py" not in text:
                        exec(compile("\n" * (line - 1) + text, str(page), "exec"), names)
            finally:
                os.chdir(start)
        return True


def case(page):
    def test(self):
        if not self.run_page(page):
            self.skipTest("no example of the package on this page")

    return test


for each in PAGES:
    if each.exists() and any("ob." in text for _, text in blocks(each)):
        name = f"test_the_examples_of_{each.relative_to(ROOT).with_suffix('')}_run".replace("/", "_").replace("-", "_")
        setattr(Guide, name, case(each))


if __name__ == "__main__":
    unittest.main()
