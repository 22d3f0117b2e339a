"""Studies: many cases of one model."""

from __future__ import annotations

import functools
import os
import pathlib
import warnings as python_warnings
from typing import Any, Iterable, Iterator, Mapping, Optional, Sequence, Union

import numpy as np

from . import _core
from .errors import Interrupted, ModelError, ResultsError
from .findings import findings_of
from .groups import Record, Records, Table, nearest, table_of
from .model import Model, PathLike
from .progress import CaseProgress, Cases, follower
from .results import copied_folder
from .study_text import study_text
from .temporary import TemporaryFolder
from .values import Number, labelled, stored_unit

Study = Union[Model, str, "os.PathLike[str]"]


def study(study: Study, axes: Optional[Mapping[str, Any]] = None, *, sample: Optional[Mapping[str, Any]] = None,
          seeds: Union[int, Iterable[int], None] = None, analysis: Optional[str] = None,
          gather: Optional[Sequence[str]] = None, duration: Union[str, float, None] = None,
          operability: Optional[Mapping[str, Any]] = None, title: Optional[str] = None, keep: bool = False,
          out: Optional[PathLike] = None, threads: int = 0, retry_failed: bool = False, checkpoint: float = 60.0,
          progress: Union[bool, CaseProgress] = False) -> "StudyResults":
    """Solves many cases of a model on all cores: keys crossed, together or drawn at random.

        ob.study(model, axes={'tensioner.tension': ['200 kN', '250 kN', '300 kN'],
                              'environment.water_depth': {'from': '80 m', 'to': '100 m', 'step': '5 m'}},
                 gather=['static.lay_back', 'static.sagbend.max_bending_stress'])

    A case that fails does not stop the others. Other threads of Python go on meanwhile. After Ctrl-C, a kill or a power
    cut a second call with the same `out` goes on where the first ended, and so does `overbend study OUT/study.yaml -o
    OUT`.

    Args:
        study: The model, or the path of a study file, which then says everything up to `keep`.
        axes: Values by key of the model: a list of values as with_() takes them, or a dict with from, to and step or
            steps. Every value is combined with every value of the other axes; {'values': [...], 'with': KEY} changes
            together with the axis of that key.
        sample: Keys drawn by a Latin hypercube: {'count': 200, 'seed': 1, 'keys': {KEY: {'distribution': 'normal',
            'mean': '250 kN', 'std': '5 kN'}}}.
        seeds: Of the waves, or how many; every case is run with each. Dynamic analyses only.
        analysis: 'static' (default), 'dynamic', 'operation' or 'seek'.
        gather: Results by their names in summary.json; left out a choice for the analysis.
        duration: Of dynamic analyses, in place of the model's: '600 s' or a number of seconds.
        operability: Looks for the largest value of one axis with which a criterion holds: {'over': KEY, 'resolution':
            '0.25 m', 'criterion': {'dynamic.top_tension.max': '<= 350 kN'}, 'scatter': FILE, 'alpha': 0.8}. Without a
            criterion every governing check is to be passed; {'checks': True, ...} in it asks for both.
        title: Of tables and report.
        keep: Whether all result files of every case stay.
        out: Folder for the results. Left out: a temporary folder, which goes when the results do; their save() keeps
            them.
        threads: Cases at the same time; 0: as many as there are cores.
        retry_failed: Runs cases again that failed before.
        checkpoint: Time between checkpoints of dynamic analyses [s].
        progress: True for a line on the terminal, or a function (see progress.CaseProgress), called ten times a second.

    Raises:
        ModelError: With file (OUT/study.yaml), line and key of everything that is wrong.
        ResultsError: Where the folder holds another study, or the disk refuses.
        Interrupted: After Ctrl-C, with the folder from which the study can go on.
    """
    asked = {"axes": axes, "sample": sample, "seeds": seeds, "analysis": analysis, "gather": gather,
             "duration": duration, "operability": operability, "title": title, "keep": keep or None}
    holder = TemporaryFolder() if out is None else None
    folder = holder.path / "study" if holder else pathlib.Path(os.fspath(out))  # type: ignore[arg-type]
    core = _study_of(study, asked, folder)
    tell, end = follower(progress, Cases)
    try:
        interrupted = core.run(str(folder), threads=threads, retry_failed=retry_failed, checkpoint=checkpoint,
                               progress=tell)
    finally:
        end()
    if interrupted:
        if holder is not None:
            holder.keep()
        raise Interrupted(f"interrupted; the same call with out='{folder}' goes on", folder)
    results = StudyResults(folder, core, holder)
    failed = len(results.failed)
    if failed:
        sentence = f"{failed} of {len(results)} cases have no solution: see `failed` of the results"
        python_warnings.warn(sentence, stacklevel=2)
    return results


def _study_of(study: Study, asked: Mapping[str, Any], folder: pathlib.Path) -> "_core.Study":
    if isinstance(study, Model):
        return _core.Study.of(study._core, study_text(asked), str(folder))
    given = [name for name, value in asked.items() if value is not None]
    if given:
        raise ModelError(f"{given[0]}: given beside a study file, expected there: '{os.fspath(study)}'")
    return _core.Study.read(os.fspath(study))


class StudyResults:
    """What the cases of a study gave.

    Attributes:
        title: Of the study.
        analysis: 'static', 'dynamic', 'operation' or 'seek'.
        findings: What an engineer should know; warnings are their messages.
        assumptions: What was assumed.
        command: The command line that runs it.
    """

    def __init__(self, folder: pathlib.Path, core: "Optional[_core.Study]" = None, holder: Any = None):
        """Not for users: see study() and overbend.open()."""
        self._folder, self._core, self._holder = folder, core, holder
        tables = _core.StudyTables(str(folder))
        self._source = tables.tree()
        self._told: dict[str, Any] = tables.told()
        self.title: str = self._told["title"]
        self.analysis: str = self._told["analysis"]
        self.findings = findings_of(self._told["findings"])
        self.warnings: list[str] = self._told["warnings"]
        self.assumptions: list[str] = self._told["assumptions"]
        self.command: str = self._told["command"]

    @property
    def folder(self) -> pathlib.Path:
        """Where study.csv, study.xlsx, study.h5, report.html and the records of the cases are."""
        return self._folder

    @property
    def inputs(self) -> list[str]:
        """The keys that change from case to case."""
        return [one["key"] for one in self._told["inputs"]]

    @property
    def outputs(self) -> list[str]:
        """The results that are gathered."""
        return [one["name"] for one in self._told["outputs"]]

    @functools.cached_property
    def table(self) -> Table:
        """A row for each case: inputs, seed, outputs [SI], passed, governing, utilisation, state, reason, folder,
        wall_time.

        Columns have the names of keys and results: table['tensioner.tension']. NaN stands where a case has no value.
        `passed` is whether no governing check is exceeded, `state` is 'done', 'failed' or 'open'.
        """
        paths = {"case": "/case/number"}
        paths.update({key: "/inputs/" + key.replace("/", "_") for key in self.inputs})
        paths["seed"] = "/case/seed"
        paths.update({name: "/outputs/" + name.replace("/", "_") for name in self.outputs})
        for name in ("passed", "governing", "utilisation", "state", "reason", "folder", "wall_time"):
            paths[name] = f"/case/{name}"
        there = {name: path for name, path in paths.items() if self._source.has(path)}
        return Table(list(there), lambda name: self._column(name, there[name]))

    def _column(self, name: str, path: str) -> Any:
        values, units, description, _, _ = self._source.dataset(path)
        number = self._source.dataset("/case/number")[0]
        if name == "passed":
            values = values.astype(bool)
        units = "1" if units == "-" else stored_unit(units)  # of words
        return labelled(values, name, ("case",), {"case": number}, units, description)

    def __len__(self) -> int:
        return len(self.table)

    def __iter__(self) -> Iterator[Record]:
        return iter(self.table)

    @property
    def failed(self) -> Records:
        """The rows of the cases without a solution; `reason` says why."""
        return self._in_state("failed")

    @property
    def open(self) -> Records:
        """The rows of the cases that have not been run yet."""
        return self._in_state("open")

    def _in_state(self, state: str) -> Records:
        if "state" not in self.table:
            return Records([])
        return Records([self.table[int(i)] for i in np.flatnonzero(self.table["state"].values == state)])

    def grid(self, result: str) -> Any:
        """A column of the table as a labelled array over the axes.

        Args:
            result: A gathered result or another column of the table.

        Returns:
            An array with a dimension by the key of every crossed axis, then `draw` where there is a sample and `seed`
            where there are several. Coordinates are the values of the axes [SI], or their words; those of axes that
            change together with another lie over its dimension. NaN where a case has no value.
        """
        if result not in self.table:
            raise KeyError(f"the study has no column '{result}'{nearest(result, self.table.keys())}")
        column = self.table[result]
        coords, beside = self._axes()
        array = labelled(np.asarray(column.values).reshape([len(values) for values in coords.values()]), result,
                         tuple(coords), coords, column.attrs["units"], column.attrs["description"])
        return _with_coords(array, beside)

    def _axes(self) -> tuple[dict[str, Any], dict[str, tuple[str, Any]]]:
        """Coordinates of the grid in its order, and those that lie over the dimension of another."""
        coords: dict[str, Any] = {}
        beside: dict[str, tuple[str, Any]] = {}
        for one in self._told["inputs"]:
            values = _axis_of(one)
            if one["with"]:
                beside[one["key"]] = (one["with"], values)
            elif not one["sampled"]:
                coords[one["key"]] = values
        seeds, cases = self._told["seeds"], len(self)
        crossed = int(np.prod([len(values) for values in coords.values()], dtype=int))
        draws = cases // (crossed * seeds)
        if any(one["sampled"] for one in self._told["inputs"]):
            coords["draw"] = np.arange(draws)
        if "seed" in self.table:
            coords["seed"] = self.table["seed"].values.reshape(-1, seeds).max(axis=0)
        return coords, beside

    @property
    def extremes(self) -> Table:
        """Extremes over the seeds: group, result, units, runs, mean, std, worst, and the most probable extreme of three
        hours by `gumbel` and `acer` with the ends of their 95 % confidence intervals (`gumbel_low`, ...); NaN where
        there are too few.
        """
        return table_of(self._source, "/extremes")

    @property
    def operability(self) -> "Optional[Operability]":
        """The limits that were looked for; None where the study looks for none."""
        told = self._told["operability"]
        return Operability(told) if told else None

    def case(self, number: int) -> Any:
        """The results of one case with all its files, which are solved from nothing where they are not there.

        Returns:
            StaticResults, DynamicResults or OperationResults, by the analysis.

        Raises:
            NoSolution: Where it has none.
        """
        from .opening import open as open_results

        folder = self._folder / str(self.table["folder"].values[number])
        if not (folder / "summary.json").is_file():
            if self._core is None:
                self._core = _core.Study.read(str(self._folder / "study.yaml")) if (
                    self._folder / "study.yaml").is_file() else None
            if self._core is None:
                raise ResultsError(f"case {number} has no files yet; {self.command} --case {number} makes them")
            folder = self._folder / self._core.run_case(str(self._folder), number)
        return open_results(folder)

    def save(self, folder: PathLike) -> pathlib.Path:
        """Copies all files into a folder that is new or empty."""
        return copied_folder(self._folder, folder)

    @property
    def plot(self) -> Any:
        """Figures with matplotlib: plot.curve(x, y), plot.map(result)."""
        from .plots import StudyPlots

        return StudyPlots(self)

    def __repr__(self) -> str:
        if self.operability is not None and not len(self):
            return f"<StudyResults of '{self.title}': limits of {self.operability.over}>"
        states = self.table["state"].values if len(self) else np.array([])
        return f"<StudyResults of '{self.title}': {int((states == 'done').sum())} of {len(self)} cases solved>"


class Operability:
    """Limits of operation: the largest value of one key with which a criterion holds, over all combinations of the
    others.

    Attributes:
        over: The key whose largest value is looked for.
        least, largest, resolution: Of the values tried [SI].
        cells: A group for each combination: at, limit, beyond, decided, governing, below, above, runs, reason.
        workability, forecast_workability: Fractions of the time in which the sea is below the limit: months, year, and
            outside, with seas outside of the chart; None without a scatter diagram. The second with alpha times the
            limit.
        remarks: What there is to say besides.
    """

    def __init__(self, told: Mapping[str, Any]):
        """Not for users: see StudyResults.operability."""
        self._told = told
        self.over: str = told["over"]
        self._unit = stored_unit(told["unit"])
        self.least, self.largest, self.resolution = (Number(told[name], self._unit)
                                                     for name in ("least", "largest", "resolution"))
        self.cells = Records([Record({"limit": None, **cell}, {"limit": self._unit}) for cell in told["cells"]])
        self.workability = _workability(told.get("workability"))
        self.forecast_workability = _workability(told.get("forecast_workability"))
        self.remarks: list[str] = told["remarks"]

    @property
    def limit(self) -> Any:
        """The largest value that passes, labelled over the other axes [SI]; NaN where not even the least does."""
        return self._over_axes("limit", np.nan, self._unit, f"Largest {self.over} that passes")

    @property
    def beyond(self) -> Any:
        """Where the largest value that was tried passes: the limit lies above it."""
        return self._over_axes("beyond", False, "1", "Whether the limit lies above the largest value")

    @property
    def decided(self) -> Any:
        """Where there is an answer."""
        return self._over_axes("decided", False, "1", "Whether the limit is decided")

    @property
    def governing(self) -> Any:
        """What is exceeded at the next value above the limit."""
        return self._over_axes("governing", "", "1", "What is exceeded above the limit")

    def _over_axes(self, name: str, otherwise: Any, units: str, description: str) -> Any:
        coords = {one["key"]: _axis_of(one) for one in self._told["axes"]}
        values = np.array([cell.get(name, otherwise) for cell in self._told["cells"]])
        shape = [len(axis) for axis in coords.values()]
        return labelled(values.reshape(shape), name, tuple(coords), coords, units, description)

    def __repr__(self) -> str:
        return f"<Operability: largest {self.over} over {len(self.cells)} cells, {self._told['runs']} analyses>"


def _workability(told: Optional[Mapping[str, Any]]) -> Optional[Record]:
    return Record(told, {"year": "1", "outside": "1"}) if told else None


def _axis_of(told: Mapping[str, Any]) -> Any:
    """The values of an axis with their unit [SI], or its words."""
    values = np.array(told["values"] if told["values"] else told["words"])
    return labelled(values, told["key"], (told["key"],), {}, stored_unit(told["unit"] or "1"), told["key"])


def _with_coords(array: Any, beside: Mapping[str, tuple[str, Any]]) -> Any:
    if hasattr(array, "assign_coords"):
        return array.assign_coords({key: (dim, np.asarray(values), values.attrs)
                                    for key, (dim, values) in beside.items()})
    array.coords.update({key: values for key, (_, values) in beside.items()})
    return array
