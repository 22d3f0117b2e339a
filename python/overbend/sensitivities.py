"""What the results of a lay hang on."""

from __future__ import annotations

from typing import Any, Mapping, Sequence

import numpy as np

from .groups import Record, Records, nearest
from .values import Number, labelled, stored_unit


class Sensitivities:
    """Derivatives of results by numbers of the model file, where the contacts stay as they are.

    Attributes:
        inputs: Numbers of the model: name, key, text, unit, value, tolerance, own_tolerance, near [SI].
        results: Results: name, text, unit, value, key (whether it is one of the key results) [SI].
        one_sided: Derivatives that hold on one side only, for a contact opens or closes within the tolerance: result,
            input, support, closes, until (value of the input), beyond (derivative there).
        without_effect: Names of inputs on which none of the results hangs.
        not_done: Names of inputs that cannot be changed a little.
        assumptions: What was assumed.
        summary: All that, as summary.json has it as `sensitivities`.
    """

    def __init__(self, told: Mapping[str, Any]):
        """Not for users: see Model.sensitivities()."""
        self.summary = told
        self.inputs = Records([_with_unit(one, ("value", "tolerance")) for one in told["inputs"]])
        self.results = Records([_with_unit(one, ("value",)) for one in told["results"]])
        self.one_sided = Records([Record(one) for one in told["one_sided"]])
        self.without_effect: list[str] = told["without_effect"]
        self.not_done: list[str] = told["not_done"]
        self.assumptions: list[str] = told["assumptions"]

    @property
    def derivatives(self) -> Any:
        """All derivatives as a labelled array of shape (results, inputs), in SI units of result by input."""
        return self._matrix("derivatives", "Of the result by the input; SI units of both")

    @property
    def effects(self) -> Any:
        """How far the tolerance of an input moves a result, the larger of both ways: an array (results, inputs) in SI
        units of the result; beyond a contact that changes with the derivative there."""
        return self._matrix("effects", "Largest change of the result within the tolerance; SI unit of the result")

    def derivative(self, result: str, input: str) -> Number:
        """The derivative of one result by one input, by their names; its `units` are those of both [SI]."""
        row, column = self._place(self.results, result), self._place(self.inputs, input)
        above, below = self.results[row]["unit"], self.inputs[column]["unit"]
        unit = above if below == "1" else f"{above}/({below})" if " " in below or "/" in below else f"{above}/{below}"
        return Number(self.summary["derivatives"][row][column], unit, f"{result} by {input}")

    def foremost(self, result: str, count: int = 3) -> list[tuple[str, Number]]:
        """The inputs whose tolerance moves the result most, each with the effect [SI unit of the result]."""
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


def _with_unit(told: Mapping[str, Any], quantities: Sequence[str]) -> Record:
    unit = stored_unit(told["unit"])
    return Record({**told, "unit": unit}, {name: unit for name in quantities})
