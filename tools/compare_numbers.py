#!/usr/bin/env python3
"""Compares two lists of named numbers: tools/compare_numbers.py FIRST SECOND TOLERANCE.

A line is "NAME NUMBER". Numbers of one name may differ by TOLERANCE of the largest of that name.
"""

import math
import pathlib
import sys


def numbers(path):
    by_name = {}
    for line in pathlib.Path(path).read_text(encoding="utf-8").splitlines():
        name, number = line.split()
        by_name.setdefault(name, []).append(float(number))
    return by_name


def main():
    first, second, tolerance = numbers(sys.argv[1]), numbers(sys.argv[2]), float(sys.argv[3])
    if not first or {n: len(v) for n, v in first.items()} != {n: len(v) for n, v in second.items()}:
        sys.exit("compare_numbers.py: the two do not list the same")
    bad = False
    for name in first:
        size = max(map(abs, second[name]))
        apart = max(abs(a - b) for a, b in zip(first[name], second[name]))
        good = math.isfinite(size) and apart <= tolerance * size  # a NaN on either side is not good
        bad |= not good
        print(f"{name:20} {len(first[name]):5} numbers, largest {size:9.3g}, apart {apart:8.1e}{'' if good else '  WRONG'}")
    sys.exit(bad)


main()
