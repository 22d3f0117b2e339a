"""Figures of a static analysis."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from . import drawing as draw
from .along import AlongPipe, yield_stress
from .elevation import elevation
from .rollers import roller_bars
from .units import display_name, shown, with_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Further curves in the figure of a quantity: column, name, colour, dashes.
_FURTHER_CURVES = {
    "effective_tension": [("wall_tension", "wall tension", draw.SECOND, (0, (6, 4)))],
    "bending_moment": [
        ("vertical_moment", "vertical, sagging +", draw.THIRD, (0, (9, 3))),
        ("lateral_moment", "lateral, to port +", draw.SECOND, (0, (5, 3))),
    ],
}
_OWN_NAME = {"effective_tension": "effective tension", "bending_moment": "magnitude"}


class StaticPlots:
    """Figures of a static analysis: `static.plot.tension()`. All return matplotlib Axes.

    Without `ax` each makes a figure of its own. Values are in the units of the reports (kN, kN m, MPa, m), distances
    along the pipe are counted from the tensioner. `part` is 'whole' for the line from the tensioner to a little beyond
    touchdown, or 'overbend' for tensioner to stinger tip.
    """

    def __init__(self, static: Any) -> None:
        self._static = static

    def _require_pipe(self) -> None:
        if len(self._static.pipe) == 0:
            raise ValueError("the model has no pipe to draw")

    def profile(self, ax: Optional[Axes] = None, *, part: str = "whole") -> Axes:
        """Draws the elevation of pipe, vessel and seabed: heights above the water over the distance astern of the shoe.

        The whole line is true to scale; the overbend has its heights enlarged and shows which roller rows carry.
        """
        self._require_pipe()
        return elevation(self._static, ax, draw.is_overbend(part))

    def tension(self, ax: Optional[Axes] = None, *, part: str = "whole") -> Axes:
        """Draws effective and true wall tension along the pipe [kN]."""
        return self.along("effective_tension", ax, part=part)

    def moment(self, ax: Optional[Axes] = None, *, part: str = "whole") -> Axes:
        """Draws the bending moment along the pipe [kN m]: magnitude, and parts in and out of the vertical plane."""
        return self.along("bending_moment", ax, part=part)

    def stress(self, ax: Optional[Axes] = None, *, part: str = "whole") -> Axes:
        """Draws the largest von Mises stress of each section along the pipe [MPa], with the yield stress."""
        return self.along("von_mises", ax, part=part)

    def strain(self, ax: Optional[Axes] = None, *, part: str = "whole") -> Axes:
        """Draws the largest longitudinal strain of each section along the pipe [%]."""
        return self.along("strain", ax, part=part)

    def along(self, name: str, ax: Optional[Axes] = None, *, part: str = "whole") -> Axes:
        """Draws any column of `static.pipe` along the pipe.

        Args:
            name: the column, such as 'bending_stress', 'curvature' or 'inclination'.
        Raises: KeyError for an unknown column.
        """
        self._require_pipe()
        column = self._static.pipe[name]
        unit, factor, digits = shown(name, column.attrs["units"])
        figure = AlongPipe(self._static, ax, part)
        s = np.asarray(self._static.pipe["s"])
        seen = figure.inside(s)
        distance, values = figure.from_tensioner(s)[seen], factor * np.asarray(column)[seen]
        drawn = [values]
        figure.ax.plot(distance, values, color=draw.PIPE, linewidth=1.9, label=_OWN_NAME.get(name), zorder=3)
        for key, label, colour, dashes in _FURTHER_CURVES.get(name, []):
            curve = factor * np.asarray(self._static.pipe[key])[seen]
            if np.abs(curve).max() > 1e-3 * np.abs(values).max():  # out of the plane there may be nothing
                drawn.append(curve)
                figure.ax.plot(distance, curve, color=colour, linestyle=dashes, linewidth=1.3, label=label)
        limits = _with_yield(figure, name, draw.room(*draw.extent(*drawn), zero=True), drawn)
        title = display_name(name)
        axes = figure.finish(title, with_unit(title, unit), limits)
        self._marks(figure, name, distance, values, digits, unit)
        return axes

    def reactions(self, ax: Optional[Axes] = None) -> Axes:
        """Draws the normal reaction of every roller [kN], row by row of each box."""
        return roller_bars(self._static, "reaction", ax)

    def separation(self, ax: Optional[Axes] = None, *, position: str = "bottom") -> Axes:
        """Draws the clear distance between pipe and rollers [mm], row by row of each box; negative is penetration.

        Args:
            position: of the rollers: 'bottom', 'port' or 'starboard'. A cross marks a roller that the pipe has passed
                over the end of.
        """
        return roller_bars(self._static, "separation", ax, position)

    def _marks(self, figure: AlongPipe, name: str, distance: np.ndarray, values: np.ndarray, digits: int, unit: str) -> None:
        """Maxima of the regions that the figure shows."""
        if name == "effective_tension":
            figure.mark_at(float(distance[values.argmax()]), float(values.max()), digits, unit)
            if not figure.overbend:
                bottom = float(np.interp(figure.touchdown, distance[::-1], values[::-1]))  # stations run from the anchor
                draw.mark(figure.ax, figure.touchdown, bottom, f"{bottom:.{digits}f} {unit} at touchdown", below=True)
            return
        if name not in ("bending_moment", "bending_stress", "von_mises", "strain"):
            return
        factor = shown(name, self._static.pipe[name].attrs["units"]).factor
        for region in ("overbend", "tower", "sagbend"):
            of = getattr(self._static, region, None)
            if of is None:
                continue
            peak = factor * float(of[f"max_{name}"])
            where = figure.top - float(of["at" if name == "bending_moment" else f"at_{name}"]["s"])
            if where <= figure.end:
                figure.mark_at(where, peak, digits, unit)


def _with_yield(figure: AlongPipe, name: str, limits: tuple[float, float],
                drawn: list[np.ndarray]) -> tuple[float, float]:
    """Adds the yield stress to a stress figure whose values come near it. Returns the limits."""
    least = 1e-6 * yield_stress(figure.static) if name in ("von_mises", "bending_stress", "axial_stress") else 0.0
    if least <= 0 or draw.extent(*drawn)[1] < 0.5 * least:
        return limits
    draw.level(figure.ax, least, f"yield {least:.0f} MPa")
    return limits[0], max(limits[1], 1.12 * least)
