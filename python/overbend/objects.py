"""Results by object: lines, bodies, supports, the seabed, stages, the run."""

from __future__ import annotations

from typing import Any, Mapping

from . import _core
from .errors import ResultsError
from .groups import Record

_Values = Mapping[str, Any]


class Objects(Record):
    """Results by object, selected by name: `objects.lines['pipe'].static.lay_back`.

    The values are those of `summary['objects']`, with units and descriptions; `keys()` lists the names of a group.

    Attributes:
        lines: The laid pipe, 'pipe', mooring lines and other lines: `kind`, `static`, `dynamic`.
        bodies: 'vessel' and 'stinger': `static`, `dynamic`, as `bodies['vessel'].dynamic.surge.max`.
        supports: Roller boxes: `supports['stinger 3'].static.reaction`.
        seabed: The laid pipe on an uneven seabed, its contacts and free spans.
        stages: Stages of an operation: targets of each, and its own lines, bodies and supports.
        run: Settings, steps and energy: `run.static`, `run.dynamic`.
    """


def objects_in(summary: _Values, stage_units: _Values | None = None, stage_descriptions: _Values | None = None) -> Objects:
    """Results by object of a summary.

    Args:
        summary: Content of summary.json.
        stage_units: Units of the stage results that a single lay does not have, by stage name.
        stage_descriptions: Descriptions likewise.

    Raises:
        ResultsError: If an earlier version of the program, without results by object, wrote them.
    """
    if "objects" not in summary:
        raise ResultsError("the results have no values by object: an earlier version wrote them; analyse the model again")
    values = summary["objects"]
    return Objects(values, _in_place(values, _core.object_units(), stage_units or {}),
                   _in_place(values, _core.object_descriptions(), stage_descriptions or {}))


def _in_place(values: _Values, places: _Values, stages: _Values) -> dict[str, Any]:
    """Units or descriptions at the paths of the objects: of a line by its kind, of a support by "*"."""
    lines = {name: places["lines"][line["kind"]] for name, line in values.get("lines", {}).items()}
    supports = {name: places["supports"]["*"] for name in values.get("supports", {})}
    below = {name: {**stages.get(name, {}), **_in_place(stage, places, {})} for name, stage in values.get("stages", {}).items()}
    return {**places, "lines": lines, "supports": supports, "stages": below}
