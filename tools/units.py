#!/usr/bin/env python3
"""Groups sources that may be compiled together.

    tools/units.py LARGEST SOURCE...      prints a line "UNIT SOURCE" for every source

Most of a source's time in the compiler and in the linter goes into headers and templates that its neighbours need too.
Two sources stay apart where a name that one declares in an unnamed namespace is a word of the other, or of a header of
this project that only the other includes: it could be defined twice there, or hide another. That is stricter than the
language, and needs no compiler. A name that both borrow from the same place, `using html::fixed;`, is one and the same;
and what a header names within its types, and no header outside of them, is a member there, which nothing hides.
"""

import collections
import functools
import itertools
import os
import pathlib
import re
import sys

# Names that may refer to an outer declaration: called, or named like types and constants.
WORD = re.compile(r"(?<![\w.:>])(?:[a-z_]\w*(?=\()|(?:[A-Z]|k[A-Z])\w*)")
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
NOT_CODE = re.compile(r'//(?! namespace$)[^\n]*|"(?:\\.|[^"\\\n])*"', re.MULTILINE)
ALIASES = {"fs", "py"}  # the same namespace wherever it is one
UNNAMED = re.compile(r"^namespace \{$(.*?)^\}  // namespace$", re.MULTILINE | re.DOTALL)
# The name of what a line at the margin declares: the last word before its parameters, value or body.
DECLARED = re.compile(r"^(?!template|using namespace|TEST|public|private)[A-Za-z_\[][^\n=({;]*?"
                      r"(\w+)(?:\[\w*\])?(?: :(?!:)|\s*[=({;]|$)", re.MULTILINE)
# The same of what stands within something, a type before it: a member, or what a function has for itself.
INSIDE = re.compile(r"^ +(?!(?:return|else|throw|case|new|delete|using)\b)\w[\w:<>,*&\[\] ]*[ *&](\w+)(?:\(|\s*[={;]|$)",
                    re.MULTILINE)
CONSTANTS = re.compile(r"^(?:inline |static )?constexpr [^;]*;", re.MULTILINE)  # of which one line may declare several
CONSTANT = re.compile(r"\b(k[A-Z]\w*)(?:\[\w*\])?\s*[={]")
BORROWED = re.compile(r"^using (?!namespace)(?:[\w:]+::)?(\w+)(?: = [^;]*)?;", re.MULTILINE)


@functools.cache
def code(path):
    return NOT_CODE.sub("", path.read_text(encoding="utf-8"))


@functools.cache
def candidate_names(path):
    return frozenset(WORD.findall(code(path)))


@functools.cache
def identifiers(path):
    return frozenset(re.findall(r"(?<![\w.:>])[A-Za-z_]\w*", code(path)))


@functools.cache
def hidden(path):
    """Names declared in unnamed namespaces of the source."""
    text = code(path)
    parts = UNNAMED.findall(text)
    names = {name for part in parts for name in DECLARED.findall(part)}
    names |= {name for part in parts for line in CONSTANTS.findall(part) for name in CONSTANT.findall(line)}
    return frozenset(names - ALIASES)


@functools.cache
def borrowed(path):
    """Declarations of hidden names that stand for something declared elsewhere, by name."""
    return {found[1]: found[0] for part in UNNAMED.findall(code(path)) for found in BORROWED.finditer(part)}


@functools.cache
def headers(path):
    """Headers of this project that the source includes, directly or indirectly."""
    found, ahead = set(), [path]
    while ahead:
        for name in INCLUDE.findall(ahead.pop().read_text(encoding="utf-8")):
            header = next((root / name for root in roots(path) if (root / name).is_file()), None)
            if header and header not in found:
                found.add(header)
                ahead.append(header)
    return frozenset(found)


@functools.cache
def roots(path):
    return tuple(folder for folder in path.parents if folder.name in ("overbend", "tests", "src")) + tuple(
        folder / "src" / "overbend" for folder in path.parents if (folder / "src" / "overbend").is_dir())


@functools.cache
def outside(root):
    """Names that headers below `root` declare outside of types and functions."""
    return frozenset(name for header in root.rglob("*.h") for name in DECLARED.findall(code(header)))


@functools.cache
def may_be_hidden(header):
    """Words of a header that a name outside could stand for."""
    members = frozenset(INSIDE.findall(code(header))).difference(*(outside(root) for root in roots(header)))
    return candidate_names(header) - members


def by_name(places, names):
    """The places where a name is found, by name."""
    found = collections.defaultdict(set)
    for place in places:
        for name in names(place):
            found[name].add(place)
    return found


def apart(sources):
    """By source, those in which one of its names could mean something else, or that have such a name for it."""
    others = {source: set() for source in sources}
    meant = by_name(sources, lambda source: candidate_names(source) | hidden(source))
    written = by_name(sources, identifiers)
    included = by_name(sources, headers)  # by header
    in_headers = by_name(included, may_be_hidden)
    for source in sources:
        for name in hidden(source):
            of_headers = in_headers[name] - headers(source)
            found = meant[name].union(*(included[header] for header in of_headers))
            declaration = borrowed(source).get(name)
            if declaration:  # a type, say, that a parameter of that name would hide
                found |= written[name]
                found = {clash for clash in found if borrowed(clash).get(name) != declaration}
            for clash in found - {source}:
                others[source].add(clash)
                others[clash].add(source)
    return others


def units(sources, largest):
    """Lists of sources, few as the names allow: those that most others must stay apart from choose first."""
    sources = list(sources)
    others = apart(sources)
    made = []
    for source in sorted(sources, key=lambda source: -len(others[source])):
        for unit in made:
            if len(unit) < largest and others[source].isdisjoint(unit):
                unit.append(source)
                break
        else:
            made.append([source])
    return made


def room(source):
    """The folder of the first level, with all of its sub-rooms."""
    for folder in source.parents:
        if folder.parent.name in ("overbend", "tests"):
            return folder
    return source.parent


def named_units(sources, largest):
    """Units with names, of one room each: a change there compiles little of the others. What is left over in small
    units is put together from all rooms, since every unit costs the headers that nearly all read."""
    left_over = []
    for folder, inside in itertools.groupby(sorted(sources), room):
        for number, unit in enumerate(units(inside, largest)):
            if 4 * len(unit) < 3 * largest:
                left_over += unit
            else:
                yield re.sub(r"\W", "_", "_".join(folder.parts[-2:]), flags=re.ASCII) + f"_{number}", unit
    for number, unit in enumerate(units(left_over, largest)):
        yield f"left_over_{number}", unit


def main():
    largest = int(sys.argv[1])
    sources = [pathlib.Path(name).resolve() for name in sys.argv[2:]]
    for name, unit in named_units(sources, largest):
        for source in unit:  # with the original bytes of the path, for any locale
            sys.stdout.buffer.write(f"{name} ".encode() + os.fsencode(source) + b"\n")


if __name__ == "__main__":
    main()
