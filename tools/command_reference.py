#!/usr/bin/env python3
"""Writes docs/command-line.md from the help texts of the program.

    tools/command_reference.py PROGRAM           # writes the page anew
    tools/command_reference.py PROGRAM --check   # exit code 1 where it is out of date
"""

import argparse
import pathlib
import re
import subprocess
import sys

PAGE = pathlib.Path(__file__).resolve().parents[1] / "docs" / "command-line.md"
HEAD = """# Command line

<!-- Made by tools/command_reference.py from the help texts of the program: do not edit. -->

`overbend COMMAND --help` prints the same; `man overbend` shows all of it where the program is installed. Exit codes:
[errors and exit codes](guide/errors.md).
"""


def help_text(program, *command):
    """Help of a command, or of the program."""
    done = subprocess.run([program, *command, "--help"], capture_output=True, encoding="utf-8", check=True)
    return done.stdout


def items(text, heading):
    """Names with their kinds, and meanings, below a heading of a help text."""
    block = re.search(rf"^{heading}:\n((?:  .*\n|\n(?=  ))*)", text, flags=re.M)
    found = []
    for line in block.group(1).splitlines() if block else []:
        if not line.strip():
            continue
        if line.startswith(" " * 30):
            found[-1][1] = (found[-1][1] + " " + line.strip()).strip()
            continue
        # A name too long for its column has its meaning on the next line.
        name, gap, meaning = line[2:].partition("  ")
        found.append([name.strip(), meaning.strip()])
    return found


def commands(program):
    """Names of the commands."""
    return [name for name, _ in items(help_text(program), "Subcommands")]


def options(program, command):
    """Names of the options of a command, without help."""
    names = [name for name, _ in items(help_text(program, command), "Options")]
    return [option for name in names for option in re.match(r"[^ {]+", name).group().split(",")]


def cell(text):
    return text.replace("|", "\\|").replace("*", "\\*").replace("<", "&lt;")


def names_and_values(name):
    """Name, kind or choices, and default of an item: `-o,--output TEXT`, `--units TEXT:{metric,us}`."""
    parts = name.replace(" (Env:", "\n(Env:").split("\n")[0].split(" ", 1)
    names = ", ".join(f"`{re.sub('{.*}', '', word)}`" for word in parts[0].split(","))
    rest = parts[1] if len(parts) > 1 else ""
    required = " REQUIRED" in rest
    rest = re.sub(r" ?\b(?:Excludes|Needs): .*$", "", rest.replace(" REQUIRED", "")).replace(" ...", "")
    rest, _, default = rest.partition("=")
    kind, _, choices = rest.partition(":")
    kinds = {"TEXT": "text", "INT": "whole number", "UINT": "whole number", "FLOAT": "number"}
    if choices.startswith("{"):
        value = ", ".join(f"`{choice}`" for choice in choices[1:-1].split(","))
    elif choices.isupper():  # a unit
        value = choices.lower()
    else:
        value = ", ".join(part for part in (kinds.get(kind, kind), choices) if part)
    value += f", default {default}" if default else ""
    return names, value + (", required" if required and value else "required" if required else "")


def table(found):
    lines = ["| name | value | meaning |", "|---|---|---|"]
    for name, meaning in found:
        names, value = names_and_values(name)
        lines.append(f"| {names} | {cell(value)} | {cell(meaning)} |")
    return "\n".join(lines)


def section(program, command):
    text = help_text(program, command)
    usage = re.search(r"^Usage: (.*)$", text, flags=re.M).group(1)
    found = items(text, "Positionals") + [item for item in items(text, "Options") if item[0] != "-h,--help"]
    parts = [f"## {command}", cell(text.split("\nUsage:")[0].strip()), f"```sh\n{usage}\n```"]
    return "\n\n".join(parts + ([table(found)] if found else []))


def page(program):
    found = commands(program)
    return "\n\n".join([HEAD.strip(), *(section(program, command) for command in found)]) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--check", action="store_true")
    given = parser.parse_args()
    text = page(given.program)
    if given.check:
        if PAGE.read_text(encoding="utf-8") != text:
            sys.exit("docs/command-line.md is out of date; run: tools/command_reference.py build/release/overbend")
    else:
        PAGE.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
