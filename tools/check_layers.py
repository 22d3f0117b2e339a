#!/usr/bin/env python3
"""Checks the layers of src/overbend: prints file:line of every include that the plan does not allow.

    tools/check_layers.py [ROOT]     ROOT is the repository (default: the one this file lies in)

The plan is the tables below; ARCHITECTURE.md explains it. Exit code 0: clean; 1: offences; 2: nothing to check.
"""

import pathlib
import re
import sys

EVERYTHING = {
    "base", "model", "results", "numerics", "mechanics", "hull", "moorings", "system", "statics", "dynamics", "recording", "checks",
    "modelfile", "orcaflex", "platform", "seafiles", "runstore", "resultfiles", "study", "report", "serve", "app", "python", "wasm",
}

# Layer -> the layers that it may include in addition to itself.
PLAIN = {"results", "model", "base"}
ENGINE = {"mechanics", "hull", "moorings", "numerics"} | PLAIN
MAY_INCLUDE = {
    "platform": set(),
    "base": {"platform"},
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
    "seafiles": {"orcaflex", "model", "base"},
    "modelfile": {"seafiles", "checks", "resultfiles", "model", "base"},
    "orcaflex": {"model", "base"},
    "runstore": {"platform"} | PLAIN,
    "resultfiles": {"runstore", "platform"} | PLAIN,
    "study": EVERYTHING - {"app", "serve", "python", "wasm"},
    "report": EVERYTHING - {"app", "serve", "python", "study", "wasm"},
    "serve": EVERYTHING - {"app", "python", "wasm"},
    "python": EVERYTHING - {"app", "serve", "wasm"},
    "app": EVERYTHING - {"python", "wasm"},
    "wasm": EVERYTHING - {"app", "python"},
}

# Layers in sub-rooms, lowest first: a file may include the sub-rooms listed before its own. "" is the room itself, which
# is above all of its sub-rooms.
SUB_ROOMS = {
    "platform": ["", "posix", "windows", "wasm"],
    "model": ["waves", "description", "pipe", "site", "vessel", ""],
    "results": ["", "fields", "tables"],
    "statics": ["initial_shape", "equations", "solver", "stinger", "recovery", "moored"],
    "dynamics": ["machines", "integrator", "setup", "run"],
    "modelfile": ["schema", "fields", "binding", "checks", "yaml", "reading", "study_file"],
    "resultfiles": ["hdf5", "summary", "tables", "moored", "lines", "static", "dynamic", "stages", "studies"],
    "study": ["sampling", "run", "seeds", "sensitivity", "stages", "compare", "goal_seek", "lay_table", "cases", "operability",
              "campaign", "cluster"],
    "report": ["page", "static", "dynamic", "moored", "stages", "studies", ""],
    "serve": ["embedded", "http", "answers", "model", "runs", ""],
}

# Prefix of a library's headers -> the layers that may use it. A library that is not listed may not be used.
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
    ("CLI/", {"app"}),
    ("emscripten.h", {"wasm"}),
]

# Headers of operating systems -> the sub-rooms of `platform` whose sources may include them. Nothing else may.
SYSTEM_HEADERS = [
    (re.compile(r"(sys|netinet|arpa|net|linux)/.+|(unistd|fcntl|poll|spawn|signal|termios|dlfcn|pthread|sched|pwd|grp|netdb|"
                r"dirent|ifaddrs|semaphore|langinfo|glob|wait)\.h|csignal"), {"posix", "wasm"}),
    (re.compile(r"(windows|winsock2?|ws2tcpip|iphlpapi|shellapi|shlobj|io|direct|process)\.h", re.IGNORECASE), {"windows"}),
    (re.compile(r"(fcntl|dirent)\.h"), {"windows"}),
]  # fmt: skip

# Functions of one operating system, or of the system's resources, that headers of the standard library declare. Only
# `platform` may use them, and the path /proc.
SYSTEM_NAME = re.compile(
    r"(?<![\w.])(mkdtemp|mkstemp|localtime_[rs]|gmtime_[rs]|popen|fileno|setenv|renameat2|hardware_concurrency|"
    r'temp_directory_path|tmpnam|tmpfile)\b|"/proc\b'
)

INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"(?P<header>[^"]+)"|<(?P<angle>[^>]+)>)')


def sub_room(path):
    """The sub-room of a file given from src/overbend, "" for a file in the room itself."""
    parts = path.split("/")
    return parts[1] if len(parts) > 2 else ""


def check_location(relative):
    """Reason why a file may not be at its location, or None."""
    room = relative.split("/")[0]
    if "/" not in relative or room not in MAY_INCLUDE:
        return f"{relative} lies in no layer of the plan"
    if sub_room(relative) not in SUB_ROOMS.get(room, [""]):
        return f"{relative} lies in no sub-room of the plan ({', '.join(filter(None, SUB_ROOMS.get(room, [])))})"
    return None


def check_sub_room(relative, header):
    """Reason why a file may not include a header of another sub-room of its room, or None."""
    order = SUB_ROOMS.get(relative.split("/")[0])
    room, target = sub_room(relative), sub_room(header)
    if order is None or target == room:
        return None
    if target not in order:
        return f'"{header}" lies in no sub-room of the plan'
    if order.index(target) > order.index(room):
        return f'{room} may not include "{header}" ({room} stands below {target or "the room itself"})'
    return None


def check_own_header(relative, header):
    """Reason why a file given from src/overbend may not include "header", or None."""
    layer = relative.split("/")[0]
    target, slash, _ = header.partition("/")
    if not slash or target not in MAY_INCLUDE:
        return f'"{header}" does not start at a layer; includes are written from src/overbend'
    if target != layer and target not in MAY_INCLUDE[layer]:
        allowed = ", ".join(sorted(MAY_INCLUDE[layer])) or "no other layer"
        return f'{layer} may not include "{header}" (it may see {allowed})'
    return check_sub_room(relative, header) if target == layer else None


def check_system_header(relative, header):
    """Reason why a file given from src/overbend may not include a header of an operating system, or None."""
    allowed = [rooms for pattern, rooms in SYSTEM_HEADERS if pattern.fullmatch(header)]
    if not allowed or relative.startswith("platform/") and any(sub_room(relative) in rooms for rooms in allowed):
        return None
    return f"<{header}> is a header of an operating system (only platform/{', platform/'.join(sorted(set.union(*allowed)))})"


def check_system_name(layer, line):
    """Reason why a line of a file of `layer` may not stand there, or None."""
    match = SYSTEM_NAME.search(line.split("//")[0])
    if layer == "platform" or not match:
        return None
    return f"{match[0].strip(chr(34))} depends on the operating system (only platform)"


def check_library(layer, header):
    """Reason why a file of `layer` may not include <header>, or None."""
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
        relative = path.relative_to(source).as_posix()
        layer = relative.split("/")[0]
        misplaced = check_location(relative)
        if misplaced:
            found.append((path, 1, misplaced))
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            match = INCLUDE.match(line)
            if not match:
                reason = check_system_name(layer, line)
            elif match["header"]:
                reason = check_own_header(relative, match["header"])
            elif any(pattern.fullmatch(match["angle"]) for pattern, _ in SYSTEM_HEADERS):
                reason = check_system_header(relative, match["angle"])
            else:
                reason = check_library(layer, match["angle"])
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
