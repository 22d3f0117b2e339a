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
from .findings import make_findings
from .groups import Record, Records, Table, make_table, nearest
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
    """Solves many cases of a model on all cores: keys crossed, varied together or sampled at random.

        ob.study(model, axes={'tensioner.tension': ['200 kN', '250 kN', '300 kN'],
                              'environment.water_depth': {'from': '80 m', 'to': '100 m', 'step': '5 m'}},
                 gather=['static.lay_back', 'static.sagbend.max_bending_stress'])

    A failed case does not stop the others. Releases the GIL. After Ctrl-C, a kill or a power failure, a second call with the
    same `out` continues where the first ended, and so does `overbend study OUT/study.yaml -o OUT`.

    Args:
        study: The model, or the path of a study file, which then replaces all arguments up to `keep`.
        axes: Values by key of the model: a list of values as in with_(), or a dict with from, to and step or steps. Every
            value is combined with every value of the other axes; {'values': [...], 'with': KEY} varies together with the
            axis of that key.
        sample: Keys sampled by a Latin hypercube: {'count': 200, 'seed': 1, 'keys': {KEY: {'distribution': 'normal',
            'mean': '250 kN', 'std': '5 kN'}}}.
        seeds: Seeds of the waves, or their number; every case is run with each. Dynamic analyses only.
        analysis: 'static' (default), 'dynamic', 'operation' or 'seek'.
        gather: Results named as in summary.json; a default set for the analysis if omitted.
        duration: Duration of dynamic analyses instead of the model's: '600 s' or a number of seconds.
        operability: Finds the largest value of one axis at which a criterion holds: {'over': KEY, 'resolution':
            '0.25 m', 'criterion': {'dynamic.top_tension.max': '<= 350 kN'}, 'scatter': FILE, 'alpha': 0.8}. Without a
            criterion every governing check must be passed; {'checks': True, ...} in it requires both.
        title: Title of tables and report.
        keep: True to keep all result files of every case.
        out: Folder for the results. If omitted: a temporary folder, deleted together with the results object; its save()
            keeps the files.
        threads: Number of parallel cases; 0: one per core.
        retry_failed: Repeats cases that failed before.
        checkpoint: Time between checkpoints of dynamic analyses [s].
        progress: True for a line on the terminal, or a function (see progress.CaseProgress), called ten times a second.

    Raises:
        ModelError: If the input has errors, with file (OUT/study.yaml), line and key of each.
        ResultsError: If the folder holds another study, or cannot be written.
        Interrupted: After Ctrl-C, with the folder from which the study can be resumed.
    """
    asked = {"axes": axes, "sample": sample, "seeds": seeds, "analysis": analysis, "gather": gather,
             "duration": duration, "operability": operability, "title": title, "keep": keep or None}
    holder = TemporaryFolder() if out is None else None
    folder = holder.path / "study" if holder else pathlib.Path(os.fspath(out))  # type: ignore[arg-type]
    core = _make_core_study(study, asked, folder)
    report, end = follower(progress, Cases)
    try:
        interrupted = core.run(str(folder), threads=threads, retry_failed=retry_failed, checkpoint=checkpoint,
                               progress=report)
    finally:
        end()
    if interrupted:
        if holder is not None:
            holder.keep()
        raise Interrupted(f"interrupted; the same call with out='{folder}' resumes it", folder)
    results = StudyResults(folder, core, holder)
    failed = len(results.failed)
    if failed:
        sentence = f"{failed} of {len(results)} cases have no solution: see `failed` of the results"
        python_warnings.warn(sentence, stacklevel=2)
    return results


def _make_core_study(study: Study, asked: Mapping[str, Any], folder: pathlib.Path) -> "_core.Study":
    if isinstance(study, Model):
        return _core.Study.of(study._core, study_text(asked), str(folder))
    given = [name for name, value in asked.items() if value is not None]
    if given:
        raise ModelError(f"{given[0]}: given in addition to a study file, expected in the file: '{os.fspath(study)}'")
    return _core.Study.read(os.fspath(study))


class StudyResults:
    """Results of a study.

    Attributes:
        title: Title of the study.
        analysis: 'static', 'dynamic', 'operation' or 'seek'.
        findings: Findings; `warnings` are their messages.
        assumptions: Assumptions of the analyses.
        command: Command line of the study.
    """

    def __init__(self, folder: pathlib.Path, core: "Optional[_core.Study]" = None, holder: Any = None):
        """Not for users: see study() and overbend.open()."""
        self._folder, self._core, self._holder = folder, core, holder
        tables = _core.StudyTables(str(folder))
        self._source = tables.tree()
        self._content: dict[str, Any] = tables.content()
        self.title: str = self._content["title"]
        self.analysis: str = self._content["analysis"]
        self.findings = make_findings(self._content["findings"])
        self.warnings: list[str] = self._content["warnings"]
        self.assumptions: list[str] = self._content["assumptions"]
        self.command: str = self._content["command"]

    @property
    def folder(self) -> pathlib.Path:
        """Folder of study.csv, study.xlsx, study.h5, report.html and the records of the cases."""
        return self._folder

    @property
    def inputs(self) -> list[str]:
        """Keys that vary from case to case."""
        return [axis["key"] for axis in self._content["inputs"]]

    @property
    def outputs(self) -> list[str]:
        """Gathered results."""
        return [output["name"] for output in self._content["outputs"]]

    @functools.cached_property
    def table(self) -> Table:
        """One row per case: inputs, seed, outputs [SI], passed, governing, utilisation, state, reason, folder, wall_time.

        Columns have the names of keys and results: table['tensioner.tension']. Missing values are NaN. `passed` is True if
        no governing check is exceeded, `state` is 'done', 'failed' or 'open'.
        """
        paths = {"case": "/case/number"}
        paths.update({key: "/inputs/" + key.replace("/", "_") for key in self.inputs})
        paths["seed"] = "/case/seed"
        paths.update({name: "/outputs/" + name.replace("/", "_") for name in self.outputs})
        for name in ("passed", "governing", "utilisation", "state", "reason", "folder", "wall_time"):
            paths[name] = f"/case/{name}"
        present = {name: path for name, path in paths.items() if self._source.has(path)}
        return Table(list(present), lambda name: self._column(name, present[name]))

    def _column(self, name: str, path: str) -> Any:
        values, units, description, _, _ = self._source.dataset(path)
        number = self._source.dataset("/case/number")[0]
        if name == "passed":
            values = values.astype(bool)
        units = "1" if units == "-" else stored_unit(units)  # names
        return labelled(values, name, ("case",), {"case": number}, units, description)

    def __len__(self) -> int:
        return len(self.table)

    def __iter__(self) -> Iterator[Record]:
        return iter(self.table)

    @property
    def failed(self) -> Records:
        """Rows of the cases without a solution, with the `reason`."""
        return self._in_state("failed")

    @property
    def open(self) -> Records:
        """Rows of the cases that have not been run yet."""
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
            An array with one dimension per crossed axis, named by its key, then `draw` for a sample and `seed` for several
            seeds. Coordinates are the values of the axes [SI], or their names; those of an axis that varies together with
            another use its dimension. Missing values are NaN.
        """
        if result not in self.table:
            raise KeyError(f"the study has no column '{result}'{nearest(result, self.table.keys())}")
        column = self.table[result]
        coords, dependent = self._axes()
        array = labelled(np.asarray(column.values).reshape([len(values) for values in coords.values()]), result,
                         tuple(coords), coords, column.attrs["units"], column.attrs["description"])
        return _with_coords(array, dependent)

    def _axes(self) -> tuple[dict[str, Any], dict[str, tuple[str, Any]]]:
        """Coordinates of the grid in order, and those that use the dimension of another axis."""
        coords: dict[str, Any] = {}
        dependent: dict[str, tuple[str, Any]] = {}
        for axis in self._content["inputs"]:
            values = _axis_values(axis)
            if axis["with"]:
                dependent[axis["key"]] = (axis["with"], values)
            elif not axis["sampled"]:
                coords[axis["key"]] = values
        seeds, cases = self._content["seeds"], len(self)
        crossed = int(np.prod([len(values) for values in coords.values()], dtype=int))
        draws = cases // (crossed * seeds)
        if any(axis["sampled"] for axis in self._content["inputs"]):
            coords["draw"] = np.arange(draws)
        if "seed" in self.table:
            coords["seed"] = self.table["seed"].values.reshape(-1, seeds).max(axis=0)
        return coords, dependent

    @property
    def extremes(self) -> Table:
        """Extremes across seeds: group, result, units, runs, mean, std, worst, and the most probable three-hour extreme by
        `gumbel` and `acer` with their 95 % confidence intervals (`gumbel_low`, ...); NaN if there are too few seeds.
        """
        return make_table(self._source, "/extremes")

    @property
    def operability(self) -> "Optional[Operability]":
        """Operability limits; None if the study does not search for any."""
        limits = self._content["operability"]
        return Operability(limits) if limits else None

    def case(self, number: int) -> Any:
        """Results of one case with all its files; solves the case from scratch if they do not exist.

        Returns:
            StaticResults, DynamicResults or OperationResults, depending on the analysis.

        Raises:
            NoSolution: If the case has no solution.
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
        """Copies all files into a new or empty folder."""
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
    """Operability limits: the largest value of one key at which a criterion holds, for all combinations of the others.

    Attributes:
        over: The key whose largest value is sought.
        least, largest, resolution: Smallest and largest value tried, and the resolution [SI].
        cells: One group per combination: at, limit, beyond, decided, governing, below, above, runs, reason.
        workability, forecast_workability: Fractions of time in which the sea is below the limit: months, year, and
            outside for seas outside the chart; None without a scatter diagram. The second uses alpha times the limit.
        remarks: Further remarks.
    """

    def __init__(self, content: Mapping[str, Any]):
        """Not for users: see StudyResults.operability."""
        self._content = content
        self.over: str = content["over"]
        self._unit = stored_unit(content["unit"])
        self.least, self.largest, self.resolution = (Number(content[name], self._unit)
                                                     for name in ("least", "largest", "resolution"))
        self.cells = Records([Record({"limit": None, **cell}, {"limit": self._unit}) for cell in content["cells"]])
        self.workability = _workability(content.get("workability"))
        self.forecast_workability = _workability(content.get("forecast_workability"))
        self.remarks: list[str] = content["remarks"]

    @property
    def limit(self) -> Any:
        """Largest value that passes, labelled over the other axes [SI]; NaN if not even the smallest passes."""
        return self._over_axes("limit", np.nan, self._unit, f"Largest {self.over} that passes")

    @property
    def beyond(self) -> Any:
        """True where the largest value tried passes: the limit is above it."""
        return self._over_axes("beyond", False, "1", "True if the limit is above the largest value tried")

    @property
    def decided(self) -> Any:
        """True where the limit is decided."""
        return self._over_axes("decided", False, "1", "True if the limit is decided")

    @property
    def governing(self) -> Any:
        """Criterion exceeded at the next value above the limit."""
        return self._over_axes("governing", "", "1", "Criterion exceeded above the limit")

    def _over_axes(self, name: str, otherwise: Any, units: str, description: str) -> Any:
        coords = {axis["key"]: _axis_values(axis) for axis in self._content["axes"]}
        values = np.array([cell.get(name, otherwise) for cell in self._content["cells"]])
        shape = [len(axis) for axis in coords.values()]
        return labelled(values.reshape(shape), name, tuple(coords), coords, units, description)

    def __repr__(self) -> str:
        return f"<Operability: largest {self.over} over {len(self.cells)} cells, {self._content['runs']} analyses>"


def _workability(content: Optional[Mapping[str, Any]]) -> Optional[Record]:
    return Record(content, {"year": "1", "outside": "1"}) if content else None


def _axis_values(axis: Mapping[str, Any]) -> Any:
    """Values of an axis with their unit [SI], or their names."""
    values = np.array(axis["values"] if axis["values"] else axis["words"])
    return labelled(values, axis["key"], (axis["key"],), {}, stored_unit(axis["unit"] or "1"), axis["key"])


def _with_coords(array: Any, dependent: Mapping[str, tuple[str, Any]]) -> Any:
    if hasattr(array, "assign_coords"):
        return array.assign_coords({key: (dim, np.asarray(values), values.attrs)
                                    for key, (dim, values) in dependent.items()})
    array.coords.update({key: values for key, (_, values) in dependent.items()})
    return array
