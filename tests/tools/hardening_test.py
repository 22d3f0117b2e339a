#!/usr/bin/env python3
"""The program that users run is built so that a slip of memory ends it instead of being made use of.

hardening_test.py PROGRAM
"""
import subprocess
import sys


def listed(*arguments):
    return subprocess.run(["readelf", "--wide", *arguments, sys.argv[1]], check=True, capture_output=True, encoding="utf-8").stdout


def main():
    dynamic, segments, symbols = listed("--dynamic"), listed("--segments"), listed("--dyn-syms")
    claims = {
        "its place in memory is random (PIE)": "PIE" in dynamic,
        "its table of functions is read-only from the start (RELRO, NOW)": "GNU_RELRO" in segments and " NOW" in dynamic,
        "its stack is watched (stack protector)": "__stack_chk_fail" in symbols,
        "its calls of the C library are checked (FORTIFY)": "_chk@GLIBC" in symbols.replace("__stack_chk_fail@", ""),
        "its stack cannot be run": "RWE" not in segments,
    }
    broken = [claim for claim, holds in claims.items() if not holds]
    for claim in broken:
        print(f"not so: {claim}")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
