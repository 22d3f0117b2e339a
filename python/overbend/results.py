"""Results of analyses: key results named as in summary.json, tables as in results.h5."""

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
from .findings import Finding, make_findings
from .groups import Record, Records, Table, make_record, make_table, nearest, wrapped
from .objects import Objects, objects_in
from .values import Number

if TYPE_CHECKING:
    from .model import Model

PathLike = Union[str, "os.PathLike[str]"]


@functools.cache
def summary_units() -> dict[str, Any]:
    """Units of the results, at their paths in summary.json."""
    return _core.summary_units()


@functools.cache
def summary_descriptions() -> dict[str, Any]:
    """Descriptions of the results, at their paths in summary.json."""
    return _core.summary_descriptions()


class Results:
    """Common part of static and dynamic results.

    Key results are attributes named as in summary.json: `static.lay_back`, `run.top_tension.max`. Items are results by
    their path, as in goal seeks and studies: `static['static.supports[stinger *].reaction']`, or by
    object: `static['lines[pipe].static.lay_back']`.
    """

    #: Part of the summary whose values are attributes.
    _part = "static"
    #: Names of results that take longer and are computed on access.
    _late: tuple[str, ...] = ()
    #: Groups of results.h5 by the names of the tables.
    _tables: dict[str, str] = {}

    def __init__(self, model: "Optional[Model]"):
        self._model = model

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """Content of summary.json."""
        raise NotImplementedError

    @functools.cached_property
    def _quick(self) -> dict[str, Any]:
        """The summary, possibly without the results that take longer."""
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
        """Findings on these results; for a dynamic analysis including those on its static state."""
        found = [make_findings(part.get("findings", [])) for part in (self.summary.get(self._part, {}), self.summary)]
        return list(dict.fromkeys([*found[0], *found[1]]))

    @property
    def warnings(self) -> list[str]:
        """Messages of the findings."""
        return [finding.message for finding in self.findings]

    @property
    def verdict(self) -> str:
        """'passed', 'reserved' (a finding is serious), 'exceeded' or 'not judged'."""
        verdict = self.summary.get(self._part, {}).get("verdict") or self.summary.get("verdict", {})
        return verdict.get("kind", "not judged")

    @property
    def assumptions(self) -> list[str]:
        """Assumptions, including those of the static state."""
        return self._sentences("assumptions")

    @functools.cached_property
    def checks(self) -> "Checks":
        """The code checks."""
        return Checks(self.summary.get("checks", {}), summary_units().get("checks"), summary_descriptions().get("checks"))

    @functools.cached_property
    def objects(self) -> Objects:
        """Results by object: `objects.lines['pipe'].static.lay_back`, `objects.supports['stinger 3'].static.reaction`."""
        return objects_in(self.summary)

    @functools.cached_property
    def _record(self) -> Record:
        return self._part_record(self._quick)

    @functools.cached_property
    def _text(self) -> str:
        return json.dumps(self.summary)

    @functools.cached_property
    def _quick_text(self) -> str:
        return json.dumps(self._quick)

    def _sentences(self, name: str) -> list[str]:
        """Sentences of this part, then those of the static state, without duplicates."""
        of_part, of_statics = (part.get(name, []) for part in (self.summary.get(self._part, {}), self.summary))
        return list(dict.fromkeys([*of_part, *of_statics]))

    def _part_record(self, summary: dict[str, Any]) -> Record:
        labels = summary_units().get(self._part), summary_descriptions().get(self._part)
        return Record(summary.get(self._part, {}), *labels)

    def _table(self, name: str) -> Table:
        group = self._tables[name]
        if not self._source.names(group):
            return Table([], lambda column: None)  # no impacts in a calm sea, no supports in a J-lay
        rows = self._quick.get(self._part, {}).get(name)
        records = self._record[name] if isinstance(rows, list) and rows and isinstance(rows[0], dict) else None
        return make_table(self._source, group, records if isinstance(records, Records) else None)

    def _names(self) -> list[str]:
        tables = [name for name, group in self._tables.items() if self._source.names(group)]
        return [*self._record.keys(), *(name for name in tables if name not in self._record)]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            record = self._part_record(self.summary) if name in self._late else self._record
            value = self._table(name) if name in self._tables else record[name]
        except KeyError as error:
            known = name in self._tables  # and these results have no such table
            raise AttributeError(error.args[0] if known else f"there is no '{name}'{nearest(name, self._names())}") from None
        self.__dict__[name] = value
        return value

    def __getitem__(self, name: str) -> Any:
        """A result by name: a Number, or an array if a pattern selects several items.

        Args:
            name: "static.sagbend.max_bending_stress", "static.supports[stinger *].reaction", also within min(), max(),
                mean() or spread(); or the name of an attribute.

        Raises:
            KeyError: If no result has this name.
        """
        late = "checks." in name or any(f".{word}" in name for word in self._late)
        values, unit, is_single = _core.named_values(self._text if late else self._quick_text, name)
        if not values and "." not in name and "[" not in name:
            try:
                return getattr(self, name)
            except AttributeError as error:
                raise KeyError(*error.args) from None
        if not values:
            raise KeyError(f"there is no result '{name}'{nearest(name, _core.result_paths())}")
        return Number(values[0], unit) if is_single else np.array(values)

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._names()})

    def __repr__(self) -> str:
        checks = self.checks
        worst = f", worst check {checks.worst.name}: {checks.worst.utilisation:.3f}" if checks.worst else ""
        return f"<{type(self).__name__} of '{self.title}'{worst}, verdict: {self.verdict}, {len(self.findings)} findings>"


class Checks(Records):
    """The code checks, one group each: `.name`, `.status`, `.utilisation`, ...

    `.sheet` of a check is its calculation, one group per line: `.symbol`, `.formula`, `.value`, `.units`, `.origin`,
    `.confirmation`; the last line is the utilisation.

    Attributes:
        worst: The governing check with the largest utilisation; None without checks.
    """

    def __init__(self, part: dict[str, Any], units: Any, descriptions: Any):
        whole = wrapped(part, units, descriptions)
        listed = whole["list"] if "list" in whole else []
        super().__init__(listed if isinstance(listed, Records) else [])
        self.worst: Optional[Record] = whole["worst"] if "worst" in whole else None

    def to_pandas(self) -> Any:
        """A pandas.DataFrame with one row per check, columns in the order of checks.csv.

        Values are SI: demand and capacity in the unit given in the column `units`, locations [m], time [s]. `inputs` is a
        string, as in the file.
        """
        frame = super().to_pandas()
        places = [name for name in frame.columns if name.startswith("at.")]
        frame = frame.rename(columns={name: name.removeprefix("at.") for name in places})
        frame["inputs"] = ["; ".join(map(_input, check["inputs"])) if "inputs" in check else "" for check in self]
        for table in (frame.attrs["units"], frame.attrs["descriptions"]):
            for name in places:
                table[name.removeprefix("at.")] = table.pop(name)
        frame.attrs["units"]["inputs"], frame.attrs["descriptions"]["inputs"] = "1", "Inputs of the capacity"
        return frame

    @property
    def passed(self) -> bool:
        """True if no governing check is exceeded."""
        return not any(check["governing"] and check["status"] == "exceeded" for check in self)

    @property
    def exceeded(self) -> list[Record]:
        """The exceeded checks."""
        return [check for check in self if check["status"] == "exceeded"]


def _input(item: Record) -> str:
    """ "t1 = 0.0127 m" """
    return f"{item['symbol']} = {item['value']:g} {item['units']}".removesuffix(" 1")


class StaticResults(Results):
    """A static equilibrium with its code checks.

    Attributes in addition to the key results of summary.json (lay_back [m], top_tension [N], departure_angle [rad], touchdown,
    overbend, sagbend, ...):
        pipe: Table of the stations over s, the unstressed arc length from the anchor [m]: effective_tension [N],
            bending_moment [N m], von_mises [Pa], strain, x, y, z [m] (world: x east, y north, z up), ...
        supports, rows, rollers: Tables of the roller boxes, their rows and rollers: reaction [N], separation [m], ...
        sections, structures: Pipe sections and in-line structures.
        points, wires: Clump weights, buoys and wires on the pipe, by name: x, z [m], moment [N m], tension_before [N], ...
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
        """Content of summary.json."""
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
        """Model of these results."""
        return load_model(self)

    @functools.cached_property
    def scene(self) -> Record:
        """Positions and dimensions, for custom figures.

        `stern_shoe` and `tensioner` [m, W], `vessel_axes` (columns forward, port, up in W), `vessel_length`, `vessel_beam`,
        `vessel_depth`, `vessel_draught`, `water_depth`, `pipe_outer_diameter`, `steel_outer_diameter` [m].
        """
        return make_record(self._source, "/static/scene")

    def save(self, folder: PathLike) -> pathlib.Path:
        """Writes the files of `overbend static -o`, including report.html, in one step.

        Raises:
            ResultsError: If the folder cannot be written.
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
    """Content of a result file. Raises ResultsError if it is missing or damaged."""
    path = pathlib.Path(folder or ".") / file
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ResultsError(f"there are no results in '{folder}': '{path}': {error}") from None
    if not isinstance(content, dict):
        raise ResultsError(f"there are no results in '{folder}': '{path}' is damaged: it holds no object")
    return content


def file_in(folder: Optional[pathlib.Path]) -> "_core.ResultFile":
    return _core.ResultFile(str(pathlib.Path(folder or ".") / "results.h5"))


def load_model(results: Any) -> "Model":
    if results._model is None:
        from .model import Model

        source = results._source
        text, file = source.dataset("/model/text")[0], source.dataset("/model/file")[0]
        results._model = Model.from_text(str(text), str(file))
    return results._model


def copied_folder(source: Optional[pathlib.Path], folder: PathLike) -> pathlib.Path:
    """Copies a folder of results into a new or empty folder."""
    target = pathlib.Path(folder)
    if target.exists() and any(target.iterdir()):
        raise ResultsError(f"the folder '{target}' is not empty")
    shutil.copytree(source or ".", target, dirs_exist_ok=True)
    return target
