"""Text of a study file from Python arguments."""

from __future__ import annotations

import os
from typing import Any, Mapping

from . import _core
from .errors import ModelError
from .keys import flow
from .seeking import conditions


def study_text(asked: Mapping[str, Any]) -> str:
    """A study file for model.yaml in the same folder.

    Args:
        asked: Arguments by name, None for omitted ones: axes, sample, seeds, analysis, gather, duration, operability, title,
            keep.
    """
    given = {name: value for name, value in asked.items() if value is not None}
    lines = ["overbend_study: 1", "base: model.yaml"]
    for name in ("title", "analysis", "duration", "keep", "seeds", "gather"):
        if name in given:
            lines.append(f"{name}: {flow(_PLAIN.get(name, _as_it_is)(given[name]), name)}")
    if "axes" in given:
        lines.append("axes:")
        lines += [f"  - {flow(_axis(key, values), key)}" for key, values in _mapping("axes", given["axes"]).items()]
    if "sample" in given:
        lines += _sample_lines(_mapping("sample", given["sample"]))
    if "operability" in given:
        lines.append(f"operability: {flow(_operability(_mapping('operability', given['operability'])), 'operability')}")
    return "\n".join(lines) + "\n"


def _as_it_is(value: Any) -> Any:
    return value


def _seconds(value: Any) -> Any:
    return value if isinstance(value, str) else f"{float(value)!r} s"


def _list(value: Any) -> Any:
    return [value] if isinstance(value, str) else list(value)


def _seeds(value: Any) -> Any:
    return value if isinstance(value, int) else [int(seed) for seed in value]


_PLAIN = {"duration": _seconds, "gather": _list, "seeds": _seeds}


def _mapping(name: str, value: Any) -> Mapping[str, Any]:
    if isinstance(value, Mapping):
        return value
    raise ModelError(f"{name}: found {value!r}, expected a dict")


def _axis(key: str, values: Any) -> dict[str, Any]:
    if isinstance(values, Mapping):
        return {"key": key, **{name.rstrip("_"): value for name, value in values.items()}}
    if isinstance(values, str):
        raise ModelError(f"axes: {key}: found {values!r}, expected a list of values, or a dict with from, to and steps")
    return {"key": key, "values": list(values)}


def _sample_lines(sample: Mapping[str, Any]) -> list[str]:
    """The group `sample` in several lines, because keys of the model may need quotes."""
    lines = ["sample:"]
    for name, value in sample.items():
        if name != "keys":
            lines.append(f"  {name}: {flow(value, name)}")
            continue
        lines.append("  keys:")
        for key, drawn in _mapping("sample: keys", value).items():
            named = {name.rstrip("_"): setting for name, setting in _mapping(f"sample: {key}", drawn).items()}
            lines.append(f"    {_core.flow_scalar(key)}: {flow(named, key)}")
    return lines


def _operability(operability: Mapping[str, Any]) -> dict[str, Any]:
    wanted = dict(operability)
    if isinstance(wanted.get("criterion"), Mapping):
        criterion = dict(wanted["criterion"])
        checks = ["checks"] if criterion.pop("checks", False) else []
        wanted["criterion"] = [*checks, *conditions(criterion)]
    if "scatter" in wanted:  # relative paths start from the study file's folder
        wanted["scatter"] = os.path.abspath(os.fspath(wanted["scatter"]))
    return wanted
