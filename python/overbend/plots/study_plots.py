"""Figures of a study: curves and maps over its axes, scatter of a sample, operability limits."""

from __future__ import annotations

from itertools import cycle
from typing import TYPE_CHECKING, Any, Mapping, Optional

import numpy as np

from . import drawing as draw
from .grid_map import draw_map
from .study_grid import Axis, Grid
from .units import shown, with_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_COLOURS = [draw.PIPE, draw.SECOND, draw.THIRD, draw.DYNAMIC, draw.PORT, draw.STEEL]


class StudyPlots:
    """Figures of a study: `study.plot.curve('tensioner.tension', 'static.lay_back')`. All return matplotlib Axes.

    Without `ax` each makes a figure of its own. Keys and results have the names of `study.inputs` and `study.outputs`;
    values are in the units of the reports. A hollow dot is a case in which a governing code check is exceeded.
    """

    def __init__(self, study: Any) -> None:
        self._study = study

    def curve(self, x: str, y: str, ax: Optional[Axes] = None, *, by: Optional[str] = None,
              at: Optional[Mapping[str, Any]] = None) -> Axes:
        """Draws a result over one axis of the study; for several seeds the mean, and a band from minimum to maximum.

        Args:
            x: key of the axis.
            y: the result, or another column of numbers.
            by: key of an axis whose every value gets a curve of its own; the second axis where there is one.
            at: values of further axes [SI], or their names; the nearest ones are taken.
        Raises: KeyError for an unknown axis or result, ValueError where further axes have to be chosen from.
        """
        grid = Grid(self._study, y)
        across = grid.axis(x)
        by = by or grid.other_than([x], at)
        curves = grid.take([x] if by is None else [by, x], at)
        passed = grid.passed([x] if by is None else [by, x], at)
        groups = [""] if by is None else grid.axis(by).labels
        ax = draw.axes(ax, (7.2, 3.8))
        for k, (label, colour) in enumerate(zip(groups, cycle(_COLOURS))):
            values, good = (curves, passed) if by is None else (curves[k], passed[k])
            mean = grid.over_seeds(values, np.nanmean)
            if values.shape[-1] > 1:
                least, most = (grid.over_seeds(values, rule) for rule in (np.nanmin, np.nanmax))
                ax.fill_between(across.positions, least, most, color=colour, alpha=0.18, linewidth=0)
            ax.plot(across.positions, mean, color=colour, linewidth=1.6, label=label or None)
            for these, fill in ((good, colour), (~good, "white")):
                ax.plot(across.positions[these], mean[these], "o", color=colour, markerfacecolor=fill, markersize=4.5)
        if (~passed & np.isfinite(curves).any(axis=-1)).any():
            ax.plot([], [], "o", color=draw.INK, markerfacecolor="white", markersize=4.5, label="check exceeded")
        across.ticks(ax.xaxis)
        title = f"{grid.result} over {across.key}" + ("" if by is None else f", by {by}")
        draw.label(ax, title, across.label, with_unit(y, grid.unit), of=self._study.title)
        return ax

    def map(self, result: str, ax: Optional[Axes] = None, *, x: Optional[str] = None, y: Optional[str] = None,
            at: Optional[Mapping[str, Any]] = None) -> Axes:
        """Draws a result over two axes of the study as coloured cells; the mean of several seeds.

        Cells without a result are hatched. A line runs between cells that pass all governing checks and those that do
        not.

        Args:
            result: the result, or another column of numbers.
            x, y: keys of the two axes; left out the first two that have several values.
            at: values of further axes [SI], or their names; the nearest ones are taken.
        Raises: KeyError, ValueError as of curve().
        """
        grid = Grid(self._study, result)
        x = x or grid.other_than([y] if y else [], at, first=True)
        y = y or grid.other_than([x] if x else [], at, first=True)
        if x is None or y is None:
            raise ValueError(f"map: found one axis with several values, expected two; plot.curve({x!r}, {result!r})")
        values = grid.over_seeds(grid.take([y, x], at), np.nanmean)
        ax = draw.axes(ax, (7.2, 4.2))
        draw_map(ax, grid.axis(x), grid.axis(y), values, with_unit(result, grid.unit), passed=grid.passed([y, x], at))
        draw.label(ax, grid.result, grid.axis(x).label, grid.axis(y).label, of=self._study.title)
        return ax

    def scatter(self, x: str, y: str, ax: Optional[Axes] = None) -> Axes:
        """Draws a result over a key, one dot per case: for keys sampled at random."""
        table = self._study.table
        columns = [table[name] for name in (x, y)]
        units = [shown(name, column.attrs["units"]) for name, column in zip((x, y), columns)]
        across, up = (unit.factor * np.asarray(column, dtype=float) for unit, column in zip(units, columns))
        good = np.asarray(table["passed"], dtype=bool)
        ax = draw.axes(ax, (6.4, 3.8))
        for these, fill, label in ((good, draw.PIPE, "checks passed"), (~good, "white", "check exceeded")):
            if np.isfinite(up[these]).any():
                edge = draw.PIPE if these is good else draw.ACCENT
                ax.plot(across[these], up[these], "o", color=edge, markerfacecolor=fill, markersize=4, label=label)
        draw.label(ax, f"{y} over {x}", with_unit(x, units[0].unit), with_unit(y, units[1].unit), of=self._study.title)
        return ax

    def operability(self, ax: Optional[Axes] = None) -> Axes:
        """Draws the operability limits over the axes of the chart: a curve over one, cells with numbers over two.

        A number after ≥ is the largest that was tried: the limit lies above it.

        Raises: ValueError where the study has not looked for limits, or over more than two axes.
        """
        found = self._study.operability
        if found is None:
            raise ValueError("operability: this study has not looked for limits; give it `operability`")
        limit = found.limit
        unit, factor, _ = shown(found.over, limit.attrs["units"])
        keys = [key for key in limit.dims if len(limit.coords[key]) > 1 or len(limit.dims) == 1]
        axes = [Axis(str(key), limit.coords[key]) for key in keys]
        values = factor * np.asarray(limit).reshape([len(axis.positions) for axis in axes])
        label = with_unit(f"Largest {found.over}", unit)
        if len(axes) == 1:
            ax = draw.axes(ax, (7.2, 3.4))
            ax.plot(axes[0].positions, values, "o-", color=draw.PIPE, linewidth=1.6, markersize=4.5)
            ax.set_ylim(0.0, draw.room(*draw.extent(values), zero=True)[1])
            axes[0].ticks(ax.xaxis)
            draw.label(ax, "Limits of operation", axes[0].label, label, of=self._study.title)
            return ax
        if len(axes) != 2:
            raise ValueError(f"operability: found {len(axes)} axes with several values, expected one or two")
        ax = draw.axes(ax, (7.2, 4.2))
        beyond = np.asarray(found.beyond, dtype=bool).reshape(values.shape)
        draw_map(ax, axes[1], axes[0], values, label, beyond=beyond)
        draw.label(ax, "Limits of operation", axes[1].label, axes[0].label, of=self._study.title)
        return ax
