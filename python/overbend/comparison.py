"""Comparison of folders of results."""

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
    """Compares folders of results, as `overbend compare` does; the first folder is the reference.

    Args:
        folders: Two or more folders of static or dynamic analyses, seeds or operations, or their results.h5. Folders of
            different kinds are compared on what they have in common.

    Raises:
        ResultsError: If a folder holds no results that can be compared.
    """
    places = [os.fspath(folder) for folder in folders]
    if len(places) < 2:
        raise ModelError(f"compare_folders: found {len(places)} folders of results, expected two or more")
    return FolderComparison(_core.FolderComparison(places))


class FolderComparison:
    """Comparison of several folders.

    Attributes:
        folders: Name, path, title, version, governing check and warnings of each.
        keys: Keys in which the models differ: key, values (empty if not given).
        results: Results, largest difference first: name, text, unit, key (True for key results), values [SI] (None if a
            folder has none), relative changes from the first folder.
        warnings: Findings not common to all folders: text, code, severity, has.
        notes: Results that are not compared, with the reason.
    """

    def __init__(self, core: "_core.FolderComparison"):
        """Not for users: see compare_folders()."""
        self._core = core
        content: dict[str, Any] = core.content()
        self.folders = Records([Record(folder) for folder in content["folders"]])
        self.keys = Records([Record({"name": key["key"], **key}) for key in content["keys"]])
        self.results = Records([_result(result) for result in content["results"]])
        self.warnings = Records([Record(warning) for warning in content["warnings"]])
        self.notes: list[str] = content["notes"]

    @property
    def table(self) -> Table:
        """One row per result: name, unit, one column per folder [SI], `change` from the first to the last folder."""
        rows = [result.to_dict() for result in self.results]
        columns: dict[str, Any] = {"name": [row["name"] for row in rows], "unit": [row["unit"] for row in rows]}
        for index, name in enumerate(self.folders.names()):
            columns[name] = np.array([row["values"][index] for row in rows], dtype=float)
        columns["change"] = np.array([row["changes"][-1] for row in rows], dtype=float)
        number = np.arange(len(rows))

        def column(name: str) -> Any:
            values = number if name == "row" else columns[name]
            units = "1" if name in ("row", "change") else "SI"
            return labelled(np.array(values), name, ("row",), {"row": number}, units, name)

        return Table(["row", *columns], column)

    def save(self, folder: PathLike) -> pathlib.Path:
        """Writes comparison.csv and comparison.html.

        Raises:
            ResultsError: If the folder cannot be written.
        """
        self._core.save(os.fspath(folder))
        return pathlib.Path(folder)

    def __repr__(self) -> str:
        return f"<FolderComparison of {', '.join(self.folders.names())}: {len(self.keys)} keys differ>"


def _result(result: dict[str, Any]) -> Record:
    values = result["values"]
    changes = [_change(value, values[0]) for value in values]
    return Record({**result, "unit": stored_unit(result["unit"]), "changes": changes})


def _change(value: Optional[float], first: Optional[float]) -> Optional[float]:
    return (value - first) / abs(first) if value is not None and first else None
