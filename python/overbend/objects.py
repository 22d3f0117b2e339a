"""Results by object: lines, bodies, supports, the seabed, stages, the run."""

from __future__ import annotations

from typing import Any, Mapping

from . import _core
from .errors import ResultsError
from .groups import Record

_Values = Mapping[str, Any]


class Objects(Record):
    """Results by object, each an entry by its name: `objects.lines['pipe'].static.lay_back`.

    The values are those of `summary['objects']`, with units and descriptions; `keys()` lists the names of a group.

    Attributes:
        lines: The laid pipe, 'pipe', mooring lines and lines by themselves: `kind`, `static`, `dynamic`.
        bodies: 'vessel' and 'stinger': `static`, `dynamic`, as `bodies['vessel'].dynamic.surge.max`.
        supports: Roller boxes: `supports['stinger 3'].static.reaction`.
        seabed: The laid pipe on an uneven seabed, its contacts and free spans.
        stages: Stages of an operation: what each was asked for, and its own lines, bodies and supports.
        run: Settings, steps and energy: `run.static`, `run.dynamic`.
    """


def objects_in(summary: _Values, stage_units: _Values | None = None, stage_descriptions: _Values | None = None) -> Objects:
    """The results by object of a summary.

    Args:
        summary: Content of summary.json.
        stage_units: Of what stages have besides the results of a lay, by the names of the stages.
        stage_descriptions: Likewise.

    Raises:
        ResultsError: Where a version of the program wrote them that knew no objects.
    """
    if "objects" not in summary:
        raise ResultsError("the results have no values by object: an earlier version wrote them; analyse the model again")
    values = summary["objects"]
    return Objects(values, _in_place(values, _core.object_units(), stage_units or {}),
                   _in_place(values, _core.object_descriptions(), stage_descriptions or {}))


def _in_place(values: _Values, places: _Values, stages: _Values) -> dict[str, Any]:
    """Units or descriptions of a line by its kind, of a support by "*", in the places of the objects."""
    lines = {name: places["lines"][line["kind"]] for name, line in values.get("lines", {}).items()}
    supports = {name: places["supports"]["*"] for name in values.get("supports", {})}
    below = {name: {**stages.get(name, {}), **_in_place(stage, places, {})} for name, stage in values.get("stages", {}).items()}
    return {**places, "lines": lines, "supports": supports, "stages": below}
