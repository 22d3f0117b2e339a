"""Sensitivity analysis: derivatives of static results."""

from __future__ import annotations

from typing import Any, Mapping, Sequence

import numpy as np

from .errors import ModelError
from .groups import Record, Records, nearest
from .values import Number, labelled, stored_unit


class Sensitivities:
    """Derivatives of results with respect to numbers of the model file, with unchanged contacts.

    Attributes:
        inputs: Numbers of the model: name, key, text, unit, value, tolerance, own_tolerance, near [SI].
        results: Results: name, text, unit, value, key (True for key results) [SI].
        one_sided: Derivatives valid on one side only, because a contact opens or closes within the tolerance: result,
            input, support, closes, until (value of the input), beyond (derivative there).
        without_effect: Names of inputs that change no result.
        not_done: Names of inputs that cannot be varied continuously.
        assumptions: Assumptions of the analysis.
        summary: The key `sensitivities` of summary.json.
    """

    def __init__(self, content: Mapping[str, Any]):
        """Not for users: see Model.sensitivities()."""
        self.summary = content
        self.inputs = Records([_with_unit(item, ("value", "tolerance")) for item in content["inputs"]])
        self.results = Records([_with_unit(result, ("value",)) for result in content["results"]])
        self.one_sided = Records([Record(derivative) for derivative in content["one_sided"]])
        self.without_effect: list[str] = content["without_effect"]
        self.not_done: list[str] = content["not_done"]
        self.assumptions: list[str] = content["assumptions"]

    @property
    def derivatives(self) -> Any:
        """All derivatives as a labelled array of shape (results, inputs), in SI units of result over input."""
        return self._matrix("derivatives", "Derivative of the result with respect to the input; SI units of both")

    @property
    def effects(self) -> Any:
        """Largest change of each result within the tolerance of each input: an array of shape (results, inputs) in SI units of
        the result, including derivatives beyond contacts that change."""
        return self._matrix("effects", "Largest change of the result within the tolerance; SI unit of the result")

    def derivative(self, result: str, input: str) -> Number:
        """Derivative of a result with respect to an input, by their names; its `units` combine both [SI]."""
        row, column = self._place(self.results, result), self._place(self.inputs, input)
        above, below = self.results[row]["unit"], self.inputs[column]["unit"]
        unit = above if below == "1" else f"{above}/({below})" if " " in below or "/" in below else f"{above}/{below}"
        return Number(self.summary["derivatives"][row][column], unit, f"{result} by {input}")

    def foremost(self, result: str, count: int = 3) -> list[tuple[str, Number]]:
        """The inputs with the largest effects on a result, each with its effect [SI unit of the result]."""
        row = self._place(self.results, result)
        effects = np.array(self.summary["effects"][row])
        order = [i for i in np.argsort(-effects, kind="stable")[:count] if effects[i] > 0.0]
        return [(self.inputs[int(i)]["name"], Number(effects[i], self.results[row]["unit"])) for i in order]

    def _matrix(self, name: str, description: str) -> Any:
        results, inputs = self.results.names(), self.inputs.names()
        values = np.array(self.summary[name], dtype=float).reshape(len(results), len(inputs))
        coords = {"result": np.array(results), "input": np.array(inputs)}
        return labelled(values, name, ("result", "input"), coords, "SI", description)

    @staticmethod
    def _place(rows: Records, name: str) -> int:
        names = rows.names()
        if name not in names:
            raise KeyError(f"there is no '{name}'{nearest(name, names)}; there are: {', '.join(names)}")
        return names.index(name)

    def __repr__(self) -> str:
        return f"<Sensitivities of {len(self.results)} results by {len(self.inputs)} inputs>"


def require_keys(content: Mapping[str, Any], keys: Sequence[str]) -> None:
    """Raises ModelError where one of the keys is no number of the model file."""
    known = {*content["without_effect"], *content["not_done"]}
    for item in content["inputs"]:
        known |= {item["name"], item["key"]}
    for key in keys:
        if key not in known:
            raise ModelError(f"'{key}' is no number that the model file has, written as there or by default")


def _with_unit(item: Mapping[str, Any], quantities: Sequence[str]) -> Record:
    unit = stored_unit(item["unit"])
    return Record({**item, "unit": unit}, {name: unit for name in quantities})
