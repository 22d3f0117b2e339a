"""Bars roller by roller: reactions and separations, row by row of each box."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from . import drawing as draw
from .along import has_supports
from .units import shown, small

_GAP = 0.8  # between boxes, in widths of a row


class Slots:
    """Positions of bars: one slot per row of rollers, a gap between boxes. `of_row` is by the number of the row."""

    def __init__(self, static: Any) -> None:
        names = [str(name) for name in np.asarray(static.supports["name"])]
        self.names = names
        self.box_of_row = np.asarray(static.rows["support"], dtype=int)
        self.of_row = np.empty(len(self.box_of_row))
        self.spans: list[tuple[float, float]] = []
        position = 0.5
        for box in range(len(names)):
            rows = np.flatnonzero(self.box_of_row == box)
            self.of_row[rows] = position + np.arange(len(rows))
            self.spans.append((position - 0.5, position - 0.5 + len(rows)))
            position += len(rows) + _GAP
        self.end = position - 0.5 - _GAP

    def furnish(self, ax: Any) -> None:
        """Grey bands and names of the boxes."""
        for low, high in self.spans:
            ax.axvspan(low, high, color=draw.BOX, linewidth=0, zorder=0)
        ax.set_xlim(-0.2, self.end + 0.2)
        ax.axhline(0.0, color=draw.SOFT, linewidth=0.9, zorder=3)
        draw.names_below(ax, self.names, np.array([0.5 * sum(span) for span in self.spans]))


def roller_rows(static: Any) -> tuple[np.ndarray, np.ndarray]:
    """Returns the row number and the position (bottom, port, starboard) of every roller.

    Raises: ValueError where the lay has no rollers.
    """
    if not has_supports(static):
        raise ValueError("this line hangs from its tensioner: it has no rollers to draw")
    return np.asarray(static.rollers["row"], dtype=int), np.asarray(static.rollers["position"]).astype(str)


def roller_bars(static: Any, what: str, ax: Optional[Any], position: str = "bottom") -> Any:
    """Draws reactions of all rollers, or the separations of those in one position."""
    rows, positions = roller_rows(static)
    if position not in draw.ROLLERS:
        raise ValueError(f"position: found {position!r}, expected one of {', '.join(map(repr, draw.ROLLERS))}")
    slots = Slots(static)
    ax = draw.axes(ax)
    slots.furnish(ax)
    if what == "reaction":
        _reactions(static, ax, slots, rows, positions)
    else:
        _separations(static, ax, slots, rows, positions == position, position)
    return ax


def _reactions(static: Any, ax: Any, slots: Slots, rows: np.ndarray, positions: np.ndarray) -> None:
    unit, factor, digits = shown("reaction", "N")
    values = factor * np.asarray(static.rollers["reaction"])
    below = np.zeros(len(slots.of_row))
    for position, colour in draw.ROLLERS.items():
        these = positions == position
        if not these.any():
            continue
        slot = slots.of_row[rows[these]]
        ax.bar(slot, values[these], 0.72, below[rows[these]], color=colour, label=position, zorder=2)
        np.add.at(below, rows[these], values[these])
    ax.set_ylim(0.0, draw.room(0.0, float(below.max()) or 1.0)[1])
    draw.label(ax, "Normal reactions", "Roller rows of each box, from the tensioner astern", f"Reaction [{unit}]",
               of=static.title)
    most = int(values.argmax())
    if values[most] > 0:
        name = slots.names[slots.box_of_row[rows[most]]]
        draw.mark(ax, slots.of_row[rows[most]], below[rows[most]], f"{values[most]:.{digits}f} {unit} ({name}, {positions[most]})",
                  draw.ROLLERS[positions[most]])


def _separations(static: Any, ax: Any, slots: Slots, rows: np.ndarray, these: np.ndarray, position: str) -> None:
    if not these.any():
        raise ValueError(f"position: found {position!r}, but no box has {position} rollers")
    unit, factor, digits = small()
    values = factor * np.asarray(static.rollers["separation"])[these]
    slot = slots.of_row[rows[these]]
    passed = np.isnan(values) | (np.asarray(static.rollers["off_end"])[these] > 0)
    colour = draw.ROLLERS[position]
    ax.bar(slot[~passed], values[~passed], 0.72, color=colour, zorder=2)
    if passed.any():
        ax.plot(slot[passed], np.zeros(passed.sum()), "x", color=colour, zorder=4,
                label="the pipe has passed the end of the roller")
    ax.set_ylim(*draw.room(*draw.extent(values[~passed]), above=0.12, below=0.12, zero=True))
    least = f"; smallest {np.min(values[~passed]):.{digits + 1}f} {unit}" if not passed.all() else ""
    draw.label(ax, f"{position.capitalize()} rollers{least}", "Roller rows of each box, from the tensioner astern",
               f"Separation [{unit}]", of=static.title)
