"""Results of dynamic analyses: key results, tables, histories, envelopes, spectra, snapshots."""

from __future__ import annotations

import functools
import pathlib
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from .groups import Table, nearest
from .results import (Checks, PathLike, Results, StaticResults, copied_folder, file_in, load_model, summary_descriptions,
                      summary_in, summary_units)
from .values import labelled, xarray_module

if TYPE_CHECKING:
    from .model import Model


class DynamicResults(Results):
    """Results of a dynamic analysis: key results of `dynamic` in summary.json (top_tension.max [N], lay_back, ...), tables,
    histories.

    Further attributes:
        static: The initial static state, a StaticResults.
        stations: Table of the stations: static state and envelopes.
        supports, rollers: Tables of statistics: reactions [N], separations [m], impacts.
        impacts, hardest_impacts: Tables of impacts: time [s], roller, peak_force [N], ...
        extremes: Table of the most probable three-hour maxima or minima.
    """

    _part = "dynamic"
    _tables = {"stations": "/dynamic/stations", "supports": "/dynamic/supports", "rollers": "/dynamic/rollers",
               "impacts": "/dynamic/impacts", "hardest_impacts": "/dynamic/hardest_impacts",
               "extremes": "/dynamic/extremes", "stinger_sections": "/dynamic/stinger",
               "mooring_lines": "/dynamic/moorings/lines", "mooring_events": "/dynamic/moorings/events",
               "thrust": "/dynamic/thrust",
               "fatigue_spots": "/dynamic/fatigue/spots"}
    _in_static = {"effective_tension": "static_tension", "bending_moment": "static_moment"}

    def __init__(self, folder: pathlib.Path, model: "Optional[Model]" = None, holder: Any = None):
        """Not for users: see Model.dynamic() and overbend.open()."""
        super().__init__(model)
        self._folder, self._holder = folder, holder

    @property
    def folder(self) -> pathlib.Path:
        """Folder of the results."""
        return self._folder

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """The content of summary.json."""
        return summary_in(self._folder)

    @functools.cached_property
    def _source(self) -> Any:
        return file_in(self._folder)

    @property
    def model(self) -> "Model":
        """Model of these results."""
        return load_model(self)

    @functools.cached_property
    def checks(self) -> "Checks":
        """Code checks of the run; `static.checks` are those of the initial static state."""
        units, descriptions = summary_units()[self._part], summary_descriptions()[self._part]
        return Checks(self.summary.get(self._part, {}).get("checks", {}), units.get("checks"), descriptions.get("checks"))

    @functools.cached_property
    def static(self) -> StaticResults:
        """The initial static state with its own `checks`."""
        return StaticResults(None, self._model, self._folder)

    @functools.cached_property
    def _histories(self) -> dict[str, str]:
        """Path of every history, including the end tensions of lines other than the pipe and moorings."""
        paths = {name: f"/dynamic/histories/{name}" for name in _below(self._source, "/dynamic/histories")}
        for number, line in enumerate(self._quick.get("static", {}).get("lines", [])):
            for end in ("first_tension", "second_tension"):
                if self._source.has(f"/lines/{number}/{end}"):
                    paths[f"{line['name']}/{end}"] = f"/lines/{number}/{end}"
        if self._source.has("/lines/time"):
            paths["time"] = "/lines/time"
        return paths

    @property
    def histories(self) -> list[str]:
        """Names of the histories."""
        return [name for name in self._histories if name != "time"]

    @functools.cached_property
    def time(self) -> np.ndarray:
        """Times of the histories [s], from the start of the build-up; statistics cover t >= 0."""
        return self._source.dataset(self._histories["time"])[0]

    def history(self, name: str) -> Any:
        """A history as a labelled array over time [s].

        Args:
            name: One of `histories`: 'top_tension', 'support/stinger 8/reaction', ...

        Raises:
            KeyError: If there is no history of that name.
        """
        if name not in self.histories:
            raise KeyError(f"there is no history '{name}'{nearest(name, self.histories)}; `histories` lists them")
        values, units, description, frame, _ = self._source.dataset(self._histories[name])
        return labelled(values, name, ("time",), {"time": self.time}, units, description, frame)

    def envelope(self, name: str) -> Any:
        """Envelope of a quantity along the pipe: min, max, mean, std and static value over the arc length s [m].

        Args:
            name: 'effective_tension' [N], 'bending_moment' [N m], 'bending_stress', 'von_mises' [Pa], 'strain', or a
                coordinate 'x', 'y', 'z' [m].

        Returns:
            An xarray.Dataset, or a Table if xarray is not used.
        """
        stations = self.stations
        known = sorted(column[:-4] for column in stations.keys() if column.endswith("_max"))
        if name not in known:
            raise KeyError(f"there is no envelope of '{name}'; there are: {', '.join(known)}")
        columns = {part: stations.column(f"{name}_{part}") for part in ("min", "max", "mean", "std")}
        static = self._in_static.get(name, f"static_{name}")
        if static in stations:
            columns["static"] = stations.column(static)
        columns = {part: _renamed(column, part) for part, column in columns.items()}
        xarray = xarray_module()
        if xarray is not None:
            return xarray.Dataset(columns, attrs={"quantity": name, "units": columns["max"].attrs["units"]})
        return Table(["s", *columns], lambda column: stations.column("s") if column == "s" else columns[column])

    def spectrum(self, name: str) -> Any:
        """Variance density of a history over frequency [Hz], for the histories listed in `spectra`."""
        if name not in self.spectra:
            raise KeyError(f"there is no spectrum of '{name}'{nearest(name, self.spectra)}; `spectra` lists them")
        group = f"/dynamic/spectra/{name}"
        values, units, description, frame, _ = self._source.dataset(f"{group}/density")
        frequency = self._source.dataset(f"{group}/frequency")[0]
        return labelled(values, name, ("frequency",), {"frequency": frequency}, units, description, frame)

    @functools.cached_property
    def spectra(self) -> list[str]:
        """Names of the histories with a spectrum."""
        names = _below(self._source, "/dynamic/spectra")
        return [name[: -len("/density")] for name in names if name.endswith("/density")]

    def snapshots(self, name: str = "z", first: int = 0, count: Optional[int] = None) -> Any:
        """The line at successive times, as a labelled array of shape (times, stations).

        Args:
            name: 'x', 'y', 'z' [m], 'effective_tension' [N] or 'von_mises' [Pa].
            first: Index of the first snapshot.
            count: Number of snapshots; all following ones if omitted. Only these are read from the file.
        """
        path = f"/dynamic/snapshots/{name}"
        if name not in ("x", "y", "z", "effective_tension", "von_mises") or not self._source.has(path):
            raise KeyError(f"there are no snapshots of '{name}'; there are: x, y, z, effective_tension, von_mises")
        total = self._source.extent(path)
        count = max(0, min(total - first, total if count is None else count))
        time = self._source.lines("/dynamic/snapshots/time", first, count)
        arc = self._source.dataset("/dynamic/stations/s")[0]
        values = self._source.lines(path, first, count).reshape(count, len(arc))
        units = {"effective_tension": "N", "von_mises": "Pa"}.get(name, "m")
        return labelled(values, name, ("time", "s"), {"time": time, "s": arc}, units)

    def save(self, folder: PathLike) -> pathlib.Path:
        """Copies the files of the run, including report.html, into a new or empty folder."""
        return copied_folder(self._folder, folder)

    @property
    def plot(self) -> Any:
        """Figures with matplotlib: plot.history(name), plot.envelope(name), plot.spectrum(name), ..."""
        from .plots import DynamicPlots

        return DynamicPlots(self)


def _renamed(column: Any, name: str) -> Any:
    if hasattr(column, "rename"):
        return column.rename(name)
    column.name = name
    return column


def _below(source: Any, group: str) -> list[str]:
    """Relative paths of the datasets in a group and the groups below it."""
    found: list[str] = []
    for name in source.names(group):
        if name.endswith("/"):
            found += [f"{name}{deeper}" for deeper in _below(source, f"{group}/{name[:-1]}")]
        else:
            found.append(name)
    return found
