#!/usr/bin/env python3
"""How long a hundred lays of BGL-1 take from Python: from nothing, each from the one before, and on two threads.

    PYTHONPATH=build/release/python bench/python_warm.py
"""

import pathlib
import time
from concurrent.futures import ThreadPoolExecutor

import overbend as ob

MODEL = ob.Model.read(pathlib.Path(__file__).resolve().parents[1] / "examples" / "bgl1.yaml")
TENSIONS = range(230, 330)


def lay_at(tension, start=None):
    """The lay at a tension [kN], and its lay-back [m]."""
    lay = MODEL.with_({"tensioner.tension": f"{tension} kN"}).static(start=start)
    return lay, float(lay.lay_back)


def chain(tensions):
    """Each from the one before."""
    lay, found = None, []
    for tension in tensions:
        lay, lay_back = lay_at(tension, lay)
        found.append(lay_back)
    return found


def timed(what, work):
    begun = time.perf_counter()
    found = work()
    print(f"{what:<40}{1e3 * (time.perf_counter() - begun):8.0f} ms")
    return found


def main():
    lay_at(TENSIONS[0])
    alone = timed("from nothing", lambda: [lay_at(tension)[1] for tension in TENSIONS])
    warm = timed("each from the one before", lambda: chain(TENSIONS))
    halves = [TENSIONS[:50], TENSIONS[50:]]
    with ThreadPoolExecutor(2) as pool:
        side_by_side = timed("the same in two halves on two threads", lambda: sum(pool.map(chain, halves), []))
    print(f"largest difference of the lay-back {max(abs(a - b) for a, b in zip(alone, warm)):.4f} m, "
          f"of the halves {max(abs(a - b) for a, b in zip(alone, side_by_side)):.4f} m")


if __name__ == "__main__":
    main()
