"""The page of references, made from docs/references.bib, and links from citations to it."""

import html
import posixpath
import re
import unicodedata

BIB = "docs/references.bib"
KEY = r"[a-z]+\d{3,4}"
CITATION = re.compile(rf"\[({KEY}(?:, ?{KEY})*)\](?!\(|\[|:)")
CODE_OR_MATH = re.compile(r"^(?:```|~~~).*?^(?:```|~~~)[ \t]*$|`[^`\n]+`|\$\$.*?\$\$|\$[^$\n]+\$", flags=re.M | re.S)
ACCENTS = {"'": "\u0301", "`": "\u0300", "~": "\u0303", '"': "\u0308", "^": "\u0302"}


class CitationError(Exception):
    """The list of sources cannot be read."""


def plain(text):
    """Text of a field without the marks of TeX."""
    text = text.replace("{\\AA}", "\u00c5").replace("--", "\u2013").replace("\\&", "&")
    text = re.sub(r"\\(['`~\"^])\{?(\w)\}?", lambda m: unicodedata.normalize("NFC", m.group(2) + ACCENTS[m.group(1)]), text)
    text = re.sub(r"[{}]", "", text)
    if "\\" in text:
        raise CitationError(f"{BIB}: unknown TeX command in {text!r}")
    return re.sub(r"\s+", " ", text).strip()


def entries(text):
    """Fields of the entries by key."""
    found = {}
    for key, body in re.findall(r"^@\w+\{(\w+),(.*?)^\}", text, flags=re.M | re.S):
        fields = re.findall(r"(\w+)\s*=\s*\{((?:[^{}]|\{[^{}]*\})*)\}", body)
        found[key] = {name: plain(value) for name, value in fields}
    return found


def names(field):
    """Authors as they are printed: Silva, D. M. L. da; Jacob, B. P."""
    return "; ".join(field.split(" and "))


def edition(field):
    """2 is edition 2, 2nd is 2nd edition."""
    return "edition " + field if field.isdigit() else field + " edition" if field else ""


def line(key, entry):
    """One entry as a list item with an anchor."""
    numbers = entry.get("volume", "") + (f"({entry['number']})" if entry.get("volume") and entry.get("number") else "")
    number = "" if entry.get("volume") else entry.get("number", "")
    place = [entry.get("journal", ""), "In: " + entry["booktitle"] if "booktitle" in entry else "", numbers, number,
             edition(entry.get("edition", "")), entry.get("publisher", ""),
             entry.get("institution", ""), "pp. " + entry["pages"] if "pages" in entry else "", entry.get("note", "")]
    parts = [names(entry["author"]) if "author" in entry else "", "*" + entry["title"] + "*",
             ", ".join(part for part in place if part), entry.get("year", "")]
    text = ". ".join(part.rstrip(".") for part in parts if part) + "."
    return f'- <span id="{key}"></span>[{key}] {text}'


def page(root):
    """The page of references in Markdown."""
    found = entries((root / BIB).read_text(encoding="utf-8"))
    lines = [line(key, found[key]) for key in sorted(found)]
    return "# References\n\nSources of methods and data, also as [BibTeX](references.bib).\n\n" + "\n".join(lines) + "\n"


def with_links(path, text, references):
    """A page with its citations as links."""
    if path == references:
        return text
    target = posixpath.relpath(_site_path(references), posixpath.dirname(_site_path(path)) or ".")[: -len(".md")] + ".html"

    def link(citation):
        keys = re.split(r", ?", citation.group(1))
        return "[" + ", ".join(f'<a href="{html.escape(target)}#{key}">{key}</a>' for key in keys) + "]"

    parts, end = [], 0
    for code in CODE_OR_MATH.finditer(text):
        parts += [CITATION.sub(link, text[end : code.start()]), code.group()]
        end = code.end()
    return "".join(parts) + CITATION.sub(link, text[end:])


def _site_path(path):
    return path[len("docs/") :] if path.startswith("docs/") else path
