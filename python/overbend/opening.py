"""Reading of existing results."""

from __future__ import annotations

import os
import pathlib
from typing import Any, Union

from . import _core
from .dynamic_results import DynamicResults
from .errors import ResultsError
from .model import Model
from .operation import OperationResults
from .results import StaticResults, summary_in
from .runs import ComparisonResults, SeedsResults
from .studies import StudyResults


def open(folder: Union[str, "os.PathLike[str]"]) -> Any:  # noqa: A001
    """Opens a folder of results written by the command line or this package.

    Returns:
        StaticResults, DynamicResults, SeedsResults, ComparisonResults, OperationResults or StudyResults, depending on
        the folder. An unfinished study returns the cases solved so far.

    Raises:
        ResultsError: If there are no results, or they are damaged.
    """
    path = pathlib.Path(folder)
    path = path.parent if path.name in ("results.h5", "summary.json") else path
    try:
        return _opened(path)
    except (KeyError, TypeError, IndexError, AttributeError) as error:
        raise ResultsError(f"the results in '{path}' are damaged: {type(error).__name__}: {error}") from error


def _opened(path: pathlib.Path) -> Any:
    if (path / "study.json").is_file():
        return StudyResults(path)
    if (path / "comparison.json").is_file():
        return ComparisonResults(path)
    if not (path / "summary.json").is_file():
        raise ResultsError(f"there are no results in '{path}'")
    summary = summary_in(path)
    if "seeds" in summary:
        return SeedsResults(path)
    if "dynamic" in summary:
        return DynamicResults(path)
    if "operation" in summary and _core.has_operation(str(path / "results.h5")):
        core = _core.Operation.stored(str(path / "results.h5"))
        return OperationResults(core, Model(core.model))
    if "lay_table" in summary:
        raise ResultsError(f"'{path}' holds a lay table, which is read from lay-table.csv; model.lay_table() makes one")
    return StaticResults(None, None, path)
