"""Stages of a lift: the pipe in the davits with its shape and moments, the wires, the weld."""

from __future__ import annotations

import functools
from typing import Any, Mapping

from . import _core
from .groups import Record, Table, make_table, nearest
from .values import labelled

class LiftedLine(Record):
    """A pipe at a stage of a lift.

    Attributes in addition to `nodes`: `first_end`, `second_end` (x, y, z [m], inclination [rad], tension [N]), `held_end`,
    `largest_bending_moment`, `largest_sagging_moment`, `largest_hogging_moment` (value [N m], arc_length, x, y, z [m]),
    `largest_bending_stress` [Pa], `largest_tension`, `least_tension` [N], `on_bed`, `lift_off`, `suspended_length` [m],
    `water_crossings` [m]. Inclinations are positive downwards, going from the first end to the second.

    Attributes:
        nodes: Table of the nodes over arc_length, unstressed from the first end [m]: x, y, z [m], inclination [rad],
            tension, shear [N], sagging_moment, sideways_moment [N m], bending_stress [Pa].
    """

    def __init__(self, values: dict[str, Any], units: Any, descriptions: Any, source: Any, group: str):
        """Not for users: see LiftStage."""
        super().__init__(values, units, descriptions)
        self._source, self._group = source, group

    @functools.cached_property
    def nodes(self) -> Table:
        """Nodes of the line from its first end: shape, forces and moments."""
        plain = make_table(self._source, self._group + "/nodes")
        names = {name.removeprefix("position_"): name for name in plain.keys()}
        scale = plain.keys()[0]

        def column(name: str) -> Any:
            found = plain.column(names[name])
            if names[name] == name:
                return found
            return labelled(found.values, name, (scale,), {scale: plain.column(scale).values}, found.attrs["units"],
                            found.attrs["description"], found.attrs.get("frame", ""))

        return Table(list(names), column)


class LiftedLines(Record):
    """The pipes by name: `stage.lines['pipe'].first_end.z`."""

    def __init__(self, stage: Mapping[str, Any], source: Any, group: str):
        """Not for users: see LiftStage."""
        super().__init__(stage["lines"])
        units, descriptions = _core.lift_units()["lines"]["*"], _core.lift_descriptions()["lines"]["*"]
        self._lines = {name: LiftedLine(values, units, descriptions, source, f"{group}/lines/{number}")
                       for number, (name, values) in enumerate(stage["lines"].items())}

    def __getitem__(self, name: str) -> LiftedLine:
        if name not in self._lines:
            raise KeyError(f"there is no '{name}'{nearest(name, list(self._lines))}")
        return self._lines[name]


def named(places: dict[str, Any], stage: Mapping[str, Any]) -> dict[str, Any]:
    """Units or descriptions of a stage, with those of "*" for each davit."""
    return {**places, "davits": dict.fromkeys(stage["davits"], places["davits"]["*"])}
