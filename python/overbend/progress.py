"""Progress display on the terminal."""

from __future__ import annotations

import sys
import time
from typing import Callable, Optional, TextIO, Union

#: Called with runs done, number of runs, simulated time, end time [s] and top tension [N] of the slowest run.
Progress = Callable[[int, int, float, float, float], object]

#: Called with cases done, number of cases (0: unknown) and cases without a solution.
CaseProgress = Callable[[int, int, int], object]


class Bar:
    """Writes and updates one line."""

    def __init__(self, stream: Optional[TextIO] = None):
        self._stream = stream or sys.stderr
        self._begun = time.monotonic()
        self._last_write = 0.0
        self._width = 0

    def __call__(self, done: int, runs: int, reached: float, end: float, tension: float) -> None:
        current = time.monotonic()
        if current - self._last_write < 0.5 and reached < end:
            return
        self._last_write = current
        line = f"t = {reached:.1f} of {end:.1f} s, tension {tension / 1e3:.1f} kN, {current - self._begun:.0f} s"
        if runs > 1:
            line = f"{done} of {runs} runs done, {line}"
        self._write(line)

    def _write(self, line: str) -> None:
        self._stream.write("\r" + line.ljust(self._width))
        self._stream.flush()
        self._width = len(line)

    def end(self) -> None:
        """Ends the line."""
        if self._width:
            self._stream.write("\n")
            self._stream.flush()


class Cases(Bar):
    """Progress of the cases of a study."""

    def __call__(self, done: int, cases: int, failed: int) -> None:  # type: ignore[override]
        current = time.monotonic()
        if current - self._last_write < 0.5 and done != cases:
            return
        self._last_write = current
        line = f"{done} of {cases} cases" if cases else f"{done} analyses"
        self._write(line + (f", {failed} without a solution" if failed else "") + f", {current - self._begun:.0f} s")


def follower(progress: Union[bool, Callable[..., object]],
             bar_type: type[Bar] = Bar) -> tuple[Optional[Callable[..., object]], Callable[[], None]]:
    """Callbacks during and at the end of a run; True gives a line on the terminal, False nothing."""
    if callable(progress):
        return progress, lambda: None
    if progress:
        bar = bar_type()
        return bar, bar.end
    return None, lambda: None
