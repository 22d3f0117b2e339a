#!/usr/bin/env python3
"""Holds the layers of src/overbend apart: prints file:line of every include that the plan does not allow.

    tools/check_layers.py [ROOT]     ROOT is the repository (default: the one this file lies in)

The plan is the two tables below; ARCHITECTURE.md explains it. Exit code 0: clean; 1: offences; 2: nothing to check.
"""

import pathlib
import re
import sys

EVERYTHING = {
    "base", "model", "results", "numerics", "mechanics", "hull", "moorings", "system", "statics", "dynamics", "recording", "checks",
    "modelfile", "seafiles", "runstore", "resultfiles", "study", "report", "serve", "app", "python",
}

# Layer -> the layers it may include, besides itself.
PLAIN = {"results", "model", "base"}
ENGINE = {"mechanics", "hull", "moorings", "numerics"} | PLAIN
MAY_INCLUDE = {
    "base": set(),
    "model": {"base"},
    "results": {"model", "base"},
    "numerics": {"base"},
    "mechanics": {"model", "base"},
    "hull": {"mechanics", "numerics", "model", "base"},
    "moorings": {"hull", "mechanics", "numerics", "model", "base"},
    "system": ENGINE,
    "checks": {"mechanics"} | PLAIN,
    "statics": {"system"} | ENGINE,
    "dynamics": {"statics", "system"} | ENGINE,
    "recording": {"dynamics", "statics", "system", "checks"} | ENGINE,
    "seafiles": {"model", "base"},
    "modelfile": {"seafiles", "checks", "resultfiles", "model", "base"},
    "runstore": PLAIN,
    "resultfiles": {"runstore"} | PLAIN,
    "study": EVERYTHING - {"app", "serve", "python"},
    "report": EVERYTHING - {"app", "serve", "python", "study"},
    "serve": EVERYTHING - {"app", "python"},
    "python": EVERYTHING - {"app", "serve"},
    "app": EVERYTHING - {"python"},
}

# How a library's headers begin -> the layers that may use it. A library that is not here may not be used anywhere.
LIBRARIES = [
    ("Eigen/", EVERYTHING),
    ("unsupported/Eigen/", {"numerics"}),
    ("fmt/", EVERYTHING),
    ("immintrin.h", {"mechanics", "numerics"}),
    ("yaml-cpp/", {"base", "modelfile", "seafiles"}),
    ("hdf5", {"resultfiles", "seafiles"}),
    ("nlohmann/", {"base"}),
    ("pybind11/", {"python"}),
    ("httplib.h", {"serve"}),
    ("xlsxwriter.h", {"resultfiles"}),
    ("udunits2.h", {"base"}),
    ("CLI/", {"app"}),
]

# Headers of the operating system, for files, terminals, signals and sockets.
SYSTEM_HEADER = re.compile(r"^(sys/\w+|unistd|spawn|fcntl|signal|termios|csignal|poll|arpa/\w+)\.h$")
SYSTEM_LAYERS = {"base", "runstore", "resultfiles", "study", "serve", "app"}

INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"(?P<own>[^"]+)"|<(?P<angle>[^>]+)>)')


def offence_of_own(layer, header):
    """Why a file of `layer` may not include "header", or None."""
    target, slash, _ = header.partition("/")
    if not slash or target not in MAY_INCLUDE:
        return f'"{header}" does not start at a layer; includes are written from src/overbend'
    if target != layer and target not in MAY_INCLUDE[layer]:
        allowed = ", ".join(sorted(MAY_INCLUDE[layer])) or "no other layer"
        return f'{layer} may not include "{header}" (it may see {allowed})'
    return None


def offence_of_library(layer, header):
    """Why a file of `layer` may not include <header>, or None."""
    if SYSTEM_HEADER.match(header):
        return None if layer in SYSTEM_LAYERS else f"{layer} may not include the system header <{header}>"
    if not re.search(r"[./]", header):
        return None  # the standard library
    for prefix, layers in LIBRARIES:
        if header.startswith(prefix):
            if layer in layers:
                return None
            return f"{layer} may not include <{header}> (only {', '.join(sorted(layers))})"
    return f"<{header}> belongs to no library of the plan"


def offences(root):
    """All offences under root/src/overbend as (path, line number, reason), and the number of files read."""
    source = root / "src" / "overbend"
    found, read = [], 0
    for path in sorted(p for p in source.rglob("*") if p.suffix in {".h", ".cpp"}):
        read += 1
        relative = path.relative_to(source)
        layer = relative.parts[0] if len(relative.parts) > 1 else ""
        if layer not in MAY_INCLUDE:
            found.append((path, 1, f"{relative} lies in no layer of the plan"))
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            match = INCLUDE.match(line)
            if not match:
                continue
            own, angle = match["own"], match["angle"]
            reason = offence_of_own(layer, own) if own else offence_of_library(layer, angle)
            if reason:
                found.append((path, number, reason))
    return found, read


def main(arguments):
    root = pathlib.Path(arguments[0]) if arguments else pathlib.Path(__file__).resolve().parent.parent
    found, read = offences(root)
    for path, number, reason in found:
        print(f"{path.relative_to(root)}:{number}: {reason}")
    if not read:
        print(f"{root}: no sources under src/overbend", file=sys.stderr)
        return 2
    print(f"layers: {read} files, {len(found)} offences")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
