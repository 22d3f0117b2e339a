#!/usr/bin/env python3
"""Runs the examples in the pages of docs/ and examples/ and compares the numbers that the pages state.

    tools/check_examples.py PROGRAM [PAGE...]             all pages if none is given
    tools/check_examples.py PROGRAM --write [PAGE...]     updates the numbers in the pages

An example in a page:

    <!-- example: static examples/jlay.yaml -->
    | result | value |
    |---|---|
    | `static.top_tension` | 560.0 kN |
    | `checks.worst.utilisation` | 0.81 |
    <!-- /example -->

The comment holds the command line of the program without the output folder. It is run in a temporary folder with links to
the folders of the repository, so that paths are those from its root. A fenced block whose first line is

    ```yaml file=name.yaml

is written into that folder before the examples that follow it in the page. Further blocks of the same name add their
top-level groups or replace those that are there. With `file=name.yaml base=examples/other.yaml` the block starts from a
file of the repository or from an earlier block of the page. A block with `of=examples/jlay.yaml` shows a part of a file of the
repository: its lines must be there, in this order; comments may differ.

Each row of the table has the path of a result in summary.json and its value: a number with its unit, or a word. Items of a
list are given in brackets, by name or by index from 0. A number must agree within half a unit of its last digit. Further
columns and other text are ignored.
"""

import argparse
import concurrent.futures
import dataclasses
import json
import math
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
FOLDERS = ("docs", "examples")
COMMANDS = ("static", "dynamic", "seek", "study", "lay-table")
LIMIT_S = 900.0  # per run: an example takes at most 5 s on a machine at rest, but tests share theirs

# Unit: value of one such unit in SI, as in summary.json.
UNITS = {
    "": 1.0, "%": 0.01, "m": 1.0, "mm": 1e-3, "km": 1e3, "in": 0.0254, "ft": 0.3048, "1/m": 1.0, "m/s": 1.0, "1/h": 1 / 3600,
    "N": 1.0, "kN": 1e3, "MN": 1e6, "kip": 4448.2216152605, "N/m": 1.0, "kN/m": 1e3, "Pa": 1.0, "kPa": 1e3, "MPa": 1e6,
    "GPa": 1e9, "ksi": 6894757.293168361, "kN*m": 1e3, "kN m": 1e3, "MN*m": 1e6, "kN*m^2": 1e3, "MN*m^2": 1e6, "kg/m": 1.0,
    "s": 1.0, "min": 60.0, "h": 3600.0, "rad": 1.0, "deg": math.pi / 180, "t": 1e3,
}

FENCE = re.compile(r"^\s*(`{3,}|~{3,})(.*)$")
BEGIN = re.compile(r"^\s*<!--\s*example:\s*(.*?)\s*-->\s*$")
END = re.compile(r"^\s*<!--\s*/example\s*-->\s*$")
ROW = re.compile(r"^(\s*\|\s*`([^`]+)`\s*\|\s*)([^|]*?)(\s*\|.*)$")
NUMBER = re.compile(r"^([-+]?\d[\d,]*(?:\.\d+)?(?:e[-+]?\d+)?)(?:\s*(\S.*))?$")
GROUP = re.compile(r"^(?=[a-z_]+:)", re.MULTILINE)
PART = re.compile(r"\[([^\]]*)\]|([^.\[\]]+)")


class Mistake(Exception):
    """What is wrong with an example, without the place in the page."""


@dataclasses.dataclass
class Row:
    line: int  # from 1
    path: str
    value: str


@dataclasses.dataclass
class Example:
    page: pathlib.Path
    line: int  # from 1
    command: str
    files: dict  # name: text, of the blocks before it
    rows: list = dataclasses.field(default_factory=list)

    def place(self, line=None):
        page = self.page.resolve()
        return f"{page.relative_to(ROOT) if page.is_relative_to(ROOT) else page}:{line or self.line}"


@dataclasses.dataclass
class Page:
    examples: list
    files: dict  # name: text, of all blocks
    messages: list


def groups(text):
    """Text of a model by its top-level groups; what comes before the first has the name ''."""
    head, *rest = GROUP.split(text)
    return {"": head, **{part.partition(":")[0]: part for part in rest}}


def derive_model(text, base, files):
    """The base with the top-level groups of the text; paths of the base are made those from the root."""
    if base in files:
        before = files[base]
    elif (ROOT / base).is_file():
        depth = len(pathlib.PurePosixPath(base).parts) - 1
        before = (ROOT / base).read_text(encoding="utf-8")
        before = before.replace("../" * depth, "") if depth else before
    else:
        raise Mistake(f"base={base}: neither a file of the repository nor an earlier block of the page")
    merged = {**groups(before), **groups(text)}
    return "".join(part if part.endswith("\n") else part + "\n" for part in merged.values() if part)


def missing_line(text, path):
    """The first line of the text that the file does not have in this order, comments aside; None if there is none."""
    def lines(text):
        return [line for line in (re.sub(r"\s*(^|\s)#.*", "", line).rstrip() for line in text.splitlines()) if line]

    rest = iter(lines((ROOT / path).read_text(encoding="utf-8")))
    return next((line for line in lines(text) if line not in rest), None)


def read_page(page):
    """The examples of a page, its files, and messages about its mark-up."""
    examples, messages, files = [], [], {}
    fence, block, attributes, example = None, [], {}, None

    def report(line, message):
        messages.append(f"{Example(page, line, '', {}).place()}: {message}")

    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        mark = FENCE.match(line)
        if fence and mark and mark[1].startswith(fence) and not mark[2].strip():
            fence = None
            if (of := attributes.get("of")) and (line := missing_line("\n".join(block), of)):
                report(number, f"{of} has no such line, or has it earlier: {line.strip()}")
            if name := attributes.get("file"):
                text, base = "\n".join(block) + "\n", attributes.get("base", name if name in files else None)
                try:
                    files = {**files, name: derive_model(text, base, files) if base else text}
                except Mistake as mistake:
                    report(number, mistake)
        elif fence:
            block.append(line)
        elif mark:
            fence, block = mark[1], []
            attributes = dict(word.split("=", 1) for word in mark[2].split() if "=" in word)
        elif begin := BEGIN.match(line):
            if example:
                report(example.line, "the example has no end: add <!-- /example -->")
            example = Example(page, number, begin[1], files)
            examples.append(example)
        elif END.match(line):
            if not example:
                report(number, "<!-- /example --> without a beginning")
            elif not example.rows:
                report(example.line, "the example has no rows with results")
            example = None
        elif example and (row := ROW.match(line)):
            example.rows.append(Row(number, row[2], row[3]))
    if example:
        report(example.line, "the example has no end: add <!-- /example -->")
    return Page(examples, files, messages)


def run_example(program, example, folder):
    """Runs the command in the folder; returns the folder with the results."""
    arguments = shlex.split(example.command)
    if not arguments or arguments[0] not in COMMANDS:
        raise Mistake(f"the command must be one of {', '.join(COMMANDS)}: {example.command!r}")
    if {"-o", "--output"} & set(arguments):
        raise Mistake("leave out the output folder")
    for entry in ROOT.iterdir():
        if entry.is_dir() and not entry.name.startswith("."):
            (folder / entry.name).symlink_to(entry)
    for name, text in example.files.items():
        if "/" in name:
            raise Mistake(f"file={name}: give a name without a folder")
        (folder / name).write_text(text, encoding="utf-8")
    environment = {k: v for k, v in os.environ.items() if k != "OVERBEND_UNITS"}
    try:
        done = subprocess.run([program, *arguments, "-o", "example-results"], cwd=folder, capture_output=True,
                              encoding="utf-8", timeout=LIMIT_S, env=environment)
    except subprocess.TimeoutExpired:
        raise Mistake(f"not finished after {LIMIT_S:g} s: overbend {example.command}") from None
    if done.returncode != 0:
        end = "\n".join((done.stdout + done.stderr).splitlines()[-12:])
        raise Mistake(f"exit code {done.returncode}: overbend {example.command}\n{end}")
    return folder / "example-results"


def find_result(summary, path):
    """Value at a path such as static.supports[stinger 7].reaction; objects of `objects` need no prefix."""
    parts = [bracket or name for bracket, name in PART.findall(path)]
    value = summary
    if parts[0] not in value and parts[0] in value.get("objects", {}):
        value = value["objects"]
    for part in parts:
        if isinstance(value, list):
            named = [item for item in value if isinstance(item, dict) and item.get("name") == part]
            if named:
                value = named[0]
            elif re.fullmatch(r"\d+", part) and int(part) < len(value):
                value = value[int(part)]
            else:
                raise Mistake(f"{path}: no item {part!r}")
        elif isinstance(value, dict) and part in value:
            value = value[part]
        else:
            known = f", there is: {', '.join(map(str, value))}" if isinstance(value, dict) else ""
            raise Mistake(f"{path}: no {part!r}{known}")
    if isinstance(value, (dict, list)):
        raise Mistake(f"{path} is a group, not a value")
    return value


def compare(stated, found):
    """Returns whether the stated value agrees, and the found one written in the same way."""
    number = NUMBER.match(stated)
    if isinstance(found, bool) or not isinstance(found, (int, float)):
        word = {True: "yes", False: "no", None: "none"}.get(found, found) if not isinstance(found, str) else found
        return stated == word, word
    if not number:
        raise Mistake(f"expected a number with its unit, as 12.3 kN, but the page has {stated!r}")
    digits, unit = number[1], number[2] or ""
    if unit not in UNITS:
        raise Mistake(f"unknown unit {unit!r}; known are {', '.join(u for u in UNITS if u)}")
    value = found / UNITS[unit]
    mantissa, _, exponent = digits.partition("e")
    decimals = len(mantissa.partition(".")[2])
    half = 0.5 * 10.0 ** (int(exponent or 0) - decimals)
    if exponent:
        written = re.sub(r"e([-+])0*(\d)", lambda m: "e" + m[1].strip("+") + m[2], f"{value:.{decimals}e}")
    else:
        written = f"{value:{',' if ',' in digits else ''}.{decimals}f}"
    agrees = abs(value - float(digits.replace(",", ""))) <= half * (1 + 1e-6)
    return agrees, f"{written} {unit}".strip()


def check_example(program, example):
    """Messages, and the rows whose values differ with the values found."""
    messages, updates = [], []
    try:
        with tempfile.TemporaryDirectory() as folder:
            results = run_example(program, example, pathlib.Path(folder))
            summary = json.loads((results / "summary.json").read_text(encoding="utf-8"))
    except Mistake as mistake:
        return [f"{example.place()}: {mistake}"], []
    for row in example.rows:
        try:
            agrees, found = compare(row.value, find_result(summary, row.path))
        except Mistake as mistake:
            messages.append(f"{example.place(row.line)}: {mistake}")
            continue
        if not agrees:
            messages.append(f"{example.place(row.line)}: {row.path}: expected {row.value}, found {found}")
            updates.append((row.line, found))
    return messages, updates


def write_updates(page, updates):
    lines = page.read_text(encoding="utf-8").splitlines(keepends=True)
    for number, found in updates:
        lines[number - 1] = ROW.sub(lambda m: m[1] + found + m[4], lines[number - 1].rstrip("\n")) + "\n"
    page.write_text("".join(lines), encoding="utf-8")


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    options.add_argument("program", type=pathlib.Path, help="the program overbend")
    options.add_argument("pages", nargs="*", type=pathlib.Path, help="pages to check; default: all of docs/ and examples/")
    options.add_argument("--write", action="store_true", help="update the values in the pages")
    given = options.parse_args()
    program = given.program.resolve()
    pages = given.pages or sorted(page for folder in FOLDERS for page in (ROOT / folder).rglob("*.md"))
    examples, failures = [], []
    for page in pages:
        found = read_page(page)
        examples += found.examples
        failures += found.messages
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        outcomes = list(pool.map(lambda example: check_example(program, example), examples))
    updates = {}
    for example, (messages, changed) in zip(examples, outcomes):
        failures += messages
        updates.setdefault(example.page, []).extend(changed)
    for message in failures:
        print(message)
    if given.write:
        for page, changed in updates.items():
            write_updates(page, changed)
        print(f"{sum(map(len, updates.values()))} values updated")
    print(f"{len(examples)} examples, {sum(len(e.rows) for e in examples)} values, {len(failures)} messages")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
