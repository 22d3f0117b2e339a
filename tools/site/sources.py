#!/usr/bin/env python3
"""Collects the pages of the documentation site in a folder that Sphinx reads.

    sources.py FOLDER [with-program]

Starting at docs/README.md, the front page, all pages of this repository are found by their links, with the pictures and
files that they show or offer. They are written to FOLDER with these changes:

- docs/ is the root of the site, and links follow.
- README.md pages are the indexes: the navigation has the pages of a folder in the order of the links in its README.md,
  and the sections of the front page. A page of docs/ that no index names is an error.
- docs/tutorials/README.md lists the pages of its folder by itself.
- Keys in docs/input.md are anchors, and the page "Keys by task" is made from them (key_tasks.py).
- Citations such as [silva2009] are links to the page "References", which is made from docs/references.bib.
- With the program as one file on the site (scripts/portable.sh wasm), tutorials have a frame in which their model is open.
"""

import pathlib
import posixpath
import re
import shutil
import sys
import urllib.parse

import bibliography
import key_tasks

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import check_examples  # noqa: E402

PROGRAM = "overbend.html"
FRONT = "docs/README.md"
KEYS = "docs/keys-by-task.md"
REFERENCES = "docs/references.md"
CODE = re.compile(r"^(?:```|~~~).*?^(?:```|~~~)[ \t]*$|`[^`\n]+`", flags=re.M | re.S)
LINK = re.compile(r"(\]\()([^)\s]+)((?:\s+\"[^\"]*\")?\))")


class SourceError(Exception):
    """A page that cannot be part of the site."""


def outside_code(text, change):
    """The text with its prose changed and its code left alone."""
    parts, end = [], 0
    for code in CODE.finditer(text):
        parts += [change(text[end : code.start()]), code.group()]
        end = code.end()
    return "".join(parts) + change(text[end:])


def is_local(target):
    return not target.startswith("#") and not re.match(r"[a-z]+:", target)


def linked_path(page, target):
    """Path in the repository, and anchor, of a link on a page."""
    path, _, anchor = target.partition("#")
    path = posixpath.normpath(posixpath.join(posixpath.dirname(page), path))
    return FRONT if path == "README.md" else path, anchor


def local_links(page, text):
    """The files of the repository to which a page links, in order."""
    prose = re.sub(r"`[^`\n]+`", "code", re.sub(r"^(```|~~~).*?^\1[ \t]*$", "", text, flags=re.M | re.S))
    return [linked_path(page, link.group(2))[0] for link in LINK.finditer(prose) if is_local(link.group(2))]


def site_path(path):
    """Path on the site of a file of the repository."""
    if path == FRONT:
        return "index.md"
    return path[len("docs/") :] if path.startswith("docs/") else path


def relative(page, path):
    return posixpath.relpath(site_path(path), posixpath.dirname(site_path(page)) or ".")


def with_site_links(page, text):
    def change(link):
        if not is_local(link.group(2)):
            return link.group()
        path, anchor = linked_path(page, link.group(2))
        return link.group(1) + relative(page, path) + ("#" + anchor if anchor else "") + link.group(3)

    return re.sub(LINK, change, text)


def title(text):
    """Heading of a page."""
    found = re.search(r"^# (.+)$", text, flags=re.M)
    return found.group(1) if found else ""


def read_pages():
    """Texts of all pages by their paths, and the other files that they link to."""
    pages, files, waiting = {}, set(), [(FRONT, FRONT)]
    generated = {KEYS: key_tasks.page, REFERENCES: bibliography.page}
    while waiting:
        path, linking = waiting.pop(0)
        if path in pages or path in files:
            continue
        source = ROOT / path
        if path in generated:
            pages[path] = generated[path](ROOT)
        elif not source.is_file():
            raise SourceError(f"{linking}: a link to {path}, which is no file of this repository")
        elif path.endswith(".md"):
            pages[path] = with_generated_links(path, source.read_text(encoding="utf-8"))
        else:
            files.add(path)
            continue
        waiting += [(target, path) for target in local_links(path, pages[path])]
    return pages, files


def with_generated_links(path, text):
    """A page with links to the pages that only the site has."""
    if path == FRONT:
        text = after_line(text, "](input.md)", "- [Keys by task](keys-by-task.md): the same keys by what they are for, "
                                               "with a filter")
        text = after_line(text, "](theory/README.md)", "- [References](references.md): sources of methods and data")
    if path == "docs/tutorials/README.md":
        known = local_links(path, text)
        more = [p.relative_to(ROOT).as_posix() for p in sorted((ROOT / path).parent.glob("*.md"))]
        items = [f"- [{title((ROOT / p).read_text(encoding='utf-8'))}]({posixpath.basename(p)})"
                 for p in more if p != path and p not in known]
        text += "\n" + "\n".join(items) + "\n"
    if path == "docs/input.md":
        text = key_tasks.with_anchors(text)
        text = text.replace("\n\n", "\n\nTo find a key by what it is for, see [keys by task](keys-by-task.md).\n\n", 1)
    text = text.replace("references.bib)", "references.md)") if path != REFERENCES else text
    return bibliography.with_links(path, text, REFERENCES)


def after_line(text, mark, line):
    """The text with a line after the one that contains the mark."""
    end = text.index("\n", text.index(mark))
    return text[: end + 1] + line + text[end:]


def find_index(path, pages):
    """The index page whose navigation has a page: the nearest README.md above it, else the front page."""
    folder = posixpath.dirname(path)
    if posixpath.basename(path) == "README.md":
        folder = posixpath.dirname(folder)
    while folder:
        if folder + "/README.md" in pages:
            return folder + "/README.md"
        folder = posixpath.dirname(folder)
    return FRONT


def toctree(index, entries, caption=""):
    lines = ["", "```{toctree}", ":hidden:"] + ([f":caption: {caption}"] if caption else []) + [""]
    return "\n".join(lines + [relative(index, entry)[: -len(".md")] for entry in entries] + ["```", ""])


def toctrees(index, pages):
    """The navigation below an index page: one tree, or on the front page one for each section."""
    sections = re.split(r"^## ", pages[index], flags=re.M) if index == FRONT else [pages[index]]
    trees, listed = "", set()
    for section in sections:
        entries = []
        for path in local_links(index, section):
            if path != index and path not in listed and path in pages and find_index(path, pages) == index:
                entries.append(path)
                listed.add(path)
        if entries:
            trees += toctree(index, entries, section.splitlines()[0].strip() if index == FRONT else "")
    return trees


def tutorial_model(path, text):
    """Query with which the program opens the model of a tutorial: the example that it explains, or else the first it writes."""
    if shown := re.search(r"^```yaml of=examples/([\w-]+)\.yaml$", text, flags=re.M):
        return "example=" + shown.group(1)
    files = check_examples.read_page(ROOT / path).files
    model = next((file for file in files.values() if "overbend: 1" in file), None)
    return "model=" + urllib.parse.quote(model, safe="") if model else ""


def with_program(path, text):
    """A tutorial with its model in the program. The browser loads the frame when it is shown."""
    query = tutorial_model(path, text) if path.startswith("docs/tutorials/") else ""
    if not query:
        return text
    start = text.index("\n## ")
    frame = (f'\n<details class="program"><summary>Run this model in your browser</summary>\n'
             f'<iframe loading="lazy" title="Overbend" src="{relative(path, "docs/" + PROGRAM)}?{query}"></iframe>\n</details>\n')
    return text[:start] + frame + text[start:]


def write_sources(folder, has_program=False):
    pages, files = read_pages()
    if has_program:
        pages = {path: with_program(path, text) for path, text in pages.items()}
    unlisted = [p.relative_to(ROOT).as_posix() for p in sorted((ROOT / "docs").rglob("*.md"))]
    unlisted = [path for path in unlisted if path not in pages]
    if unlisted:
        raise SourceError("no page of the site links to " + ", ".join(unlisted))
    for path, text in pages.items():
        target = folder / site_path(path)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(outside_code(text, lambda prose: with_site_links(path, prose)) + toctrees(path, pages),
                          encoding="utf-8")
    for path in files:
        target = folder / site_path(path)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / path, target)


if __name__ == "__main__":
    try:
        write_sources(pathlib.Path(sys.argv[1]), sys.argv[2:] == ["with-program"])
    except (SourceError, key_tasks.TaskError, bibliography.CitationError) as error:
        sys.exit(f"tools/site/sources.py: {error}")
