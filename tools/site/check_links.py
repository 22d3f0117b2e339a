#!/usr/bin/env python3
"""Checks a finished documentation site: links, anchors, pictures, and that nothing is fetched from the network.

    check_links.py SITE [PICTURES]

Fails on a link to a file or anchor that does not exist, a picture that is missing or has no text in its place, a script,
style or picture of another host, and a picture in the folder PICTURES that no page shows.
"""

import hashlib
import html.parser
import pathlib
import re
import sys
import urllib.parse

# Elements of which a browser fetches what an attribute names, without being asked.
FETCHED = {"img": "src", "script": "src", "link": "href", "iframe": "src", "source": "src", "video": "src", "audio": "src",
           "embed": "src", "object": "data"}
# Relations of link elements that are not fetched.
NOT_FETCHED = {"index", "search", "next", "prev", "canonical"}


class Page(html.parser.HTMLParser):
    """Anchors and references of one page."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.links, self.fetched, self.pictures, self.untitled = set(), [], [], [], []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        names = dict(attributes)
        self.anchors.update(value for name, value in attributes if value and (name == "id" or (tag == "a" and name == "name")))
        if tag == "a" and names.get("href"):
            self.links.append(names["href"])
        fetched = names.get(FETCHED.get(tag, ""))
        if fetched and not (tag == "link" and names.get("rel") in NOT_FETCHED):
            self.fetched.append(fetched)
        elif fetched:
            self.links.append(fetched)
        if tag == "img":
            self.pictures.append(names.get("src") or "")
            if not names.get("alt"):
                self.untitled.append(names.get("src") or "")

    handle_startendtag = handle_starttag


def is_remote(target):
    return bool(re.match(r"(?:[a-z][a-z+.-]*:)?//", target, flags=re.I))


def is_local(target):
    return not re.match(r"[a-z][a-z+.-]*:", target, flags=re.I) and not is_remote(target)


def target_path(page, target):
    """The file and the anchor that a link on a page leads to."""
    parts = urllib.parse.urlsplit(target)
    path = urllib.parse.unquote(parts.path)
    return ((page.parent / path).resolve() if path else page), urllib.parse.unquote(parts.fragment)


def style_problems(site):
    """What style sheets import that is not part of the site."""
    found = []
    for sheet in sorted(site.rglob("*.css")):
        text = sheet.read_text(encoding="utf-8")
        for target in re.findall(r"(?:url\(|@import )[\"']?([^\"')\s;]+)", text):
            if is_remote(target):
                found.append(f"{sheet.relative_to(site)}: {target} is fetched from the network")
            elif is_local(target) and target != "url(" and not target_path(sheet, target)[0].is_file():
                found.append(f"{sheet.relative_to(site)}: {target} leads to no file")
    return found


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def unused_pictures(shown, pictures):
    """Pictures of a folder that are not among those shown; they are compared by content, since a site may rename them."""
    known = {digest(path) for path in shown}
    suffixes = {".png", ".svg", ".jpg", ".jpeg", ".gif", ".webp"}
    return [f"{path}: no page shows this picture" for path in sorted(pictures.rglob("*"))
            if path.suffix.lower() in suffixes and digest(path) not in known]


def problems(site, pictures=None):
    """All that is wrong with a site, as lines of text."""
    site = site.resolve()
    pages = {path.resolve(): Page(path) for path in sorted(site.rglob("*.html"))}
    found, shown = style_problems(site), set()
    if not pages:
        return [f"{site}: no pages"]
    for path, page in pages.items():
        name = path.relative_to(site)
        for target in page.links + page.fetched:
            if not is_local(target):
                continue
            file, anchor = target_path(path, target)
            if file.is_dir():
                file /= "index.html"
            if not file.is_file():
                found.append(f"{name}: {target} leads to no file")
            elif anchor and file in pages and anchor not in pages[file].anchors:
                found.append(f"{name}: {target} leads to no anchor")
        found += [f"{name}: {target} is fetched from the network" for target in page.fetched if is_remote(target)]
        found += [f"{name}: picture {picture} has no alternative text" for picture in page.untitled]
        shown.update(target_path(path, picture)[0] for picture in page.pictures if is_local(picture))
    if pictures:
        found += unused_pictures([picture for picture in shown if picture.is_file()], pictures)
    return found


def main():
    found = problems(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None)
    for line in found:
        print(line, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
