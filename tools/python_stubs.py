#!/usr/bin/env python3
"""Writes python/overbend/_core.pyi, the types of the extension module, from the signatures that pybind11 keeps.

    PYTHONPATH=build/release/python tools/python_stubs.py           # writes the file anew
    PYTHONPATH=build/release/python tools/python_stubs.py --check   # exit code 1 where it is out of date
"""

import argparse
import importlib
import inspect
import pathlib
import re
import sys
import types

STUB = pathlib.Path(__file__).resolve().parents[1] / "python" / "overbend" / "_core.pyi"
HEAD = '''"""Types of the extension module. Made by tools/python_stubs.py: do not edit."""

from __future__ import annotations

from typing import Any, Callable, Dict, Iterable, Iterator, List, Optional, Sequence, Set, Tuple, Union

import numpy
'''
# Names that pybind11 gives to arguments without a Python type.
TYPES = [
    (re.compile(r"\bhandle\b"), "Any"),
    (re.compile(r"(?<![\w.])object\b"), "Any"),
    (re.compile(r"(?<![\w.])function\b"), "Callable[..., Any]"),
    (re.compile(r"(?<![\w.])buffer\b"), "Any"),
    (re.compile(r"(?<![\w.])(capsule|iterable|iterator|sequence|module)\b"), "Any"),
    (re.compile(r"\bos\.PathLike\b"), "str"),
    (re.compile(r"\bnumpy\.ndarray(\[[^\]]*(\[[^\]]*\])?[^\]]*\])?"), "numpy.ndarray[Any, Any]"),
]
EMPTY = {"dict": "Dict[str, Any]", "list": "List[Any]", "tuple": "Tuple[Any, ...]", "set": "Set[Any]"}


def split_arguments(text):
    """The arguments of a signature: text between commas outside brackets."""
    found, depth = [""], 0
    for letter in text:
        depth += (letter in "([{<") - (letter in ")]}>")
        if letter == "," and depth == 0:
            found.append("")
        else:
            found[-1] += letter
    return [part.strip() for part in found if part.strip()]


def type_word(word, module):
    """A type of pybind11 as Python has it."""
    word = word.strip().replace(f"{module}.", "")
    for pattern, instead in TYPES:
        word = pattern.sub(instead, word)
    return EMPTY.get(word, word)


def argument(text, module):
    """An argument as a stub has it: every default is an ellipsis."""
    name, _, rest = text.partition(":")
    if not rest or name == "self":
        return name
    word, equals, default = rest.partition(" = ")
    word = type_word(word, module)
    if default == "None" and word != "Any" and not word.startswith("Optional"):
        word = f"Optional[{word}]"
    return f"{name}: {word}" + (" = ..." if equals else "")


def typed(signature, module):
    """A signature of pybind11, "name(argument: type = default) -> type", as Python reads it."""
    head, _, result = signature.rpartition(") -> ")
    name, _, arguments = head.partition("(")
    listed = ", ".join(argument(text, module) for text in split_arguments(arguments))
    return f"{name}({listed}) -> {type_word(result, module)}"


def signatures(what, module):
    """The signatures of a function, of each overload one."""
    lines = (what.__doc__ or "").splitlines()
    name = re.escape(what.__name__)
    if len(lines) > 1 and lines[1].startswith("Overloaded function"):
        return [typed(m[1], module) for line in lines if (m := re.match(rf"\d+\. ({name}\(.*\) -> .*)$", line))]
    if lines and re.match(rf"{name}\(.*\) -> ", lines[0]):
        return [typed(lines[0], module)]
    result = "None" if what.__name__ == "__init__" else "Any"
    return [f"{what.__name__}(self, *args: Any, **keywords: Any) -> {result}"]


def functions(what, module, indent, decorator=""):
    found = signatures(what, module)
    over = f"{indent}@overload\n" if len(found) > 1 else ""
    return [f"{over}{decorator}{indent}def {signature}: ..." for signature in found]


def property_stub(name, what, module):
    found = re.match(r"\(.*\) -> (.*)$", (what.fget.__doc__ or " ").splitlines()[0])
    result = type_word(found[1], module) if found else "Any"
    lines = ["    @property", f"    def {name}(self) -> {result}: ..."]
    if what.fset is not None:
        lines += [f"    @{name}.setter", f"    def {name}(self, value: {result}) -> None: ..."]
    return lines


def class_stub(what, module):
    bases = [base.__name__ for base in what.__bases__ if base.__module__ == module]
    bases += [base.__name__ for base in what.__bases__ if issubclass(base, BaseException)]
    lines = [f"class {what.__name__}({', '.join(bases)}):" if bases else f"class {what.__name__}:"]
    for name, member in vars(what).items():
        if isinstance(member, property):
            lines += property_stub(name, member, module)
        elif isinstance(member, staticmethod):
            lines += functions(member.__func__, module, "    ", "    @staticmethod\n")
        elif inspect.isroutine(member) and (not name.startswith("_") or name in ("__init__", "__len__", "__call__")):
            lines += functions(member, module, "    ")
        elif isinstance(member, what):
            lines.append(f"    {name}: {what.__name__}")
    return lines if len(lines) > 1 else [lines[0] + " ..."]


def stub(module):
    """The text of the stub of an imported extension module."""
    blocks = []
    for name, member in sorted(vars(module).items()):
        if name.startswith("__") or isinstance(member, types.ModuleType):
            continue
        if inspect.isclass(member):
            if member.__module__ == module.__name__:
                blocks.append("\n".join(class_stub(member, module.__name__)))
        elif callable(member):
            blocks.append("\n".join(functions(member, module.__name__, "")))
        else:
            blocks.append(f"{name}: {type(member).__name__}")
    text = HEAD + "\n" + "\n\n".join(blocks) + "\n"
    return text.replace("from typing import Any", "from typing import overload, Any") if "@overload" in text else text


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--check", action="store_true", help="only say whether the file is up to date")
    wanted = stub(importlib.import_module("overbend._core"))
    if not options.parse_args().check:
        STUB.write_text(wanted, encoding="utf-8")
    elif not STUB.exists() or STUB.read_text(encoding="utf-8") != wanted:
        sys.exit(f"{STUB.relative_to(STUB.parents[2])} is out of date: run tools/python_stubs.py")


if __name__ == "__main__":
    main()
