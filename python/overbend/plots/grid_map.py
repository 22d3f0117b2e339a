"""Coloured cells over two axes."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from . import drawing as draw
from .study_grid import Axis


def draw_map(ax: Any, x: Axis, y: Axis, values: np.ndarray, label: str, passed: Optional[np.ndarray] = None,
             beyond: Optional[np.ndarray] = None) -> None:
    """Draws cells of shape (y, x) with a colour scale named `label`.

    Args:
        passed: Where checks are passed, shape (y, x): a line runs round these cells.
        beyond: Where the limit lies above the value, shape (y, x); given, values are written into the cells.
    """
    ax.grid(False)
    if not np.isfinite(values).all():  # what lies behind shows in the cells without a value
        ax.patch.set(hatch="////", edgecolor="#b4bec7")
    cells = ax.pcolormesh(x.edges(), y.edges(), np.ma.masked_invalid(values), cmap="viridis", edgecolor="white",
                          linewidth=0.4)
    bar = ax.figure.colorbar(cells, ax=ax, pad=0.02)
    bar.set_label(label, color=draw.SOFT)
    bar.outline.set_visible(False)
    bar.ax.tick_params(colors=draw.SOFT)
    if passed is not None:
        _border(ax, x.edges(), y.edges(), passed & np.isfinite(values))
    if beyond is not None:
        _numbers(ax, x, y, values, cells, beyond)
    for axis, of in ((ax.xaxis, x), (ax.yaxis, y)):
        axis.set_ticks(of.positions[::max(1, -(-len(of.positions) // 12))]) if of.numbers else of.ticks(axis)


def _border(ax: Any, x: np.ndarray, y: np.ndarray, good: np.ndarray) -> None:
    """The line between cells that are good and their neighbours that are not."""
    lines = [[(x[i + 1], y[j]), (x[i + 1], y[j + 1])] for j, i in np.argwhere(good[:, 1:] != good[:, :-1])]
    lines += [[(x[i], y[j + 1]), (x[i + 1], y[j + 1])] for j, i in np.argwhere(good[1:] != good[:-1])]
    if lines:
        from matplotlib.collections import LineCollection

        ax.add_collection(LineCollection(lines, colors="white", linewidths=4.0, capstyle="projecting"))
        ax.add_collection(LineCollection(lines, colors=draw.INK, linewidths=2.0, capstyle="projecting"))


def _numbers(ax: Any, x: Axis, y: Axis, values: np.ndarray, cells: Any, beyond: np.ndarray) -> None:
    for (j, i), value in np.ndenumerate(values):
        dark = np.isfinite(value) and cells.norm(value) < 0.55
        text = ("≥ " if beyond[j, i] else "") + f"{value:g}" if np.isfinite(value) else "none"
        ax.annotate(text, (x.positions[i], y.positions[j]), ha="center", va="center", fontsize="small",
                    color="white" if dark else draw.INK)
