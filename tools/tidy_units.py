#!/usr/bin/env python3
"""Writes the compile commands that the linter reads: sources together in units.

    tools/tidy_units.py COMPILE_COMMANDS DIRECTORY [EXPRESSION ...]

Nearly all of the linter's time goes into the headers of libraries; a unit goes through them once for all its sources,
of the engine, of what stands around it and of the Python package alike. Kernels, which are compiled once per
instruction set, are looked at once each. With expressions, only sources whose path matches one.
"""

import json
import pathlib
import re
import sys

from units import units

LARGEST_UNIT = 48
ONLY_OF_GCC = r" -mmemset-strategy=\S+"


def sources(commands, expressions):
    """The command of every source below src/ that is asked for, by path."""
    root = pathlib.Path.cwd() / "src"
    chosen = {}
    for command in commands:
        path = pathlib.Path(command["file"])
        if root not in path.parents:
            continue
        inside = str(path.relative_to(root))
        if not expressions or any(re.search(expression, inside) for expression in expressions):
            chosen[path] = command
    return chosen


def options(command):
    """Definitions and places of headers that a command has, an option each."""
    return re.findall(r"-D\S+|-I\S+|-isystem \S+", command["command"])


def groups(chosen):
    """Sources that may share a unit, with names that get along: kernels, and all others. Those differ in definitions
    and headers that the others do not know of."""
    kernels = {path for path in chosen if path.stem.endswith("_kernel")}
    for paths in kernels, chosen.keys() - kernels:
        yield from units(sorted(paths), LARGEST_UNIT)


def unit_command(paths, chosen, directory):
    """The command for a file that includes `paths`, which it writes: that of the first with the options of all."""
    command = dict(chosen[paths[0]])
    missing = {option: None for path in paths for option in options(chosen[path])}  # in their order
    for option in options(command):
        missing.pop(option, None)
    command["command"] = " ".join([re.sub(ONLY_OF_GCC, "", command["command"]), *missing])
    if len(paths) > 1:
        unit = directory / f"{paths[0].parent.name}_{paths[0].stem}_and_{len(paths) - 1}_more.cpp"
        lines = [f'#include "{path}"  // NOLINT(bugprone-suspicious-include)\n' for path in paths]
        unit.write_text("".join(lines), encoding="utf-8")
        command["command"] = command["command"].replace(str(paths[0]), str(unit))
        command["file"] = str(unit)
    return command


def main():
    commands = json.loads(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"))
    directory = pathlib.Path(sys.argv[2])
    chosen = sources(commands, sys.argv[3:])
    if not chosen:
        sys.exit("tools/tidy_units.py: no source matches")
    result = [unit_command(paths, chosen, directory) for paths in groups(chosen)]
    (directory / "compile_commands.json").write_text(json.dumps(result), encoding="utf-8")
    print(f"linting {len(chosen)} sources in {len(result)} units")


main()
