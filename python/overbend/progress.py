"""Progress of runs on the terminal."""

from __future__ import annotations

import sys
import time
from typing import Callable, Optional, TextIO, Union

#: Called with runs done, runs, simulated time and end [s], and the top tension [N] of the run that is behind the others.
Progress = Callable[[int, int, float, float, float], object]

#: Called with the cases of a study that are done, all of them (0: not known), and those without a solution.
CaseProgress = Callable[[int, int, int], object]


class Bar:
    """Writes one line that is written over as the runs go on."""

    def __init__(self, stream: Optional[TextIO] = None):
        self._stream = stream or sys.stderr
        self._begun = time.monotonic()
        self._told = 0.0
        self._width = 0

    def __call__(self, done: int, runs: int, at: float, end: float, tension: float) -> None:
        now = time.monotonic()
        if now - self._told < 0.5 and at < end:
            return
        self._told = now
        line = f"t = {at:.1f} of {end:.1f} s, tension {tension / 1e3:.1f} kN, {now - self._begun:.0f} s"
        if runs > 1:
            line = f"{done} of {runs} runs done, {line}"
        self._write(line)

    def _write(self, line: str) -> None:
        self._stream.write("\r" + line.ljust(self._width))
        self._stream.flush()
        self._width = len(line)

    def end(self) -> None:
        """Leaves the line."""
        if self._width:
            self._stream.write("\n")
            self._stream.flush()


class Cases(Bar):
    """The same of the cases of a study."""

    def __call__(self, done: int, cases: int, failed: int) -> None:  # type: ignore[override]
        now = time.monotonic()
        if now - self._told < 0.5 and done != cases:
            return
        self._told = now
        line = f"{done} of {cases} cases" if cases else f"{done} analyses"
        self._write(line + (f", {failed} without a solution" if failed else "") + f", {now - self._begun:.0f} s")


def follower(progress: Union[bool, Callable[..., object]],
             bar_of: type[Bar] = Bar) -> tuple[Optional[Callable[..., object]], Callable[[], None]]:
    """What is called while a run goes on, and at its end: of True a line on the terminal, of False nothing."""
    if callable(progress):
        return progress, lambda: None
    if progress:
        bar = bar_of()
        return bar, bar.end
    return None, lambda: None
