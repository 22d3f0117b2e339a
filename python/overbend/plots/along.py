"""Figures along the pipe: distance from the tensioner, roller boxes behind, touchdown, yield stress."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import drawing as draw


class AlongPipe:
    """The axes of a figure along the pipe of a lay, and the background of its curves."""

    def __init__(self, static: Any, ax: Any, part: str) -> None:
        self.static = static
        self.overbend = draw.is_overbend(part)
        self.top = float(static.total_length)
        self.touchdown = self.top - float(static.touchdown.s)
        self.boxes = _boxes(static)
        self.end = self.find_end(static, self.overbend)
        self.lane = draw.lane_for([name for name, _, _ in self.boxes]) if self.overbend else 0.0
        self.ax = draw.axes(ax)
        self.ax.set_xlim(0.0, self.end)

    @staticmethod
    def find_end(static: Any, overbend: bool) -> float:
        """Range of a figure from the tensioner [m]: just beyond the last box, or beyond touchdown."""
        top, boxes = float(static.total_length), _boxes(static)
        if not overbend:
            touchdown = top - float(static.touchdown.s)
            return min(top, max(touchdown + max(30.0, 0.15 * touchdown), top - _last_span(static) + 20.0))
        if not boxes:
            raise ValueError("part: found 'overbend', but this line hangs from its tensioner without supports")
        last = max(middle + 0.5 * length for _, middle, length in boxes)
        return min(top, last + max(5.0, 0.12 * last))

    def from_tensioner(self, s: Any) -> np.ndarray:
        """Distances from the tensioner [m] of arc lengths `s` from the anchor [m]."""
        return self.top - np.asarray(s, dtype=float)

    def inside(self, s: Any) -> np.ndarray:
        """Mask of the stations at `s` [m] that the figure shows."""
        distance = self.from_tensioner(s)
        return (distance >= -1e-9) & (distance <= self.end + 1e-9)

    def finish(self, title: str, y_label: str, limits: tuple[float, float]) -> Any:
        """Sets limits, labels, boxes and legend, once all curves are drawn. Returns the axes."""
        self.ax.set_ylim(*limits)
        for _, middle, length in self.boxes:
            self.ax.axvspan(middle - 0.5 * length, middle + 0.5 * length, color=draw.BOX, linewidth=0, zorder=0)
        if limits[0] < 0 < limits[1]:
            self.ax.axhline(0.0, color=draw.STEEL, linewidth=0.8, zorder=1)
        if self.overbend:
            draw.names_above(self.ax, [name for name, _, _ in self.boxes], np.array([middle for _, middle, _ in self.boxes]))
        else:
            draw.upright(self.ax, self.touchdown, "touchdown")
        where = "overbend" if self.overbend else "whole line"
        draw.label(self.ax, f"{title}, {where}", draw.FROM_TENSIONER, y_label, self.lane, of=self.static.title)
        return self.ax

    def place(self, distance: float) -> str:
        """Name of the box over which a `distance` from the tensioner [m] lies, or the region."""
        for name, middle, length in self.boxes:
            if abs(distance - middle) <= 0.5 * length + 0.5:
                return name
        return "tensioner" if distance < 0.5 else ""

    def mark_at(self, distance: float, value: float, digits: int, unit: str, more: str = "", colour: str = draw.PIPE) -> None:
        """Marks a value at a distance from the tensioner [m] with number, distance and box."""
        place = self.place(distance)
        text = f"{value:.{digits}f} {unit}".rstrip() + f" at {draw.length(distance)}" + (f" ({place})" if place else "") + more
        draw.mark(self.ax, distance, value, text, colour)


def has_supports(static: Any) -> bool:
    """Returns True if the pipe passes over roller boxes, False in a J-lay."""
    return len(static.supports) > 0


def _last_span(static: Any) -> float:
    """Arc length [m] at the far end of the last free span that can be seen; that of the tensioner without one."""
    spans = static.free_spans
    if not len(spans):
        return float(static.total_length)
    seen = np.asarray(spans["largest_gap"]) > 0.05
    ends = np.minimum(np.asarray(spans["s_from"]), np.asarray(spans["s_to"]))[seen]
    return float(ends.min()) if ends.size else float(static.total_length)


def _boxes(static: Any) -> list[tuple[str, float, float]]:
    """Name, distance from the tensioner [m] and length [m] of the roller boxes; none in a J-lay."""
    if not has_supports(static):
        return []
    top, supports = float(static.total_length), static.supports
    columns = (np.asarray(supports[key]) for key in ("name", "s", "length"))
    return [(str(name), top - float(s), float(length)) for name, s, length in zip(*columns)]


def yield_stress(static: Any) -> float:
    """Returns the minimum yield stress along the pipe [Pa], 0 if none is given."""
    values = np.asarray(static.pipe["yield_stress"], dtype=float)
    values = values[values > 0]
    return float(values.min()) if values.size else 0.0
