"""Lay tables: tension, lay-back or depth in steps, or the points of a route."""

from __future__ import annotations

import os
import pathlib
from typing import TYPE_CHECKING, Any, Callable, Iterator, Optional, Sequence, Union

import numpy as np

from . import _core
from .errors import ModelError
from .findings import make_findings
from .groups import Record, Table, make_table
from .keys import bound
from .values import labelled

if TYPE_CHECKING:
    from .model import Model

PathLike = Union[str, "os.PathLike[str]"]

#: Called with the number of rows done and requested.
RowProgress = Callable[[int, int], object]


class LayTable:
    """A static solution in each row, with additional rows for the smallest and largest value of the varied quantity at which
    all checks are passed.

    Attributes:
        table: Table over `index`: kind ('step', 'least', 'largest'), the varied quantity, depth [m], top_tension,
            bottom_tension [N], lay_back [m], departure_angle [rad], stinger_tip_clearance [m], stresses [Pa], strains,
            largest_reaction [N], utilisation, worst_check, verdict ('passed', 'reserved', 'exceeded', 'no lay') and reason; NaN
            without a solution.
        vary: 'tension', 'lay_back', 'depth' or 'route'.
        findings: Findings; `warnings` are their messages.
        assumptions: Assumptions of the analysis.
        summary: Content of summary.json.
    """

    def __init__(self, core: "_core.LayTable", model: "Model"):
        """Not for users: see Model.lay_table()."""
        self._core, self.model = core, model
        self.summary: dict[str, Any] = core.summary()
        self.vary: str = self.summary["lay_table"]["vary"]
        self.findings = make_findings(self.summary["findings"])
        self.warnings: list[str] = self.summary["warnings"]
        self.assumptions: list[str] = self.summary["assumptions"]
        self.table: Table = make_table(core.tree(), "/lay_table")

    @property
    def least(self) -> Optional[Record]:
        """Row of the smallest value at which every governing check is passed; None if there is none."""
        return self._limit("least")

    @property
    def largest(self) -> Optional[Record]:
        """Row of the largest value at which every governing check is passed; None if there is none."""
        return self._limit("largest")

    @property
    def steps(self) -> Table:
        """The requested rows, without the limits."""
        chosen = np.flatnonzero(self.table["kind"].values == "step")
        place = np.arange(len(chosen))

        def column(name: str) -> Any:
            whole = self.table.column(name)
            values = place if name == "index" else np.asarray(whole.values)[chosen]
            attrs = whole.attrs
            return labelled(values, name, ("index",), {"index": place}, attrs["units"], attrs["description"])

        return Table(self.table.keys(), column)

    def _limit(self, kind: str) -> Optional[Record]:
        rows = np.flatnonzero((self.table["kind"].values == kind) & (self.table["verdict"].values != "no lay"))
        return self.table[int(rows[0])] if len(rows) else None

    def __getitem__(self, name: Any) -> Any:
        return self.table[name]

    def __iter__(self) -> Iterator[Record]:
        return iter(self.table)

    def __len__(self) -> int:
        return len(self.table)

    def save(self, folder: PathLike) -> pathlib.Path:
        """Writes lay-table.csv, lay-table.xlsx, summary.json and report.html.

        Raises:
            ResultsError: If the folder cannot be written.
        """
        self._core.save(os.fspath(folder))
        return pathlib.Path(folder)

    def __repr__(self) -> str:
        return f"<LayTable of {self.vary}: {len(self)} rows>"


def lay_table(model: "Model", vary: Optional[str], from_: Optional[str], to: Optional[str], step: Optional[str],
              steps: Optional[int], depths: Any, least: bool, progress: Optional[RowProgress]) -> LayTable:
    """See Model.lay_table()."""
    if (from_ is None) != (to is None):
        raise ModelError("lay_table: from_ and to are given together or not at all")
    if step is not None and (steps is not None or from_ is None):
        raise ModelError("lay_table: step goes with from_ and to, and without steps")
    unit = "N" if (vary or "tension") == "tension" else "m"
    usual = "kN" if unit == "N" else "m"
    from_, to, step = (None if value is None else bound(value, f"lay_table: {name}", usual)
                       for name, value in (("from_", from_), ("to", to), ("step", step)))
    if step is not None:
        steps = _whole_steps(str(from_), str(to), step, unit)
    range_ = f"{from_}..{to}" if from_ is not None else ""
    if steps is not None:
        if not range_:
            raise ModelError("lay_table: steps go with from_ and to")
        range_ += f"/{steps}"
    files = depths is not None and isinstance(depths, (str, os.PathLike))
    profile = [] if depths is None or files else [(float(distance), float(depth)) for distance, depth in depths]
    core = _core.LayTable(model._core, vary=vary or "", range=range_, depths=os.fspath(depths) if files else "",
                          profile=profile, least=least, progress=progress)
    return LayTable(core, model)


def _whole_steps(low: str, high: str, step: str, unit: str) -> int:
    whole = (_core.quantity(high, unit) - _core.quantity(low, unit)) / _core.quantity(step, unit)
    if whole < 0.5 or abs(whole - round(whole)) > 1e-6 * whole:
        raise ModelError(f"lay_table: found the step '{step}', expected one that leads from '{low}' to '{high}'")
    return round(whole)


Depths = Union[PathLike, Sequence[Sequence[float]], None]
