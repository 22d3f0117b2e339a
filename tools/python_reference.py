#!/usr/bin/env python3
"""Writes docs/python/reference.md from the docstrings and signatures of the Python package.

    PYTHONPATH=build/release/python tools/python_reference.py           # writes the page anew
    PYTHONPATH=build/release/python tools/python_reference.py --check   # exit code 1 where it is out of date
"""

import argparse
import inspect
import pathlib
import re
import sys
import textwrap

import overbend

PAGE = pathlib.Path(__file__).resolve().parents[1] / "docs" / "python" / "reference.md"
HEAD = """# Reference of the Python interface

<!-- Made by tools/python_reference.py from the docstrings: do not edit. -->

All values are in SI units; `attrs` of an array and `units` of a number name the unit. The [guide](../guide/python.md)
explains the whole on examples, the [notebooks](README.md) use it.
"""
PARTS = ("Args:", "Returns:", "Raises:", "Yields:")


def wrapped(text, first="", rest=""):
    return textwrap.fill(" ".join(text.split()), 120, initial_indent=first, subsequent_indent=rest, break_long_words=False,
                         break_on_hyphens=False)


def items(lines):
    """Lines of a part, indented ones continuing the entry above, as a list."""
    indent = min(len(line) - len(line.lstrip()) for line in lines if line.strip())
    entries = []
    for line in lines:
        if line.strip() and len(line) - len(line.lstrip()) == indent:
            entries.append(line.strip())
        elif line.strip():
            entries[-1] += " " + line.strip()
    return [wrapped(re.sub(r"^([\w*, ]+?):\s", r"`\1`: ", entry), "- ", "  ") for entry in entries]


def described(doc):
    """A docstring as Markdown."""
    if not doc:
        return []
    out, paragraph, lines = [], [], inspect.cleandoc(doc).splitlines() + [""]
    at = 0

    def close():
        if paragraph:
            out.extend([wrapped(" ".join(paragraph)), ""])
            paragraph.clear()

    while at < len(lines):
        line = lines[at]
        at += 1
        word = next((part for part in PARTS if line.startswith(part)), None)
        if word is None and line.startswith(" "):
            close()
            block = [line]
            while at < len(lines) and (lines[at].startswith(" ") or (not lines[at] and lines[at + 1:at + 2] and
                                                                     lines[at + 1].startswith(" "))):
                block.append(lines[at])
                at += 1
            out.extend(["```python", *textwrap.dedent("\n".join(block)).splitlines(), "```", ""])
        elif word is None:
            paragraph.append(line.strip()) if line.strip() else close()
        else:
            close()
            said = line[len(word):].strip()
            more = []
            while at < len(lines) and lines[at].startswith(" "):
                more.append(lines[at])
                at += 1
            if said:
                out.extend([wrapped(" ".join([f"*{word[:-1]}*: {said}", *more])), ""])
            elif more:
                out.extend([f"*{word[:-1]}*:", "", *items(more), ""])
    return out


def call(name, function, bound):
    """A signature, without self and without quotes round annotations."""
    try:
        signature = inspect.signature(function)
    except (TypeError, ValueError):
        return f"{name}(...)"
    parameters = list(signature.parameters.values())[1 if bound else 0:]
    return f"{name}{signature.replace(parameters=parameters)}"


def shown_call(text):
    """A signature as a block of code: in one line where it fits, else a line per argument."""
    if len(text) <= 110:
        return ["```python", text, "```", ""]
    head, rest = text.split("(", 1)
    inside, depth, arguments = rest, 0, [""]
    for k, letter in enumerate(inside):
        if letter in "([{":
            depth += 1
        elif letter in ")]}":
            if depth == 0:
                tail = inside[k:]
                break
            depth -= 1
        if letter == "," and depth == 0:
            arguments.append("")
        else:
            arguments[-1] += letter
    lines = textwrap.fill(", ".join(a.strip() for a in arguments), 110, initial_indent="    ", subsequent_indent="    ",
                          break_long_words=False, break_on_hyphens=False).splitlines()
    return ["```python", f"{head}(", *lines, tail, "```", ""]


def members(of):
    """Public members in the order of definition, those of bases in the package after them."""
    seen = {}
    for base in of.__mro__:
        if base.__module__.partition(".")[0] == "overbend":
            for name, member in vars(base).items():
                if not name.startswith("_") or name in ("__getitem__", "__len__", "__call__"):
                    seen.setdefault(name, member)
    return seen


def member_text(owner, name, member):
    """What is told of a member of a class; nothing where it has no docstring."""
    if isinstance(member, property):
        doc = member.__doc__
        result = inspect.signature(member.fget).return_annotation
        kind = "" if result is inspect.Signature.empty else f": {result}"
        head = [f"`{name}{kind}`", ""] if doc else []
    elif isinstance(member, (classmethod, staticmethod)):
        doc = member.__func__.__doc__
        head = shown_call(call(f"{owner}.{name}", member.__func__, isinstance(member, classmethod))) if doc else []
    elif inspect.isfunction(member):
        doc = member.__doc__
        head = shown_call(call(name, member, True)) if doc else []
    else:
        return []
    return [f"#### {owner}.{name}", "", *head, *described(doc)] if doc else []


def class_text(name, of):
    bases = [base.__name__ for base in of.__bases__ if base is not object]
    out = [f"### {name}" + (f" ({', '.join(bases)})" if bases else ""), "", *described(of.__doc__)]
    for member_name, member in members(of).items():
        out += member_text(name, member_name, member)
    return out


def function_text(name, function):
    return [f"### {name}", "", *shown_call(call(name, function, False)), *described(function.__doc__)]


def public():
    """(name, object) of all that users see, by the module in which it is defined."""
    modules = {}
    plots = sys.modules.get("overbend.plots") or __import__("overbend.plots").plots
    for package in (overbend, plots):
        for name in package.__all__:
            what = getattr(package, name)
            if inspect.isclass(what) or inspect.isfunction(what):
                home = "overbend.plots" if what.__module__.startswith("overbend.plots") else what.__module__
                modules.setdefault(home, {})[name] = what
    return modules


def page():
    out = [HEAD]
    for home, members_of in public().items():
        out += [f"## {home.rpartition('.')[2].replace('_', ' ').strip().capitalize()}", ""]
        out += described(sys.modules[home].__doc__)
        for name, what in members_of.items():
            out += class_text(name, what) if inspect.isclass(what) else function_text(name, what)
    return re.sub(r"\n{3,}", "\n\n", "\n".join(out)).rstrip() + "\n"


def undocumented():
    """Names of public classes, functions, methods and properties without a docstring."""
    missing = []
    for home, members_of in public().items():
        for name, what in members_of.items():
            if not what.__doc__:
                missing.append(f"{home}.{name}")
            for each, member in (members(what) if inspect.isclass(what) else {}).items():
                told = getattr(member, "__func__", member)
                if isinstance(member, (property, classmethod, staticmethod)) or inspect.isfunction(member):
                    if not told.__doc__ and not each.startswith("__"):
                        missing.append(f"{home}.{name}.{each}")
    return missing


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--check", action="store_true", help="only say whether the page is up to date")
    checking = options.parse_args().check
    if missing := undocumented():
        sys.exit("no docstring: " + ", ".join(missing))
    if not checking:
        PAGE.write_text(page(), encoding="utf-8")
    elif not PAGE.exists() or PAGE.read_text(encoding="utf-8") != page():
        sys.exit(f"{PAGE.relative_to(PAGE.parents[2])} is out of date: run tools/python_reference.py")


if __name__ == "__main__":
    main()
