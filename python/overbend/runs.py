"""Several runs of one model side by side: seeds, and variants."""

from __future__ import annotations

import functools
import os
import pathlib
from typing import TYPE_CHECKING, Any, Iterator, Optional, Union

import numpy as np

from .findings import findings_of
from .groups import Record, Records, Table, wrapped
from .dynamic_results import DynamicResults
from .results import copied_folder, summary_in
from .values import labelled

if TYPE_CHECKING:
    from .model import Model

PathLike = Union[str, "os.PathLike[str]"]


class _RunsInFolders:
    """Several runs in folders of their own below one."""

    _file = "summary.json"

    def __init__(self, folder: pathlib.Path, model: "Optional[Model]" = None, holder: Any = None):
        """Not for users: see Model.seeds(), Model.compare() and overbend.open()."""
        self._folder, self._model, self._holder = folder, model, holder
        self.summary: dict[str, Any] = summary_in(folder, self._file)

    @property
    def folder(self) -> pathlib.Path:
        """Where the results are."""
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
        """Copies all files into a folder that is new or empty."""
        return copied_folder(self._folder, folder)


class SeedsResults(_RunsInFolders):
    """Runs of several seeds: `results[3]` is the DynamicResults of seed 3, `len(results)` how many are finished.

    Attributes:
        summary: What they give together, as summary.json.
        failed: Runs that ended without results: seed, why.
        findings: Of all together; each run has its own. warnings are their messages.
    """

    def __init__(self, folder: pathlib.Path, model: "Optional[Model]" = None, holder: Any = None):
        """Not for users: see Model.seeds() and overbend.open()."""
        super().__init__(folder, model, holder)
        self._told: dict[str, Any] = self.summary["seeds"]
        self.failed = Records([Record(one) for one in self._told["failed"]])
        self.findings = findings_of(self._told["findings"])
        self.warnings: list[str] = self._told["warnings"]

    @property
    def seeds(self) -> list[int]:
        """The seeds whose runs are finished, in the order that they were given in."""
        return [run["seed"] for run in self._told["runs"]]

    def __getitem__(self, seed: int) -> DynamicResults:
        return self._run(f"seed-{seed}")

    def __iter__(self) -> Iterator[DynamicResults]:
        return (self[seed] for seed in self.seeds)

    def __len__(self) -> int:
        return len(self.seeds)

    @property
    def table(self) -> Table:
        """A row for each finished run: `seed`, and the key results of seeds.csv [SI]."""
        return _table_of_runs(self._told["runs"], "seed", self._told["statistics"])

    @functools.cached_property
    def statistics(self) -> Record:
        """By key result over the seeds: mean, std, min, max, and `gumbel` and `acer` with the most probable extreme of
        three hours (`estimate`, and `low` and `high` of its 95 % confidence interval); None where there are too few.
        """
        quantities = self._told["statistics"]
        return Record({name: _statistics(one) for name, one in quantities.items()},
                      {name: _same_units(one, one["units"]) for name, one in quantities.items()})

    def values(self, name: str) -> Any:
        """A result of every seed, by its name as goal seek has it: 'dynamic.top_tension.max'; labelled over seed."""
        found = [self[seed][name] for seed in self.seeds]
        units = found[0].units if found else "1"
        values = np.array([float(value) for value in found])
        return labelled(values, name, ("seed",), {"seed": np.array(self.seeds)}, units)

    def __repr__(self) -> str:
        return f"<SeedsResults of '{self.title}': {len(self)} runs, {len(self.failed)} failed>"


class ComparisonResults(_RunsInFolders):
    """Variants of a model in one sea: `results['off']` is the DynamicResults of one.

    Attributes:
        summary: The content of comparison.json.
        of: 'tensioner', 'contact' or 'impacts'.
        variants: The names of the variants.
    """

    _file = "comparison.json"

    def __init__(self, folder: pathlib.Path, model: "Optional[Model]" = None, holder: Any = None):
        """Not for users: see Model.compare() and overbend.open()."""
        super().__init__(folder, model, holder)
        self._told: dict[str, Any] = self.summary["comparison"]
        self.of: str = self._told["of"]
        self.variants: list[str] = [variant["name"] for variant in self._told["variants"]]

    def __getitem__(self, variant: str) -> DynamicResults:
        return self._run(variant)

    def __iter__(self) -> Iterator[str]:
        return iter(self.variants)

    def __len__(self) -> int:
        return len(self.variants)

    @property
    def table(self) -> Table:
        """A row for each variant: `variant`, and the key results of comparison.csv [SI]."""
        runs = [{"variant": variant["name"], **variant} for variant in self._told["variants"]]
        return _table_of_runs(runs, "variant", self._told["quantities"])

    @property
    def supports(self) -> Records:
        """Of a comparison of contact, what each box saw in each variant: `supports['stinger 3'].flat.peak_force`."""
        return wrapped(self._told.get("supports", [])) or Records([])

    def __repr__(self) -> str:
        return f"<ComparisonResults of '{self.title}': {', '.join(self.variants)}>"


def _table_of_runs(runs: list[dict[str, Any]], key: str, quantities: dict[str, Any]) -> Table:
    """A row for each run; quantities have units and description by their names."""
    place = np.array([run[key] for run in runs])

    def column(name: str) -> Any:
        if name == key:
            return labelled(place, key, (key,), {key: place}, "1", key)
        values = np.array([np.nan if run[name] is None else run[name] for run in runs], dtype=float)
        told = quantities[name]
        return labelled(values, name, (key,), {key: place}, told["units"], told["description"])

    return Table([key, *quantities], column)


def _statistics(told: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in told.items() if name not in ("units", "description")}


def _same_units(told: dict[str, Any], units: str) -> dict[str, Any]:
    """The unit in the place of every number."""
    return {name: _same_units(value, units) if isinstance(value, dict) else units
            for name, value in told.items() if name not in ("order", "peaks")}
