"""The documentation keeps its word: examples are the tested ones, and links lead somewhere."""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = sorted(
    page for page in ROOT.rglob("*.md") if not {"build", "results", "node_modules", ".git"} & set(page.relative_to(ROOT).parts)
)


def text(path):
    return path.read_text(encoding="utf-8")


def prose(page):
    """A page without its code blocks."""
    return re.sub(r"^```.*?^```", "", text(page), flags=re.M | re.S)


class Docs(unittest.TestCase):
    def test_the_readme_shows_the_first_model_word_for_word(self):
        blocks = re.findall(r"```yaml\n(.*?)```", text(ROOT / "README.md"), flags=re.S)
        self.assertEqual(blocks, [text(ROOT / "examples" / "first-model.yaml")])

    def test_links_lead_to_files(self):
        dead = []
        for page in PAGES:
            for target in re.findall(r"\]\(([^)#\s]+)", prose(page)):
                if "://" not in target and not (page.parent / target).exists():
                    dead.append(f"{page.relative_to(ROOT)}: {target}")
        self.assertEqual(dead, [])

    def test_cited_sources_are_listed(self):
        listed = set(re.findall(r"^@\w+\{(\w+),", text(ROOT / "docs" / "references.bib"), flags=re.M))
        cited = re.compile(r"\[([a-z]+\d{4}|dnvc205)\]")
        sources = [*PAGES, *(ROOT / "src").rglob("*.h"), *(ROOT / "src").rglob("*.cpp")]
        unknown = [f"{s.relative_to(ROOT)}: {key}" for s in sources for key in cited.findall(text(s)) if key not in listed]
        self.assertEqual(unknown, [])

    def test_every_example_is_described(self):
        listed = text(ROOT / "examples" / "README.md")
        missing = [m.name for m in (ROOT / "examples").glob("*.yaml") if f"({m.name})" not in listed]
        self.assertEqual(missing, [])


if __name__ == "__main__":
    unittest.main()
