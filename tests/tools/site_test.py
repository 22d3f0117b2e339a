"""The documentation site is built, complete and free of dead links; its checks catch what they are for."""

import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tools" / "site")]
sys.dont_write_bytecode = True

import bibliography  # noqa: E402
import check_links  # noqa: E402
import key_tasks  # noqa: E402
import sources  # noqa: E402

MISSING = [name for name in ("sphinx", "myst_parser", "furo") if importlib.util.find_spec(name) is None]
if not pathlib.Path("/usr/share/javascript/mathjax/MathJax.js").is_file():
    MISSING.append("libjs-mathjax")


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.site = pathlib.Path(cls.folder.name, "site")
        done = subprocess.run(["bash", str(ROOT / "scripts" / "docs.sh"), str(cls.site)], capture_output=True, encoding="utf-8",
                              stdin=subprocess.DEVNULL,
                              env={**os.environ, "LC_ALL": "C.UTF-8", "OVERBEND_HTML": "/nonexistent"})
        if done.returncode != 0:
            raise AssertionError(f"scripts/docs.sh: exit code {done.returncode}\n{done.stdout}\n{done.stderr}")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def text(self, page):
        return (self.site / page).read_text(encoding="utf-8")

    def test_every_key_is_linked_once_by_its_task(self):
        linked = re.findall(r'href="input\.html#([^"]+)"><code>', self.text("keys-by-task.html"))
        keys = dict.fromkeys(row[0] for row in key_tasks.rows((ROOT / "docs/input.md").read_text(encoding="utf-8")))
        self.assertGreater(len(keys), 1000)
        self.assertEqual(sorted(urllib.parse.unquote(key) for key in linked), sorted(keys))

    def test_tutorials_open_their_models_in_the_program_if_the_site_has_it(self):
        self.assertNotIn("<iframe", self.text("tutorials/deep-s-lay.html"))
        with tempfile.TemporaryDirectory() as folder:
            sources.write_sources(pathlib.Path(folder), has_program=True)
            queries = {}
            for page in sorted(pathlib.Path(folder, "tutorials").glob("*.md")):
                if found := re.search(r'<iframe[^>]* src="\.\./overbend\.html\?([^"]+)"', page.read_text(encoding="utf-8")):
                    queries[page.stem] = dict(urllib.parse.parse_qsl(found.group(1), strict_parsing=True))
        self.assertEqual(len(queries), 8)
        self.assertEqual(queries["shallow-s-lay"], {"example": "shallow-s-lay"})
        self.assertIn("overbend: 1\n", queries["deep-s-lay"]["model"])
        self.assertTrue(all("vary:" not in query.get("model", "") for query in queries.values()))

    def test_search_works_without_a_server(self):
        self.assertIn("tension", self.text("searchindex.js"))
        self.assertIn('src="searchindex.js"', self.text("search.html"))

    def test_formulas_need_no_network(self):
        page = self.text("theory/coupling.html")
        self.assertIn('src="../_static/mathjax/MathJax.js?config=TeX-AMS_SVG"', page)
        self.assertTrue((self.site / "_static/mathjax/config/TeX-AMS_SVG.js").is_file())

    def test_the_theme_is_complete(self):
        self.assertNotRegex(self.text("_static/scripts/furo.js"), r"(?m)^import ")
        self.assertIn("prefers-color-scheme: dark", self.text("_static/styles/furo.css"))

    def test_citations_lead_to_references(self):
        self.assertIn('href="../references.html#wheeler1970"', self.text("theory/waves.html"))


class LinkCheck(unittest.TestCase):
    def find_problems(self, body, **files):
        with tempfile.TemporaryDirectory() as folder:
            site = pathlib.Path(folder, "site")
            site.mkdir()
            (site / "index.html").write_text(f"<html><body>{body}</body></html>", encoding="utf-8")
            for name, content in files.items():
                (site / name.replace("_", ".")).write_text(content, encoding="utf-8")
            return check_links.problems(site)

    def test_a_sound_page_passes(self):
        self.assertEqual(self.find_problems('<a id="x"></a><a href="#x">x</a><a href="https://a.b/c">c</a>'
                                          '<a href="two.html#y">y</a><img src="p.png" alt="p">',
                                          two_html='<p id="y">', p_png="p"), [])

    def test_offences_are_caught(self):
        for body, message in (('<a href="gone.html">x</a>', "no file"), ('<a href="#gone">x</a>', "no anchor"),
                              ('<img src="gone.png" alt="x">', "no file"), ('<img src="index.html">', "alternative text"),
                              ('<script src="https://a.b/c.js"></script>', "network"),
                              ('<link rel="stylesheet" href="//a.b/c.css">', "network")):
            found = self.find_problems(body)
            self.assertEqual(len(found), 1, found)
            self.assertIn(message, found[0])

    def test_imports_of_style_sheets_are_followed(self):
        for style in ("@import url(/javascript/gone.css);", "a { background: url('https://a.b/c.png') }"):
            self.assertEqual(len(self.find_problems("", s_css=style)), 1, style)

    def test_pictures_that_no_page_shows_are_caught(self):
        with tempfile.TemporaryDirectory() as folder:
            site, pictures = pathlib.Path(folder, "site"), pathlib.Path(folder, "pictures")
            site.mkdir()
            pictures.mkdir()
            (pictures / "shown.png").write_bytes(b"1")
            (pictures / "unused.png").write_bytes(b"2")
            (site / "renamed.png").write_bytes(b"1")
            (site / "index.html").write_text('<img src="renamed.png" alt="x">', encoding="utf-8")
            found = check_links.problems(site, pictures)
            self.assertEqual(len(found), 1, found)
            self.assertIn("unused.png", found[0])


class Tasks(unittest.TestCase):
    TASKS = [("A", "", "model", ["a"]), ("B", "", "model", ["a.b"])]

    def test_the_longest_prefix_decides(self):
        self.assertEqual(key_tasks.keys_by_task(["a", "a.c", "a.b", "a.b[].d", "a.c"], self.TASKS),
                         {"A": ["a", "a.c"], "B": ["a.b", "a.b[].d"]})

    def test_a_key_of_no_task_is_an_error(self):
        with self.assertRaisesRegex(key_tasks.TaskError, "ab"):
            key_tasks.keys_by_task(["a", "a.b", "ab"], self.TASKS)

    def test_a_prefix_of_no_key_is_an_error(self):
        with self.assertRaisesRegex(key_tasks.TaskError, "a.b"):
            key_tasks.keys_by_task(["a"], self.TASKS)


class Sources(unittest.TestCase):
    def test_links_follow_the_folders_of_the_site(self):
        change = sources.with_site_links
        self.assertEqual(change("docs/guide/a.md", "[x](../../examples/b.yaml)"), "[x](../examples/b.yaml)")
        self.assertEqual(change("docs/guide/a.md", "[x](../../README.md)"), "[x](../index.md)")
        self.assertEqual(change("CHANGELOG.md", "[x](docs/guide/a.md#b) [y](https://c.d)"), "[x](guide/a.md#b) [y](https://c.d)")

    def test_code_is_left_alone(self):
        text = "`[x](a.md)` [x](a.md)\n```md\n[x](a.md)\n```\n"
        self.assertEqual(sources.outside_code(text, lambda prose: prose.replace("a.md", "b.md")),
                         "`[x](a.md)` [x](b.md)\n```md\n[x](a.md)\n```\n")

    def test_every_source_is_read(self):
        text = (ROOT / bibliography.BIB).read_text(encoding="utf-8")
        self.assertEqual(len(bibliography.entries(text)), len(re.findall(r"^@", text, flags=re.M)))


if __name__ == "__main__":
    if MISSING:
        print("skipped: the documentation site needs " + ", ".join(MISSING) + "; run scripts/install.sh docs")
        sys.exit(77)
    unittest.main()
