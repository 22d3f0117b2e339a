#!/usr/bin/env python3
"""Times whole runs of the program, from start to written report: bench/whole_run.py MODEL.yaml [RUNS]."""

import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

PROGRAM = Path(__file__).resolve().parent.parent / "build/release/overbend"


def seconds_of_a_run(model: str) -> float:
    with tempfile.TemporaryDirectory() as folder:
        begin = time.perf_counter()
        subprocess.run([PROGRAM, "static", model, "-o", f"{folder}/out"], check=True, stdout=subprocess.DEVNULL)
        return time.perf_counter() - begin


def main() -> None:
    model = sys.argv[1]
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 20
    times = [1e3 * seconds_of_a_run(model) for _ in range(runs)]
    print(f"{model}: {runs} runs, least {min(times):.0f} ms, median {statistics.median(times):.0f} ms")


if __name__ == "__main__":
    main()
