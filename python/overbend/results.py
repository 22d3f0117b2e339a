"""Results of analyses: key results by their names in summary.json, tables by those in results.h5."""

from __future__ import annotations

import functools
import json
import os
import pathlib
import shutil
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np

from . import _core
from .errors import ResultsError
from .findings import Finding, findings_of
from .groups import Record, Records, Table, nearest, record_of, table_of, wrapped
from .objects import Objects, objects_in
from .values import Number

if TYPE_CHECKING:
    from .model import Model

PathLike = Union[str, "os.PathLike[str]"]


@functools.cache
def summary_units() -> dict[str, Any]:
    """Units of results in the places that these have in summary.json."""
    return _core.summary_units()


@functools.cache
def summary_descriptions() -> dict[str, Any]:
    """Descriptions likewise."""
    return _core.summary_descriptions()


class Results:
    """What static and dynamic results have in common.

    Key results are attributes by their names in summary.json: `static.lay_back`, `run.top_tension.max`. An item gives a
    result by its name as goal seek and studies have it: `static['static.supports[stinger *].reaction']`, or by object:
    `static['lines[pipe].static.lay_back']`.
    """

    #: The part of the summary whose values are attributes.
    _part = "static"
    #: Names of what takes longer than the rest and is found when it is asked for.
    _late: tuple[str, ...] = ()
    #: Tables by their names and the groups of results.h5 that they come from.
    _tables: dict[str, str] = {}

    def __init__(self, model: "Optional[Model]"):
        self._model = model

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """The content of summary.json."""
        raise NotImplementedError

    @functools.cached_property
    def _quick(self) -> dict[str, Any]:
        """The summary, if need be without what is late."""
        return self.summary

    @functools.cached_property
    def _source(self) -> Any:
        raise NotImplementedError

    @property
    def title(self) -> str:
        """Title of the model."""
        return self._quick.get("title", "")

    @property
    def findings(self) -> list[Finding]:
        """What an engineer should know about these results, and of a run in time about the static state it began from."""
        found = [findings_of(told.get("findings", [])) for told in (self.summary.get(self._part, {}), self.summary)]
        return list(dict.fromkeys([*found[0], *found[1]]))

    @property
    def warnings(self) -> list[str]:
        """The messages of the findings."""
        return [finding.message for finding in self.findings]

    @property
    def verdict(self) -> str:
        """'passed', 'reserved' (a finding is serious), 'exceeded' or 'not judged'."""
        told = self.summary.get(self._part, {}).get("verdict") or self.summary.get("verdict", {})
        return told.get("kind", "not judged")

    @property
    def assumptions(self) -> list[str]:
        """What was assumed, in statics as well."""
        return self._sentences("assumptions")

    @functools.cached_property
    def checks(self) -> "Checks":
        """The code checks."""
        return Checks(self.summary.get("checks", {}), summary_units().get("checks"), summary_descriptions().get("checks"))

    @functools.cached_property
    def objects(self) -> Objects:
        """The results by object: `objects.lines['pipe'].static.lay_back`, `objects.supports['stinger 3'].static.reaction`."""
        return objects_in(self.summary)

    @functools.cached_property
    def _record(self) -> Record:
        return self._part_of(self._quick)

    @functools.cached_property
    def _text(self) -> str:
        return json.dumps(self.summary)

    @functools.cached_property
    def _quick_text(self) -> str:
        return json.dumps(self._quick)

    def _sentences(self, name: str) -> list[str]:
        """Its own, then those of the static state that it began from; each once."""
        of_part, of_statics = (told.get(name, []) for told in (self.summary.get(self._part, {}), self.summary))
        return list(dict.fromkeys([*of_part, *of_statics]))

    def _part_of(self, summary: dict[str, Any]) -> Record:
        told = summary_units().get(self._part), summary_descriptions().get(self._part)
        return Record(summary.get(self._part, {}), *told)

    def _table(self, name: str) -> Table:
        group = self._tables[name]
        if not self._source.names(group):
            return Table([], lambda column: None)  # no impacts in a calm sea, no supports in a J-lay
        rows = self._quick.get(self._part, {}).get(name)
        records = self._record[name] if isinstance(rows, list) and rows and isinstance(rows[0], dict) else None
        return table_of(self._source, group, records if isinstance(records, Records) else None)

    def _names(self) -> list[str]:
        tables = [name for name, group in self._tables.items() if self._source.names(group)]
        return [*self._record.keys(), *(name for name in tables if name not in self._record)]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            record = self._part_of(self.summary) if name in self._late else self._record
            value = self._table(name) if name in self._tables else record[name]
        except KeyError as fault:
            known = name in self._tables  # and these results have no such table
            raise AttributeError(fault.args[0] if known else f"there is no '{name}'{nearest(name, self._names())}") from None
        self.__dict__[name] = value
        return value

    def __getitem__(self, name: str) -> Any:
        """A result by name: a Number, an array where a pattern chooses several items.

        Args:
            name: "static.sagbend.max_bending_stress", "static.supports[stinger *].reaction", also within min(), max(),
                mean() or spread(); the name of an attribute as well.

        Raises:
            KeyError: Where no result has this name.
        """
        late = "checks." in name or any(f".{word}" in name for word in self._late)
        values, unit, one = _core.named_values(self._text if late else self._quick_text, name)
        if not values and "." not in name and "[" not in name:
            try:
                return getattr(self, name)
            except AttributeError as fault:
                raise KeyError(*fault.args) from None
        if not values:
            raise KeyError(f"there is no result '{name}'{nearest(name, _core.result_paths())}")
        return Number(values[0], unit) if one else np.array(values)

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._names()})

    def __repr__(self) -> str:
        checks = self.checks
        worst = f", worst check {checks.worst.name}: {checks.worst.utilisation:.3f}" if checks.worst else ""
        return f"<{type(self).__name__} of '{self.title}'{worst}, verdict: {self.verdict}, {len(self.findings)} findings>"


class Checks(Records):
    """The code checks, a group for each: `.name`, `.status`, `.utilisation`, ...

    `.sheet` of a check is its calculation, a group for each line: `.symbol`, `.formula`, `.value`, `.units`, `.origin`,
    `.confirmation`; the last line is the utilisation.

    Attributes:
        worst: The governing check that is used most; None where none is judged.
    """

    def __init__(self, part: dict[str, Any], units: Any, descriptions: Any):
        whole = wrapped(part, units, descriptions)
        listed = whole["list"] if "list" in whole else []
        super().__init__(listed if isinstance(listed, Records) else [])
        self.worst: Optional[Record] = whole["worst"] if "worst" in whole else None

    def to_pandas(self) -> Any:
        """A row for each check as a pandas.DataFrame, columns in the order of checks.csv.

        Values are SI: demand and capacity in the unit that the column `units` names, places [m], time [s]. `inputs` is
        a text, as there.
        """
        frame = super().to_pandas()
        places = [name for name in frame.columns if name.startswith("at.")]
        frame = frame.rename(columns={name: name.removeprefix("at.") for name in places})
        frame["inputs"] = ["; ".join(map(_input, check["inputs"])) if "inputs" in check else "" for check in self]
        for table in (frame.attrs["units"], frame.attrs["descriptions"]):
            for name in places:
                table[name.removeprefix("at.")] = table.pop(name)
        frame.attrs["units"]["inputs"], frame.attrs["descriptions"]["inputs"] = "1", "Numbers that the capacity follows from"
        return frame

    @property
    def passed(self) -> bool:
        """Whether no governing check is exceeded."""
        return not any(check["governing"] and check["status"] == "exceeded" for check in self)

    @property
    def exceeded(self) -> list[Record]:
        """The checks that are exceeded."""
        return [check for check in self if check["status"] == "exceeded"]


def _input(one: Record) -> str:
    """ "t1 = 0.0127 m" """
    return f"{one['symbol']} = {one['value']:g} {one['units']}".removesuffix(" 1")


class StaticResults(Results):
    """An equilibrium with its code checks.

    Attributes beside the key results of summary.json (lay_back [m], top_tension [N], departure_angle [rad], touchdown,
    overbend, sagbend, ...):
        pipe: Table of the stations over s, the unstressed arc length from the anchor [m]: effective_tension [N],
            bending_moment [N m], von_mises [Pa], strain, x, y, z [m] (world: x east, y north, z up), ...
        supports, rows, rollers: Tables of the roller boxes, their rows and rollers: reaction [N], separation [m], ...
        sections, structures: What the pipe is made of.
        points, wires: Clumps, buoys and wires on the pipe, by name: x, z [m], moment [N m], tension_before [N], ...
    """

    _late = ("roller_friction", "hull")
    _tables = {"pipe": "/static/stations", "supports": "/static/supports", "rows": "/static/rows",
               "rollers": "/static/rollers", "sections": "/static/sections", "structures": "/static/structures",
               "stinger_sections": "/static/stinger", "contacts": "/static/bed/contacts",
               "bed_heights": "/static/bed/heights",
               "free_spans": "/static/bed/spans", "mooring_lines": "/moorings/lines"}

    def __init__(self, solved: "Optional[_core.Statics]", model: "Optional[Model]", folder: Optional[pathlib.Path] = None):
        """Not for users: see Model.static() and overbend.open()."""
        super().__init__(model)
        self._solved, self._folder = solved, folder

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """The content of summary.json."""
        if self._solved is not None:
            return self._solved.summary(all=True)
        return summary_in(self._folder)

    @functools.cached_property
    def _quick(self) -> dict[str, Any]:
        return self._solved.summary(all=False) if self._solved is not None else self.summary

    @functools.cached_property
    def _source(self) -> Any:
        return self._solved.tree() if self._solved is not None else file_in(self._folder)

    @property
    def model(self) -> "Model":
        """The model that these are the results of."""
        return model_of(self)

    @functools.cached_property
    def scene(self) -> Record:
        """Where things are, for figures of one's own.

        `stern_shoe` and `tensioner` [m, W], `vessel_axes` (columns forward, port, up in W), `vessel_length`, `vessel_beam`,
        `vessel_depth`, `vessel_draught`, `water_depth`, `pipe_outer_diameter`, `steel_outer_diameter` [m].
        """
        return record_of(self._source, "/static/scene")

    def save(self, folder: PathLike) -> pathlib.Path:
        """Writes the files that `overbend static -o` writes, report.html with them, whole or not at all.

        Raises:
            ResultsError: Where the folder cannot be written.
        """
        if self._solved is None:
            return copied_folder(self._folder, folder)
        self._solved.save(os.fspath(folder))
        return pathlib.Path(folder)

    @property
    def plot(self) -> Any:
        """Figures with matplotlib: plot.profile(), plot.tension(), plot.moment(), ..."""
        from .plots import StaticPlots

        return StaticPlots(self)


def summary_in(folder: Optional[pathlib.Path], file: str = "summary.json") -> dict[str, Any]:
    """The content of a file of results. Raises ResultsError where there is none, or it is damaged."""
    path = pathlib.Path(folder or ".") / file
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as fault:
        raise ResultsError(f"there are no results in '{folder}': '{path}': {fault}") from None
    if not isinstance(content, dict):
        raise ResultsError(f"there are no results in '{folder}': '{path}' is damaged: it holds no object")
    return content


def file_in(folder: Optional[pathlib.Path]) -> "_core.ResultFile":
    return _core.ResultFile(str(pathlib.Path(folder or ".") / "results.h5"))


def model_of(results: Any) -> "Model":
    if results._model is None:
        from .model import Model

        source = results._source
        text, file = source.dataset("/model/text")[0], source.dataset("/model/file")[0]
        results._model = Model.from_text(str(text), str(file))
    return results._model


def copied_folder(source: Optional[pathlib.Path], folder: PathLike) -> pathlib.Path:
    """Copies a folder of results into one that is new or empty."""
    target = pathlib.Path(folder)
    if target.exists() and any(target.iterdir()):
        raise ResultsError(f"the folder '{target}' is not empty")
    shutil.copytree(source or ".", target, dirs_exist_ok=True)
    return target
