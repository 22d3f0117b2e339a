"""Results that are there already."""

from __future__ import annotations

import json
import os
import pathlib
from typing import Any, Union

from .errors import ResultsError
from .results import ComparisonResults, DynamicResults, SeedsResults, StaticResults


def open(folder: Union[str, "os.PathLike[str]"]) -> Any:  # noqa: A001
    """The results in a folder that the command line or this package wrote.

    Returns:
        StaticResults, DynamicResults, SeedsResults, ComparisonResults, by what the folder holds.

    Raises:
        ResultsError: Where it holds none.
    """
    path = pathlib.Path(folder)
    path = path.parent if path.name in ("results.h5", "summary.json") else path
    if not (path / "summary.json").is_file():
        raise ResultsError(f"there are no results in '{path}'")
    summary = json.loads((path / "summary.json").read_text(encoding="utf-8"))
    if (path / "comparison.html").is_file():
        return ComparisonResults(path)
    if "seeds" in summary:
        return SeedsResults(path)
    if "dynamic" in summary:
        return DynamicResults(path)
    return StaticResults(None, None, path)
