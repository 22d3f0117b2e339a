"""Sphinx settings of the documentation site; scripts/docs.sh runs it on the pages that sources.py collects."""

import html
import json
import pathlib
import re
import shutil

from sphinx.search.en import SearchEnglish

HERE = pathlib.Path(__file__).resolve().parent
MATHJAX = pathlib.Path("/usr/share/javascript/mathjax")
MATHJAX_PARTS = ("MathJax.js", "config/TeX-AMS_SVG.js", "extensions", "jax/element", "jax/input/TeX", "jax/output/SVG/*.js",
                 "jax/output/SVG/autoload", "jax/output/SVG/fonts/TeX")

project = "Overbend"
author = "Overbend developers"
project_copyright = "Overbend developers, MIT licence"
root_doc = "index"
exclude_patterns = []
extensions = ["myst_parser", "sphinx.ext.mathjax"]
nitpicky = True
smartquotes = False  # they would make a dash of --option

# Formulas and anchors as forges understand them.
myst_enable_extensions = ["dollarmath", "colon_fence"]
myst_dmath_double_inline = True
myst_heading_anchors = 4
myst_update_mathjax = False

html_theme = "furo"
html_title = "Overbend"
html_static_path = [str(HERE / "static")]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
html_last_updated_fmt = None
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#0b5c8a", "color-brand-content": "#0b5c8a"},
    "dark_css_variables": {"color-brand-primary": "#6cb8e6", "color-brand-content": "#6cb8e6"},
}

# MathJax 2 with its SVG output needs neither a server nor web fonts.
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_SVG"
mathjax2_config = {
    "tex2jax": {
        "inlineMath": [["\\(", "\\)"]],
        "displayMath": [["\\[", "\\]"]],
        "processClass": "math",
        "ignoreClass": "document",
    },
    "SVG": {"linebreaks": {"automatic": True}},
    "showMathMenu": False,
    "messageStyle": "none",
}


class Search(SearchEnglish):
    """The search in English that leaves words such as hs as they are, as its part in the browser does."""

    def stem(self, word):
        return word if len(word) < 3 else super().stem(word)


def copy_mathjax(folder):
    """Copies the parts of MathJax that the pages load."""
    for pattern in MATHJAX_PARTS:
        for part in MATHJAX.glob(pattern):
            target = folder / "mathjax" / part.relative_to(MATHJAX)
            target.parent.mkdir(parents=True, exist_ok=True)
            (shutil.copytree if part.is_dir() else shutil.copy)(part, target)


def complete_theme(folder):
    """Puts into the theme's files what Debian's package leaves out.

    Imported files are put in their place: the package expects a web server that has them. The dark colours for browsers
    that prefer them are added: the package's style sheet has those of the theme's button alone.
    """
    style = folder / "styles" / "furo.css"
    text = style.read_text(encoding="utf-8")
    text = re.sub(r"@import url\((/javascript/[^)]+)\);",
                  lambda found: pathlib.Path("/usr/share" + found.group(1)).read_text(encoding="utf-8"), text)
    dark = re.search(r'^@media not print \{\n  body\[data-theme="dark"\].*?\} \}$', text, flags=re.M | re.S)
    if dark and "prefers-color-scheme" not in text:
        text += "\n" + dark.group().replace("@media not print", "@media screen and (prefers-color-scheme: dark)").replace(
            '[data-theme="dark"]', ':not([data-theme="light"])') + "\n"
    style.write_text(text, encoding="utf-8")
    script = folder / "scripts" / "furo.js"
    script.write_text(re.sub(r'^import \w+ from "\./([^"]+)";$',
                             lambda found: (script.parent / found.group(1)).read_text(encoding="utf-8"),
                             script.read_text(encoding="utf-8"), flags=re.M), encoding="utf-8")


def write_page_texts(folder):
    """Writes the texts of all pages for the summaries of the search, see search_summaries.js."""
    texts = {}
    for path in sorted(folder.rglob("*.html")):
        main = re.search(r'<article role="main">(.*?)</article>', path.read_text(encoding="utf-8"), flags=re.S)
        if main:
            text = re.sub(r"<(script|style).*?</\1>", "", main.group(1), flags=re.S)
            text = re.sub(r"<!--.*?-->", "", text, flags=re.S)
            text = re.sub(r'<a class="headerlink".*?</a>', "", text)
            text = re.sub(r"<wbr>|</?(?:span|code|em|strong|a)\b[^>]*>", "", text)
            text = html.unescape(re.sub(r"<[^>]*>", " ", text)).replace("\\(", "").replace("\\)", "")
            texts[path.relative_to(folder).as_posix()] = re.sub(r"\s+", " ", text).strip()
    (folder / "_static" / "page_texts.js").write_text(
        "const pageTexts = " + json.dumps(texts, ensure_ascii=False, indent=0) + ";\n", encoding="utf-8")


def add_search_summaries(app, page, template, context, doctree):
    """The texts of all pages are loaded by the page of the search alone."""
    if page == "search":
        app.add_js_file("page_texts.js")
        app.add_js_file("search_summaries.js")


def complete_site(app, error):
    if not error:
        folder = pathlib.Path(app.outdir)
        copy_mathjax(folder / "_static")
        complete_theme(folder / "_static")
        write_page_texts(folder)


def setup(app):
    app.add_search_language(Search)
    app.connect("html-page-context", add_search_summaries)
    app.connect("build-finished", complete_site)
