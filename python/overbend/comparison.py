"""Folders of results beside each other."""

from __future__ import annotations

import os
import pathlib
from typing import Any, Iterable, Optional, Union

import numpy as np

from . import _core
from .errors import ModelError
from .groups import Record, Records, Table
from .values import labelled, stored_unit

PathLike = Union[str, "os.PathLike[str]"]


def compare_folders(folders: Iterable[PathLike]) -> "FolderComparison":
    """Compares results that are in folders, as `overbend compare` does; the first is what the others are compared with.

    Args:
        folders: Two or more folders of static or dynamic analyses, seeds or operations, or their results.h5. Mixtures
            are compared on what they share.

    Raises:
        ResultsError: Where one holds no results that can be compared.
    """
    places = [os.fspath(folder) for folder in folders]
    if len(places) < 2:
        raise ModelError(f"compare_folders: found {len(places)} folders of results, expected two or more")
    return FolderComparison(_core.FolderComparison(places))


class FolderComparison:
    """Results of several folders beside each other.

    Attributes:
        folders: name, path, title, version, governing and warnings of each.
        keys: Keys of the models that not all have alike: key, values (empty where not given).
        results: Results, those that differ most first: name, text, unit, key (whether it is looked at first), values
            [SI], None where a folder has none, changes against the first in parts of it.
        warnings: Findings that not all have: text, code, severity, has.
        notes: What is not compared and why.
    """

    def __init__(self, core: "_core.FolderComparison"):
        """Not for users: see compare_folders()."""
        self._core = core
        told: dict[str, Any] = core.told()
        self.folders = Records([Record(one) for one in told["folders"]])
        self.keys = Records([Record({"name": one["key"], **one}) for one in told["keys"]])
        self.results = Records([_result(one) for one in told["results"]])
        self.warnings = Records([Record(one) for one in told["warnings"]])
        self.notes: list[str] = told["notes"]

    @property
    def table(self) -> Table:
        """A row for each result: name, unit, a column for each folder [SI], `change` of the last against the first."""
        rows = [one.to_dict() for one in self.results]
        columns: dict[str, Any] = {"name": [one["name"] for one in rows], "unit": [one["unit"] for one in rows]}
        for index, name in enumerate(self.folders.names()):
            columns[name] = np.array([one["values"][index] for one in rows], dtype=float)
        columns["change"] = np.array([one["changes"][-1] for one in rows], dtype=float)
        number = np.arange(len(rows))

        def column(name: str) -> Any:
            values = number if name == "row" else columns[name]
            units = "1" if name in ("row", "change") else "SI"
            return labelled(np.array(values), name, ("row",), {"row": number}, units, name)

        return Table(["row", *columns], column)

    def save(self, folder: PathLike) -> pathlib.Path:
        """Writes comparison.csv and comparison.html.

        Raises:
            ResultsError: Where the folder cannot be written.
        """
        self._core.save(os.fspath(folder))
        return pathlib.Path(folder)

    def __repr__(self) -> str:
        return f"<FolderComparison of {', '.join(self.folders.names())}: {len(self.keys)} keys differ>"


def _result(told: dict[str, Any]) -> Record:
    values = told["values"]
    changes = [_change(value, values[0]) for value in values]
    return Record({**told, "unit": stored_unit(told["unit"]), "changes": changes})


def _change(value: Optional[float], first: Optional[float]) -> Optional[float]:
    return (value - first) / abs(first) if value is not None and first else None
