"""Figures of a dynamic analysis."""

from __future__ import annotations

from itertools import cycle
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from . import drawing as draw
from .along import AlongPipe, yield_stress
from .rollers import Slots
from .units import display_name, shown, with_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_COLOURS = [draw.DYNAMIC, draw.SECOND, draw.THIRD, draw.PIPE, draw.PORT, draw.STEEL]
_LONG = 7200.0  # [s] longer runs are drawn in minutes


class DynamicPlots:
    """Figures of a dynamic analysis: `run.plot.envelope('von_mises')`. All return matplotlib Axes.

    Without `ax` each makes a figure of its own. Values are in the units of the reports (kN, kN m, MPa, m); time counts
    from the end of the build-up, which is shaded.
    """

    def __init__(self, run: Any) -> None:
        self._run = run

    def history(self, name: str, *more: str, ax: Optional[Axes] = None,
                between: Optional[tuple[float, float]] = None) -> Axes:
        """Draws histories of one unit over time.

        Args:
            name, more: names of histories, as in `run.histories`.
            between: first and last time shown [s].
        Raises: KeyError for an unknown history, ValueError where their units differ.
        """
        histories = {each: self._run.history(each) for each in (name, *more)}
        units = {each: str(history.attrs["units"]) for each, history in histories.items()}
        if len(set(units.values())) > 1:
            found = ", ".join(f"{each} [{unit}]" for each, unit in units.items())
            raise ValueError(f"history: found {found}, expected histories of one unit; draw each into axes of its own")
        ax = draw.axes(ax, (9.6, 3.0))
        unit, factor, _ = shown(name, units[name])
        seconds, time_unit = (60.0, "min") if float(self._run.duration) > _LONG else (1.0, "s")
        values = []
        for colour, (each, history) in zip(cycle(_COLOURS), histories.items()):
            time = np.asarray(history.coords["time"])
            seen = np.ones(len(time), bool) if between is None else (time >= between[0]) & (time <= between[1])
            values.append(factor * np.asarray(history)[seen])
            ax.plot(time[seen] / seconds, values[-1], color=colour, linewidth=1.0, label=each if more else None)
        start, end = between or (-float(self._run.build_up), float(self._run.duration))
        if start < 0:
            ax.axvspan(start / seconds, 0, color="#eceff2", linewidth=0, zorder=0)
        ax.set_xlim(start / seconds, end / seconds)
        ax.set_ylim(*draw.room(*draw.extent(*values), above=0.08, below=0.08))
        title = ", ".join(display_name(each) for each in histories)
        draw.label(ax, title, f"Time from the end of the build-up [{time_unit}]",
                   with_unit("" if more else title, unit).strip(), of=self._run.title)
        return ax

    def envelope(self, name: str, ax: Optional[Axes] = None, *, part: str = "whole") -> Axes:
        """Draws the envelope of a quantity along the pipe over the run, its mean, and the static state.

        Args:
            name: 'effective_tension', 'bending_moment', 'bending_stress', 'von_mises' or 'strain'.
            part: 'whole' line or 'overbend'.
        """
        envelope = self._run.envelope(name)
        unit, factor, digits = shown(name, str(envelope["max"].attrs["units"]))
        figure = AlongPipe(self._run.static, ax, part)
        s = np.asarray(envelope["s"])
        seen = figure.inside(s)
        distance = figure.from_tensioner(s)[seen]
        low, high, mean, static = (factor * np.asarray(envelope[key])[seen] for key in ("min", "max", "mean", "static"))
        figure.ax.fill_between(distance, low, high, color=draw.BAND, linewidth=0, zorder=1.2, label="min to max")
        figure.ax.plot(distance, high, color=draw.DYNAMIC, linewidth=1.2)
        figure.ax.plot(distance, low, color=draw.DYNAMIC, linewidth=0.8)
        figure.ax.plot(distance, mean, color=draw.SECOND, linestyle=(0, (6, 3)), linewidth=1.3, label="mean")
        figure.ax.plot(distance, static, color=draw.PIPE, linewidth=1.6, label="static")
        limits = draw.room(*draw.extent(low, high, static), zero=name != "effective_tension")
        least = 1e-6 * yield_stress(self._run.static) if name in ("von_mises", "bending_stress") else 0.0
        if least > 0 and high.max() > 0.5 * least:
            draw.level(figure.ax, least, f"yield {least:.0f} MPa")
            limits = limits[0], max(limits[1], 1.12 * least)
        title = display_name(name)
        axes = figure.finish(title, with_unit(title, unit), limits)
        most = int(np.nanargmax(high))
        figure.mark_at(float(distance[most]), float(high[most]), digits, unit, colour=draw.DYNAMIC)
        return axes

    def spectrum(self, name: str, ax: Optional[Axes] = None) -> Axes:
        """Draws the spectral density of a history over frequency [Hz], with periods above the plot."""
        spectrum = self._run.spectrum(name)
        history_units = str(self._run.history(name).attrs["units"])
        unit, factor, _ = shown(name, history_units)
        frequency = np.asarray(spectrum.coords["frequency"])
        density = factor**2 * np.asarray(spectrum)
        ax = draw.axes(ax, (6.4, 3.2))
        ax.fill_between(frequency, density, color=draw.BAND, linewidth=0)
        ax.plot(frequency, density, color=draw.DYNAMIC, linewidth=1.2)
        ax.set_xlim(0.0, float(frequency.max()))
        ax.set_ylim(0.0, 1.12 * float(density.max()) or 1.0)
        peak = frequency[density.argmax()]
        title = display_name(name) + (f", peak at {1 / peak:.1f} s" if peak > 0 else "")
        draw.label(ax, title, "Frequency [Hz]", f"Spectral density [{unit or '1'}²/Hz]", lane=16,
                   of=self._run.title)
        _periods(ax, float(frequency.max()))
        return ax

    def impacts(self, ax: Optional[Axes] = None, *, over: str = "time") -> Axes:
        """Draws the peak force of the hardest impacts on rollers [kN].

        Args:
            over: 'time' [s], or 'approach_velocity': the normal velocity at first contact [m/s].
        """
        unit, factor, digits = shown("peak_force", "N")
        speed = shown("approach_velocity", "m/s")
        labels = {"time": "Time from the end of the build-up [s]",
                  "approach_velocity": f"Normal velocity at first contact [{speed.unit}]"}
        if over not in labels:
            raise ValueError(f"over: found {over!r}, expected 'time' or 'approach_velocity'")
        hits = self._run.hardest_impacts if "hardest_impacts" in dir(self._run) else []
        ax = draw.axes(ax)
        if not hits:
            draw.label(ax, "No impacts", labels[over], f"Peak force [{unit}]", of=self._run.title)
            return ax
        force, x = factor * np.asarray(hits["peak_force"]), (1.0 if over == "time" else speed.factor) * np.asarray(hits[over])
        rollers = self._run.rollers
        roller = np.asarray(hits["roller"], dtype=int)
        position = np.asarray(rollers["position"]).astype(str)[roller]
        for name, colour in draw.ROLLERS.items():
            these = position == name
            if these.any():
                ax.plot(x[these], force[these], "o", color=colour, alpha=0.7, markersize=4.5, label=name)
        end = max(float(self._run.duration), float(x.max())) if over == "time" else 1.08 * float(x.max()) or 1.0
        ax.set_xlim(0.0, end)
        ax.set_ylim(0.0, 1.2 * float(force.max()))
        draw.label(ax, f"Peak force of the {len(hits)} hardest impacts", labels[over], f"Peak force [{unit}]",
                   of=self._run.title)
        hardest = int(force.argmax())
        box = str(np.asarray(self._run.static.supports["name"])[int(np.asarray(rollers["box"])[roller[hardest]])])
        draw.mark(ax, float(x[hardest]), float(force[hardest]), f"{force[hardest]:.{digits}f} {unit} ({box}, {position[hardest]})",
                  draw.ROLLERS[position[hardest]])
        return ax

    def reactions(self, ax: Optional[Axes] = None, *, position: str = "bottom") -> Axes:
        """Draws the range of reaction of every roller over the run [kN], with its mean and its static value.

        Args:
            position: of the rollers: 'bottom', 'port' or 'starboard'.
        """
        rollers, slots = self._run.rollers, Slots(self._run.static)
        these = np.asarray(rollers["position"]).astype(str) == position
        if not these.any():
            raise ValueError(f"position: found {position!r}, but no box has such rollers")
        box, row = (np.asarray(rollers[key], dtype=int)[these] for key in ("box", "row"))
        first = np.array([np.flatnonzero(slots.box_of_row == k)[0] for k in range(len(slots.names))])
        slot = slots.of_row[first[box] + row]
        unit, factor, digits = shown("reaction", "N")
        low, high, mean = (factor * np.asarray(rollers[f"reaction_{key}"])[these] for key in ("min", "max", "mean"))
        static = factor * np.asarray(rollers["static_reaction"])[these]
        loaded = (high > 0) | (static > 0)
        ax = draw.axes(ax)
        ax.bar(slot[loaded], (high - low)[loaded], 0.72, low[loaded], color=draw.BAND, edgecolor=draw.DYNAMIC,
               linewidth=0.9, label="min to max", zorder=2)
        ax.hlines(mean[loaded], slot[loaded] - 0.36, slot[loaded] + 0.36, color=draw.SECOND, linewidth=1.8, label="mean",
                  zorder=3)
        ax.plot(slot[static > 0], static[static > 0], "o", color=draw.PIPE, markersize=4.5, label="static", zorder=4)
        ax.set_ylim(0.0, draw.room(0.0, max(high.max(), static.max()) or 1.0)[1])
        slots.furnish(ax)
        draw.label(ax, f"{position.capitalize()} rollers", "Roller rows of each box, from the tensioner astern",
                   f"Reaction [{unit}]", of=self._run.title)
        most = int(high.argmax())
        draw.mark(ax, slot[most], high[most], f"{high[most]:.{digits}f} {unit} ({slots.names[box[most]]})", draw.DYNAMIC)
        return ax


def _periods(ax: Any, end: float) -> None:
    """Periods above the plot, as many as fit."""
    last, chosen = np.inf, []
    wide = 72 * draw.axes_size(ax)[0] / end
    for period in (2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 30, 60, 120):
        frequency = 1 / period
        if frequency <= end and (last - frequency) * wide > 18 and frequency * wide > 16:
            chosen.append(period)
            last = frequency
    above = ax.secondary_xaxis("top")
    above.set_xticks([1 / period for period in chosen])
    above.set_xticklabels([f"{period}" for period in chosen], fontsize="small")
    above.tick_params(colors=draw.SOFT, pad=1)
    above.spines["top"].set_visible(False)
    ax.annotate("T [s]", (0, 1), xycoords="axes fraction", xytext=(-6, 6), textcoords="offset points", ha="right",
                color=draw.SOFT, fontsize="small")
