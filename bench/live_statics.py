#!/usr/bin/env python3
"""Measures live statics as the page asks for them: bench/live_statics.py [MODEL.yaml] [SECONDS] [PROGRAM].

Starts `overbend serve` on the model and sends one request after another over one connection, each a value a little
further on, back and forth: first the tension, by 1 kN a step over 100 kN, then the height of the box in the middle, by
1 cm a step over 20 cm, then all boxes after each other, likewise. Prints responses per second, the median time from
request to response and, of it, what the program spent solving.
"""

import http.client
import itertools
import json
import os
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HOME = Path(__file__).resolve().parent.parent


class Page:
    """One connection to the program that serves a folder with the model."""

    def __init__(self, program: str, model: Path, folder: str):
        shutil.copy(model, folder)
        for data in model.parent.glob("*.csv"):
            shutil.copy(data, folder)
        command = [program, "serve", model.name, "--no-browser"]
        self.program = subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, text=True)
        address = re.search(r"http://127\.0\.0\.1:(\d+)/\?token=(\w+)", self.program.stdout.readline())
        self.connection = http.client.HTTPConnection("127.0.0.1", int(address[1]))
        self.headers = {"X-Overbend-Token": address[2], "Content-Type": "application/json"}

    def ask(self, method: str, path: str, body: object = None) -> dict:
        self.connection.request(method, path, json.dumps(body) if body is not None else None, self.headers)
        return json.loads(self.connection.getresponse().read())

    def statics(self, path: str, value: str) -> dict:
        request = {"changes": [{"path": path, "value": value}], "lists": ["bending_stress"]}
        return self.ask("POST", "/api/static", request)

    def close(self) -> None:
        self.program.terminate()
        self.program.wait()


def back_and_forth(first: float, step: float, steps: int) -> itertools.cycle:
    up = [first + step * i for i in range(steps)]
    return itertools.cycle(up + up[::-1])


def measure(page: Page, name: str, changes: "itertools.cycle[tuple[str, str]]", seconds: float) -> None:
    page.statics(*next(changes))
    times, solving, failed = [], [], 0
    end = time.perf_counter() + seconds
    while time.perf_counter() < end:
        path, value = next(changes)
        begin = time.perf_counter()
        answer = page.statics(path, value)
        times.append(1e3 * (time.perf_counter() - begin))
        failed += answer["status"] != "converged"
        solving.append(answer.get("solve_ms", 0.0))
    print(f"{name}: {len(times) / seconds:.0f} responses a second, median {statistics.median(times):.1f} ms, "
          f"90 % {sorted(times)[int(0.9 * len(times))]:.1f} ms, longest {max(times):.1f} ms, "
          f"of which solving {statistics.median(solving):.1f} ms; {failed} not solved")


def box_heights(page: Page) -> "dict[str, float]":
    fields = page.ask("GET", "/api/model")["fields"]
    return {f["path"]: f["si"] for f in fields
            if re.fullmatch(r"supports\.\w+\.boxes\[\d+\]\.z", f["path"]) and f["si"] is not None}


def dragged(path: str, heights: "dict[str, float]") -> "itertools.cycle[tuple[str, str]]":
    return ((path, f"{z:.4f} m") for z in back_and_forth(heights[path] - 0.1, 0.01, 21))


def main() -> None:
    model = Path(sys.argv[1] if len(sys.argv) > 1 else HOME / "examples/bgl1.yaml").resolve()
    seconds = float(sys.argv[2]) if len(sys.argv) > 2 else 4.0
    program = os.path.abspath(sys.argv[3] if len(sys.argv) > 3 else HOME / "build/release/overbend")
    with tempfile.TemporaryDirectory() as folder:
        page = Page(program, model, folder)
        try:
            tensions = ((f"tensioner.tension", f"{t:g} kN") for t in back_and_forth(250.0, 1.0, 101))
            measure(page, "tension", tensions, seconds)
            heights = box_heights(page)
            paths = list(heights)
            middle = paths[len(paths) // 2]
            measure(page, f"height of a box ({middle})", dragged(middle, heights), seconds)
            each = [dragged(path, heights) for path in paths]
            turns = itertools.chain.from_iterable(itertools.islice(turn, 42) for turn in itertools.cycle(each))
            measure(page, f"heights of {len(paths)} boxes, one after the other", turns, seconds)
        finally:
            page.close()


if __name__ == "__main__":
    main()
