#!/usr/bin/env python3
"""Writes docs/python/reference.md from the docstrings and signatures of the Python package.

    PYTHONPATH=build/release/python tools/python_reference.py           # writes the page anew
    PYTHONPATH=build/release/python tools/python_reference.py --check   # exit code 1 where it is out of date
"""

import argparse
import functools
import inspect
import pathlib
import re
import sys
import textwrap

import overbend
import overbend.plots

PAGE = pathlib.Path(__file__).resolve().parents[1] / "docs" / "python" / "reference.md"
HEAD = """# Reference of the Python interface

<!-- Made by tools/python_reference.py from the docstrings: do not edit. -->

All values are in SI units; `attrs` of an array and `units` of a number name the unit. The [guide](../guide/python.md)
explains the whole on examples, the [notebooks](README.md) use it.
"""
# Modules in the order of the page, with their headings; others follow under their own names.
HEADINGS = {
    "model": "Models", "results": "Results", "objects": "Results by object", "findings": "Findings", "runs": "Several runs", "seeking": "Goal seek", "studies": "Studies",
    "lay_table": "Lay tables",
    "operation": "Operations on the line", "lift": "Stages of a lift", "sensitivities": "Derivatives", "simulation": "Simulations step by step",
    "controllers": "Controllers", "comparison": "Comparisons", "opening": "Results in folders", "plots": "Figures",
    "groups": "Groups and tables", "values": "Numbers and arrays", "examples": "Examples", "errors": "Errors",
}
PART = re.compile(r"^(Args|Returns|Raises|Attributes[^:]*):(.*)$")
SPECIAL = {"__getitem__": "{}[...]", "__len__": "len({})", "__call__": "{}(...)"}
WIDTH = 120


class Plain(str):
    """An annotation that is shown without quotes."""

    def __repr__(self):
        return str(self)


def wrapped(text, first="", rest=""):
    return textwrap.fill(" ".join(text.split()), WIDTH, initial_indent=first, subsequent_indent=rest,
                         break_long_words=False, break_on_hyphens=False)


def entries(lines):
    """Lines of a part as a list; lines indented deeper continue the entry above."""
    indent = min(len(line) - len(line.lstrip()) for line in lines if line.strip())
    found = []
    for line in lines:
        if line.strip() and len(line) - len(line.lstrip()) == indent:
            found.append(line.strip())
        elif line.strip():
            found[-1] += " " + line.strip()
    return [wrapped(re.sub(r"^([\w*]+(, [\w*]+)*):\s", named, entry), "- ", "  ") for entry in found]


def named(found):
    return ", ".join(f"`{name}`" for name in found[1].split(", ")) + ": "


def paragraphs(doc):
    """A docstring as (first line, indented lines below it) and paragraphs, in their order."""
    lines, i, blocks = inspect.cleandoc(doc).splitlines(), 0, []
    while i < len(lines):
        start, indented = i, lines[i].startswith(" ") or bool(PART.match(lines[i]))
        i += 1
        if indented:
            while i < len(lines) and (lines[i].startswith(" ") or not lines[i].strip()):
                i += 1
        else:
            while i < len(lines) and lines[i].strip() and not lines[i].startswith(" ") and not PART.match(lines[i]):
                i += 1
        if any(line.strip() for line in lines[start:i]):
            blocks.append(lines[start:i])
    return blocks


def described(doc):
    """A docstring as lines of Markdown."""
    out = []
    for block in paragraphs(doc or ""):
        part = PART.match(block[0])
        below = [line for line in block[1:] if line.strip()]
        if part and below and not part[2].strip():
            out += [f"*{part[1]}*:", "", *entries(below), ""]
        elif part:
            out += [wrapped(f"*{part[1]}*: " + " ".join([part[2], *below])), ""]
        elif block[0].startswith(" "):
            out += ["```python", *textwrap.dedent("\n".join(block)).strip("\n").splitlines(), "```", ""]
        else:
            out += [wrapped(" ".join(block)), ""]
    return out


def plain(annotation):
    none = annotation is inspect.Parameter.empty
    return annotation if none else Plain(str(annotation).replace("'", "").replace('"', ""))


def call(name, function, bound):
    """A signature as a block of code, without self; in one line where it fits."""
    signature = inspect.signature(function)
    parameters = [p.replace(annotation=plain(p.annotation)) for p in signature.parameters.values()][1 if bound else 0:]
    shown = signature.replace(parameters=parameters, return_annotation=plain(signature.return_annotation))
    text = f"{name}{shown}"
    if len(text) > WIDTH - 10:
        listed = ", ".join(str(p) for p in parameters)
        result = "" if shown.return_annotation is inspect.Signature.empty else f" -> {shown.return_annotation}"
        stars = [p.kind for p in parameters]
        if inspect.Parameter.KEYWORD_ONLY in stars and inspect.Parameter.VAR_POSITIONAL not in stars:
            first = stars.index(inspect.Parameter.KEYWORD_ONLY)
            listed = ", ".join([*map(str, parameters[:first]), "*", *map(str, parameters[first:])])
        text = f"{name}(\n{wrapped(listed, '    ', '    ')}\n){result}"
    return ["```python", *text.splitlines(), "```", ""]


def members(of):
    """Public members in the order of definition, those of bases in the package after them."""
    seen = {}
    for base in of.__mro__:
        if base.__module__.partition(".")[0] == "overbend":
            for name, member in vars(base).items():
                if not name.startswith("_") or name in SPECIAL:
                    seen.setdefault(name, member)
    return seen


def is_property(member):
    return isinstance(member, (property, functools.cached_property))


def member_text(owner, name, member):
    """Description of a member of a class; empty if it has no docstring."""
    if is_property(member):
        getter = member.fget if isinstance(member, property) else member.func
        doc, result = member.__doc__, inspect.signature(getter).return_annotation
        head = [f"`{name}: {plain(result)}`", ""]
    elif isinstance(member, (classmethod, staticmethod)):
        doc = member.__func__.__doc__
        head = call(f"{owner}.{name}", member.__func__, isinstance(member, classmethod))
    elif inspect.isfunction(member):
        doc, head = member.__doc__, [] if name in SPECIAL else call(name, member, True)
    else:
        return []
    title = SPECIAL[name].format(owner) if name in SPECIAL else f"{owner}.{name}"
    return [f"#### {title}", "", *head, *described(doc)] if doc else []


def class_text(name, of):
    bases = [base.__name__ for base in of.__bases__ if base is not object and not base.__name__.startswith("_")]
    out = [f"### {name}", ""] + ([f"Derived from {' and '.join(bases)}.", ""] if bases else [])
    out += described(of.__doc__)
    init = vars(of).get("__init__")
    if init is not None and init.__doc__ and not init.__doc__.lstrip().startswith("Not for users"):
        out += call(name, init, True) + described(init.__doc__)
    for member_name, member in members(of).items():
        out += member_text(name, member_name, member)
    return out


def function_text(name, function):
    return [f"### {name}", "", *call(name, function, False), *described(function.__doc__)]


def public():
    """What users see: by the module in which it is defined, in the order of the page."""
    modules = {home: {} for home in HEADINGS}
    for package in (overbend, overbend.plots):
        for name in package.__all__:
            what = getattr(package, name)
            if inspect.isclass(what) or inspect.isfunction(what):
                modules.setdefault(what.__module__.split(".")[1], {})[name] = what
    return {home: found for home, found in modules.items() if found}


def page():
    out = [HEAD]
    for home, found in public().items():
        out += [f"## {HEADINGS.get(home, home)}", "", *described(sys.modules[f"overbend.{home}"].__doc__)]
        for name, what in sorted(found.items(), key=lambda item: inspect.getsourcelines(item[1])[1]):
            out += class_text(name, what) if inspect.isclass(what) else function_text(name, what)
    return re.sub(r"\n{3,}", "\n\n", "\n".join(out)).rstrip() + "\n"


def undocumented():
    """Names of public classes, functions, methods and properties without a docstring."""
    missing = []
    for home, found in public().items():
        for name, what in found.items():
            whole = {"": what, **(members(what) if inspect.isclass(what) else {})}
            for each, member in whole.items():
                function = getattr(member, "__func__", member)
                needs_docstring = is_property(member) or inspect.isfunction(function) or inspect.isclass(function)
                if needs_docstring and not function.__doc__ and not each.startswith("__"):
                    missing.append(f"overbend.{home}.{name}" + (f".{each}" if each else ""))
    return missing


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--check", action="store_true", help="only check that the page is up to date")
    checking = options.parse_args().check
    if missing := undocumented():
        sys.exit("no docstring: " + ", ".join(missing))
    if not checking:
        PAGE.write_text(page(), encoding="utf-8")
    elif not PAGE.exists() or PAGE.read_text(encoding="utf-8") != page():
        sys.exit(f"{PAGE.relative_to(PAGE.parents[2])} is out of date: run tools/python_reference.py")


if __name__ == "__main__":
    main()
