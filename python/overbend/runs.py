"""Sets of runs of one model: seeds and variants."""

from __future__ import annotations

import functools
import os
import pathlib
from typing import TYPE_CHECKING, Any, Iterator, Optional, Union

import numpy as np

from .findings import make_findings
from .groups import Record, Records, Table, wrapped
from .dynamic_results import DynamicResults
from .results import copied_folder, summary_in
from .values import labelled

if TYPE_CHECKING:
    from .model import Model

PathLike = Union[str, "os.PathLike[str]"]


class _RunsInFolders:
    """Several runs in subfolders of one folder."""

    _file = "summary.json"

    def __init__(self, folder: pathlib.Path, model: "Optional[Model]" = None, holder: Any = None):
        """Not for users: see Model.seeds(), Model.compare() and overbend.open()."""
        self._folder, self._model, self._holder = folder, model, holder
        self.summary: dict[str, Any] = summary_in(folder, self._file)

    @property
    def folder(self) -> pathlib.Path:
        """Folder of the results."""
        return self._folder

    @property
    def title(self) -> str:
        """Title of the model."""
        return str(self.summary.get("title", ""))

    def _run(self, name: str) -> DynamicResults:
        if not (self._folder / name / "results.h5").is_file():
            raise KeyError(f"there is no finished run '{name}' in '{self._folder}'")
        return DynamicResults(self._folder / name, None, self._holder)

    def save(self, folder: PathLike) -> pathlib.Path:
        """Copies all files into a new or empty folder."""
        return copied_folder(self._folder, folder)


class SeedsResults(_RunsInFolders):
    """Runs of several seeds: `results[3]` is the DynamicResults of seed 3, `len(results)` the number of finished runs.

    Attributes:
        summary: Content of summary.json.
        failed: Runs without results: seed, why.
        findings: Merged findings; each run has its own. `warnings` are their messages.
    """

    def __init__(self, folder: pathlib.Path, model: "Optional[Model]" = None, holder: Any = None):
        """Not for users: see Model.seeds() and overbend.open()."""
        super().__init__(folder, model, holder)
        self._content: dict[str, Any] = self.summary["seeds"]
        self.failed = Records([Record(run) for run in self._content["failed"]])
        self.findings = make_findings(self._content["findings"])
        self.warnings: list[str] = self._content["warnings"]

    @property
    def seeds(self) -> list[int]:
        """Seeds of the finished runs, in the given order."""
        return [run["seed"] for run in self._content["runs"]]

    def __getitem__(self, seed: int) -> DynamicResults:
        return self._run(f"seed-{seed}")

    def __iter__(self) -> Iterator[DynamicResults]:
        return (self[seed] for seed in self.seeds)

    def __len__(self) -> int:
        return len(self.seeds)

    @property
    def table(self) -> Table:
        """One row per finished run: `seed`, and the key results of seeds.csv [SI]."""
        return _table_of_runs(self._content["runs"], "seed", self._content["statistics"])

    @functools.cached_property
    def statistics(self) -> Record:
        """Statistics across seeds by key result: mean, std, min, max, and `gumbel` and `acer` with the most probable three-hour
        extreme (`estimate`) and its 95 % confidence interval (`low`, `high`); None if there are too few.
        """
        quantities = self._content["statistics"]
        return Record({name: _statistics(quantity) for name, quantity in quantities.items()},
                      {name: _same_units(quantity, quantity["units"]) for name, quantity in quantities.items()})

    def values(self, name: str) -> Any:
        """A result of every seed by its path, such as 'dynamic.top_tension.max'; labelled over seed."""
        found = [self[seed][name] for seed in self.seeds]
        units = found[0].units if found else "1"
        values = np.array([float(value) for value in found])
        return labelled(values, name, ("seed",), {"seed": np.array(self.seeds)}, units)

    def __repr__(self) -> str:
        return f"<SeedsResults of '{self.title}': {len(self)} runs, {len(self.failed)} failed>"


class ComparisonResults(_RunsInFolders):
    """Variants of a model in one sea: `results['off']` is the DynamicResults of a variant.

    Attributes:
        summary: Content of comparison.json.
        of: 'tensioner', 'contact' or 'impacts'.
        variants: Names of the variants.
    """

    _file = "comparison.json"

    def __init__(self, folder: pathlib.Path, model: "Optional[Model]" = None, holder: Any = None):
        """Not for users: see Model.compare() and overbend.open()."""
        super().__init__(folder, model, holder)
        self._content: dict[str, Any] = self.summary["comparison"]
        self.of: str = self._content["of"]
        self.variants: list[str] = [variant["name"] for variant in self._content["variants"]]

    def __getitem__(self, variant: str) -> DynamicResults:
        return self._run(variant)

    def __iter__(self) -> Iterator[str]:
        return iter(self.variants)

    def __len__(self) -> int:
        return len(self.variants)

    @property
    def table(self) -> Table:
        """One row per variant: `variant`, and the key results of comparison.csv [SI]."""
        runs = [{"variant": variant["name"], **variant} for variant in self._content["variants"]]
        return _table_of_runs(runs, "variant", self._content["quantities"])

    @property
    def supports(self) -> Records:
        """For a comparison of contact models, results of each box in each variant: `supports['stinger 3'].flat.peak_force`."""
        return wrapped(self._content.get("supports", [])) or Records([])

    def __repr__(self) -> str:
        return f"<ComparisonResults of '{self.title}': {', '.join(self.variants)}>"


def _table_of_runs(runs: list[dict[str, Any]], key: str, quantities: dict[str, Any]) -> Table:
    """One row per run; quantities have units and description by name."""
    place = np.array([run[key] for run in runs])

    def column(name: str) -> Any:
        if name == key:
            return labelled(place, key, (key,), {key: place}, "1", key)
        values = np.array([np.nan if run[name] is None else run[name] for run in runs], dtype=float)
        quantity = quantities[name]
        return labelled(values, name, (key,), {key: place}, quantity["units"], quantity["description"])

    return Table([key, *quantities], column)


def _statistics(quantity: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in quantity.items() if name not in ("units", "description")}


def _same_units(values: dict[str, Any], units: str) -> dict[str, Any]:
    """The same structure with the unit in place of every number."""
    return {name: _same_units(value, units) if isinstance(value, dict) else units
            for name, value in values.items() if name not in ("order", "peaks")}
