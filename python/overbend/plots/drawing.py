"""Common parts of all figures: colours, axes, bands of the roller boxes, marks."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from .units import shown

if TYPE_CHECKING:
    from matplotlib.axes import Axes

INK, SOFT, LINE, BOX = "#1b2733", "#5b6b7a", "#d5dce3", "#e8edf1"
PIPE, SECOND, THIRD, ACCENT = "#0b5394", "#c77700", "#009e73", "#b3261e"
DYNAMIC, BAND, PORT = "#6a3d9a", "#d9cce6", "#d55e00"
STEEL, WATER, BED, CONTACT = "#7b8794", "#eaf3f9", "#e4dac6", "#e08a3c"
ROLLERS = {"bottom": PIPE, "port": PORT, "starboard": THIRD}

FROM_TENSIONER = "Distance along the pipe from the tensioner [m]"
_SLANT = 50.0  # [deg] of names above or below a figure


def axes(ax: Optional[Axes], size: tuple[float, float] = (9.6, 3.4)) -> Axes:
    """Returns `ax`, or the axes of a new figure of `size` [in], dressed in the style of the reports.

    Raises: ImportError where matplotlib is not installed.
    """
    if ax is None:
        try:
            from matplotlib import pyplot
        except ImportError:
            raise ImportError(
                "figures are drawn by matplotlib, which is not installed: apt install python3-matplotlib, or "
                "pip install matplotlib"
            ) from None
        ax = pyplot.subplots(figsize=size, layout="constrained")[1]
    ax.grid(True, color=LINE, linewidth=0.7)
    ax.set_axisbelow(True)
    for side in ("top", "right"):
        ax.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        ax.spines[side].set_color(STEEL)
    ax.tick_params(colors=SOFT)
    return ax


def axes_size(ax: Axes) -> tuple[float, float]:
    """Returns about how wide and high the axes are [in], before the layout makes room for labels."""
    box = ax.get_position()
    more = 1.15 if ax.figure.get_layout_engine() is not None else 1.0  # layouts use the margins of the figure
    width, height = more * ax.figure.get_size_inches()
    return float(box.width * width), float(box.height * height)


def label(ax: Axes, title: str, x: str, y: str, lane: float = 0.0, of: str = "") -> None:
    """Sets title and labels, and a legend of all that was drawn with a label, above the plot.

    Args:
        of: title of the model, above that of the figure; shortened where the axes are narrow.
        lane: kept free between plot and title [pt].
    """
    ax.set_xlabel(_in_units(ax.xaxis, x), color=SOFT)
    ax.set_ylabel(_in_units(ax.yaxis, y), color=SOFT)
    rows = _legend(ax, title, lane)
    room = max(20, int(72 * axes_size(ax)[0] / 6.5))
    lines = [textwrap.shorten(of, room, placeholder=" ...")] if of else []
    ax.set_title("\n".join([*lines, title]), loc="left", fontsize="medium", fontweight="bold", color=INK, pad=6 + lane + 14 * rows)


def _in_units(axis: Any, text: str) -> str:
    """Counts an axis of metres, "[m]" in its label, in the unit in which lengths are shown. Returns its label."""
    unit = shown("", "m")
    if not text.endswith("[m]") or unit.factor == 1.0:
        return text
    from matplotlib.ticker import FuncFormatter, MaxNLocator

    class Locator(MaxNLocator):  # type: ignore[misc]  # round numbers of that unit
        def tick_values(self, vmin: float, vmax: float) -> Any:
            return np.asarray(super().tick_values(unit.factor * vmin, unit.factor * vmax)) / unit.factor

    axis.set_major_locator(Locator(nbins=8, steps=[1, 2, 2.5, 5, 10]))
    axis.set_major_formatter(FuncFormatter(lambda metres, _: f"{round(metres * unit.factor, 6):g}"))
    return f"{text[:-3]}[{unit.unit}]"


def length(metres: float) -> str:
    """Returns a length [m] as text in the unit in which lengths are shown: "84.2 m"."""
    unit = shown("", "m")
    return f"{metres * unit.factor:.1f} {unit.unit}"


def _legend(ax: Axes, title: str, lane: float) -> int:
    """A legend next to the title, or in rows below it if the plot is narrow. Returns the number of rows."""
    from matplotlib.transforms import ScaledTranslation

    handles, names = ax.get_legend_handles_labels()
    if not handles:
        return 0
    wide, widest = 72 * axes_size(ax)[0], 34 + 4.9 * max(map(len, names))
    fits = 6.5 * len(title) + sum(34 + 4.9 * len(name) for name in names) < wide
    columns = len(names) if fits else min(len(names), max(1, int(wide / widest)))
    above = ax.transAxes + ScaledTranslation(0, (lane + 2) / 72, ax.figure.dpi_scale_trans)
    ax.legend(handles, names, loc="lower right" if fits else "lower left", bbox_to_anchor=(float(fits), 1.0),
              bbox_transform=above, frameon=False, ncol=columns, borderaxespad=0, borderpad=0.1, fontsize="small",
              handlelength=1.8, columnspacing=1.4, labelspacing=0.25)
    return 0 if fits else -(-len(names) // columns)


def halo() -> list[Any]:
    """A white edge that keeps a text readable on lines."""
    from matplotlib import patheffects

    return [patheffects.withStroke(linewidth=2.5, foreground="white")]


def mark(ax: Axes, x: float, y: float, text: str, colour: str = PIPE, below: bool = False) -> None:
    """A dot with a text above or below, towards the middle of the plot. The limits of `ax` must be set."""
    left, right = ax.get_xlim()
    to_right = (x - left) < 0.5 * (right - left)
    ax.plot([x], [y], "o", color=colour, markeredgecolor="white", markersize=7, zorder=5, clip_on=False)
    ax.annotate(text, (x, y), xytext=(7 if to_right else -7, -7 if below else 7), textcoords="offset points",
                ha="left" if to_right else "right", va="top" if below else "bottom", color=colour, fontsize="small",
                fontweight="bold", path_effects=halo(), zorder=6)


def upright(ax: Axes, x: float, text: str) -> None:
    """A dotted line across the plot with its name along it."""
    ax.axvline(x, color=SOFT, linewidth=0.9, linestyle=(0, (2, 3)), zorder=1.5)
    ax.annotate(text, (x, 1.0), xycoords=("data", "axes fraction"), xytext=(-3, -4), textcoords="offset points",
                rotation=90, ha="right", va="top", color=SOFT, fontsize="small", path_effects=halo())


def level(ax: Axes, y: float, text: str) -> None:
    """A dashed line at a value with its name on it."""
    ax.axhline(y, color=ACCENT, linewidth=1.2, linestyle=(0, (7, 4)), zorder=1.6)
    ax.annotate(text, (0.6, y), xycoords=("axes fraction", "data"), xytext=(0, 2), textcoords="offset points",
                ha="center", va="bottom", color=ACCENT, fontsize="small", path_effects=halo())


def lane_for(names: list[str]) -> float:
    """Height [pt] of slanted names."""
    longest = max((len(name) for name in names), default=0)
    return 5.2 * longest * np.sin(np.radians(_SLANT)) + 8 if longest else 0.0


def names_above(ax: Axes, names: list[str], x: np.ndarray) -> None:
    """Slanted names above the plot, as many as fit. The limits of `ax` must be set."""
    left, right = ax.get_xlim()
    points = 72 * axes_size(ax)[0] / (right - left)  # per unit of x
    last = -np.inf
    for name, position in zip(names, x):
        if (position - last) * points < 11 or not left <= position <= right:
            continue
        last = position
        ax.annotate(name, (position, 1.0), xycoords=("data", "axes fraction"), xytext=(0, 3), textcoords="offset points",
                    rotation=_SLANT, rotation_mode="anchor", ha="left", va="bottom", color=SOFT, fontsize="small")


def names_below(ax: Axes, names: list[str], positions: np.ndarray) -> None:
    """Names as ticks of the x axis; slanted if they would overlap."""
    wide = 72 * axes_size(ax)[0] / max(len(names), 1)
    aslant = max((len(name) for name in names), default=0) * 5.2 + 6 > wide
    ax.set_xticks(positions)
    turn = {"rotation": _SLANT, "ha": "right", "rotation_mode": "anchor"} if aslant else {}
    ax.set_xticklabels(names, fontsize="small", **turn)
    ax.tick_params(axis="x", length=0)
    ax.grid(False, axis="x")


def extent(*curves: Any) -> tuple[float, float]:
    """Returns the minimum and maximum of the finite values of all `curves`, (0, 1) if there are none."""
    finite = np.concatenate([np.ravel(np.asarray(curve, dtype=float)) for curve in curves])
    finite = finite[np.isfinite(finite)]
    return (float(finite.min()), float(finite.max())) if finite.size else (0.0, 1.0)


def room(low: float, high: float, above: float = 0.18, below: float = 0.05, zero: bool = False) -> tuple[float, float]:
    """Returns limits with room for marks above and below; with `zero` they hold zero."""
    if zero:
        low, high = min(low, 0.0), max(high, 0.0)
    span = high - low or abs(high) or 1.0
    return (low if zero and low == 0.0 else low - below * span), high + above * span


def is_overbend(part: str) -> bool:
    """Returns True if `part` selects the overbend only. Raises: ValueError for an unknown part."""
    if part not in ("whole", "overbend"):
        raise ValueError(f"part: found {part!r}, expected 'whole' or 'overbend'")
    return part == "overbend"
