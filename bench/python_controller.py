#!/usr/bin/python3
"""Cost of a Python controller in a storm: bench/python_controller.py [SECONDS [PAIRS]].

BGL-1 in its storm with and without a controller that is asked every 0.1 s and answers nothing, in turn, so that other load
on the computer affects both alike. Prints processor times, steps, the ratio of the medians, and the time of the function
itself.
"""

import pathlib
import statistics
import sys
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "build/release/python"))
import overbend as ob  # noqa: E402


class Law:
    """Answers nothing, after it looked at what a controller looks at; counts and times its calls."""

    def __init__(self) -> None:
        self.calls, self.spent = 0, 0.0

    def __call__(self, t: float, seen: "ob.controllers.MachineReading") -> None:
        begun = time.perf_counter()
        self.calls += 1
        error = seen.tension - seen.set_tension
        if error + seen.speed + seen.paid_out > 1e12:
            raise ValueError("not in this storm")
        self.spent += time.perf_counter() - begun


def storm(model: "ob.Model", seconds: float, law: "Law | None") -> "tuple[float, int]":
    sim = model.simulation(duration=seconds, controllers={"tensioner": law} if law else None)
    begun = time.process_time()
    sim.advance(seconds)
    return time.process_time() - begun, sim.steps


def main() -> None:
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 120.0
    pairs = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    model = ob.Model.read(pathlib.Path(__file__).resolve().parent.parent / "examples/bgl1.yaml")
    alone, driven, law = [], [], Law()
    for pair in range(pairs):
        alone.append(storm(model, seconds, None))
        driven.append(storm(model, seconds, law))
        print(f"pair {pair + 1}: {alone[-1][0]:.2f} s with {alone[-1][1]} steps alone, {driven[-1][0]:.2f} s with "
              f"{driven[-1][1]} steps with a controller", flush=True)
    before, after = (statistics.median(time for time, _ in runs) for runs in (alone, driven))
    calls = law.calls / pairs
    print(f"{seconds:g} s of storm: {before:.2f} s alone, {after:.2f} s with a controller: ratio {after / before:.3f}; "
          f"within the function {1e6 * law.spent / law.calls:.1f} us a call, {calls:.0f} calls: "
          f"{100 * law.spent / pairs / before:.2f} % of the storm")


if __name__ == "__main__":
    main()
