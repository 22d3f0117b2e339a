"""Goal seek: input values that give required results."""

from __future__ import annotations

import os
import pathlib
import re
from typing import Any, Mapping, Optional, Sequence, Union

import numpy as np

from . import _core
from .errors import ModelError, NoSolution
from .groups import Record, Records, Table
from .keys import flow
from .model import Model, PathLike
from .operation import OperationResults
from .results import StaticResults
from .values import Number, labelled, stored_unit

Bounds = Union[None, Sequence[Any], Mapping[str, Any]]
Condition = Union[str, float, Mapping[str, Any]]

_RELATIONS = {"<=": "at_most", ">=": "at_least", "==": "equals", "=": "equals", "": "equals"}


def seek(model: Model, vary: Union[str, Sequence[str], Mapping[str, Bounds], None] = None,
         until: Optional[Mapping[str, Condition]] = None, minimise: Optional[str] = None) -> "SeekResult":
    """Finds values of keys that give required static results; the model is not changed.

    One key with one condition is searched over the whole of its bounds, and every answer and every jump of the result is
    reported. Several keys, several conditions or a minimum are searched from the model's values to the nearest optimum; if
    the conditions are not met there, the search restarts from the best points sampled within the bounds.

        ob.seek(model, vary='tensioner.tension', until={'static.sagbend.max_bending_stress': '100 MPa'})
        ob.seek(model, vary={'supports.stinger.boxes[stinger *].z': {'within': '0.5 m'}},
                until={'static.stinger_tip_clearance': '>= 0.3 m'}, minimise='spread(static.supports[*].reaction)')
        ob.seek(lift, vary={'operation.stages[level].lengths[davit *]': {'within': '3 m'}},
                until={'operation.stages[level].lines.pipe.first_end.z': '2.5 m'},
                minimise='operation.stages[level].lines.pipe.largest_bending_moment.value')

    Args:
        model: The initial model.
        vary: A key, several keys, or keys with bounds: (lowest, highest), or {'within': largest change either way}. Default
            bounds are half and twice the model's value; for coordinates and offsets 1 m either way. List items are
            selected by index from 0, name or pattern; each match of a pattern is an unknown of its own. If all arguments
            are omitted, the key `seek` of the model file is used.
        until: Conditions by result: '100 MPa' or '== 100 MPa', '<= 100 MPa', '>= 3 m'; or {'at_most': '100 MPa'}.
            Results are named as in summary.json.
        minimise: A result to minimise within the conditions.

    Raises:
        NoSolution: If nothing within the bounds meets the conditions; `why` says what is reached, and `results` is the
            SeekResult without an answer.
        ModelError: If a key, a result or a value is invalid.
    """
    if vary is None and until is None and minimise is None:
        found = _core.seek(model._core, "")
    else:
        found = _core.seek(model._core, flow(_wanted(model, vary, until, minimise)))
    result = SeekResult(found, model)
    if not result.found:
        failure = NoSolution("the goal seek has no answer", "", result.why)
        failure.results = result  # type: ignore[attr-defined]
        raise failure
    return result


class SeekResult:
    """Result of a goal seek.

    Attributes:
        found: True if there is an answer.
        why: Reason why there is none; otherwise empty.
        keys: The varied keys: key, unit, from, to, before, answer, at_bound; values in `unit`, SI.
        goals: The conditions and the minimised result: result, is, wanted, before, reached, unit, slope.
        others: Further answers of a single key [SI].
        jumps: Values of a single key at which the result jumps across the target: at, below, above, why.
        remarks: Further remarks.
        stages: For a lift: the stages with the answer, each as a line for a model file.
        residual: Largest deviation from a condition, relative to its target.
        evaluations: Number of models solved.
        summary: The key `seek` of summary.json.
    """

    def __init__(self, found: "_core.Sought", model: Model):
        """Not for users: see seek()."""
        self._found, self._before = found, model
        content: dict[str, Any] = found.results
        self.summary = content
        self.found: bool = content["found"]
        self.why: str = content["why"] or ""
        self.keys = Records([_row(key, ("from", "to", "before", "answer")) for key in content["keys"]])
        self.goals = Records([_row(goal, ("wanted", "before", "reached")) for goal in content["goals"]])
        units = [stored_unit(row["unit"]) for row in content["keys"]]
        self.others = [Number(value, units[0]) for value in content["others"]]
        self.jumps = Records([Record(jump) for jump in content["jumps"]])
        self.remarks: list[str] = content["remarks"]
        self.stages: list[str] = content.get("stages", [])
        self.residual: float = content["residual"]
        self.evaluations: int = content["evaluations"]

    @property
    def answer(self) -> Any:
        """Value of a single key, a Number [SI]; for several keys a Record by key; None without an answer."""
        if not self.found:
            return None
        units = {row["key"]: stored_unit(row["unit"]) for row in self.summary["keys"]}
        answers = {row["key"]: row["answer"] for row in self.summary["keys"]}
        if len(answers) > 1:
            return Record(answers, units)
        key, value = next(iter(answers.items()))
        return Number(value, units[key], key)

    @property
    def model(self) -> Model:
        """The model with the answer; without an answer the initial model."""
        return Model(self._found.model) if self.found else self._before

    @property
    def static(self) -> Optional[StaticResults]:
        """Static results of that model; None without an answer, and for a lift."""
        return StaticResults(self._found.statics, self.model) if self._found.statics else None

    @property
    def operation(self) -> Optional[OperationResults]:
        """Stages of that model for a lift; otherwise None."""
        return OperationResults(self._found.operation, self.model) if self._found.operation else None

    @property
    def path(self) -> Table:
        """Every model of the search: columns by keys, results and `failure` [SI]; NaN without an equilibrium."""
        columns: dict[str, tuple[Any, str]] = {}
        steps = self.summary["path"]
        for index, row in enumerate(self.summary["keys"]):
            columns[row["key"]] = ([step["values"][index] for step in steps], stored_unit(row["unit"]))
        for index, goal in enumerate(self.summary["goals"]):
            reached = [step["results"][index] if step["results"] else np.nan for step in steps]
            columns[goal["result"]] = (reached, stored_unit(goal["unit"]))
        columns["failure"] = ([step.get("failure", "") for step in steps], "1")
        number = np.arange(len(steps))

        def column(name: str) -> Any:
            if name == "step":
                return labelled(number, "step", ("step",), {"step": number}, "1", "Number of the model, from 0")
            values, units = columns[name]
            return labelled(np.array(values), name, ("step",), {"step": number}, units, name)

        return Table(["step", *columns], column)

    def save(self, folder: PathLike) -> pathlib.Path:
        """Writes the files of `overbend seek -o`: static results of the answer with report, model.yaml, seek.csv,
        summary.json.

        Raises:
            ResultsError: If the folder cannot be written.
        """
        self._found.save(os.fspath(folder))
        return pathlib.Path(folder)

    def __repr__(self) -> str:
        if not self.found:
            return f"<SeekResult without an answer: {self.why}>"
        answers = ", ".join(f"{row['key']} = {row['answer']:.6g} {row['unit']}" for row in self.summary["keys"])
        return f"<SeekResult: {answers}; {self.evaluations} models>"


def conditions(until: Mapping[str, Condition]) -> list[dict[str, Any]]:
    """Conditions in the form of a model or study file: [{'result': name, 'at_most': '100 MPa'}]."""
    return [{"result": result, **_relation(result, condition)} for result, condition in until.items()]


def _relation(result: str, condition: Condition) -> dict[str, Any]:
    if isinstance(condition, Mapping):
        return dict(condition)
    if not isinstance(condition, str):
        return {"equals": condition}
    sign, value = re.fullmatch(r"\s*(<=|>=|==|=|)\s*(.*?)\s*", condition, re.DOTALL).groups()  # type: ignore[union-attr]
    if value.startswith(("<", ">")):
        raise ModelError(f"{result}: found {condition!r}, expected '<= value' or '>= value'")
    return {_RELATIONS[sign]: value}


def _wanted(model: Model, vary: Any, until: Optional[Mapping[str, Condition]], minimise: Optional[str]) -> dict[str, Any]:
    if vary is None:
        raise ModelError("vary: nothing is given, expected the key or keys that may change")
    if until is not None and not isinstance(until, Mapping):
        raise ModelError(f"until: found {until!r}, expected a dict such as {{'static.lay_back': '95 m'}}")
    named = {vary: None} if isinstance(vary, str) else vary if isinstance(vary, Mapping) else dict.fromkeys(vary)
    wanted: dict[str, Any] = {"vary": [_variable(model, key, bounds) for key, bounds in named.items()]}
    if until:
        wanted["until"] = conditions(until)
    if minimise is not None:
        wanted["minimise"] = minimise
    return wanted


def _variable(model: Model, key: str, bounds: Bounds) -> dict[str, Any]:
    if bounds is None:
        bounds = _usual_bounds(model, key)
    if isinstance(bounds, Mapping):
        return {"key": key, **{name.rstrip("_"): value for name, value in bounds.items()}}
    if bounds is None or isinstance(bounds, str) or len(bounds) != 2:
        raise ModelError(f"{key}: found the bounds {bounds!r}, expected (lowest, highest) or {{'within': how far}}")
    return {"key": key, "from": bounds[0], "to": bounds[1]}


def _usual_bounds(model: Model, key: str) -> Bounds:
    """Half and twice the model's value, 1 m either way for coordinates. The engine reports invalid keys."""
    if re.search(r"\.(x|y|z|offset)$", key):
        return {"within": "1 m"}
    value = model.get(key)
    parts = re.fullmatch(r"\s*([-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)\s*(.*)", str(value), re.DOTALL)
    if parts is None or float(parts[1]) == 0.0 or "*" in key:
        return {}
    low, high = sorted((0.5 * float(parts[1]), 2.0 * float(parts[1])))
    return f"{low!r} {parts[2]}".strip(), f"{high!r} {parts[2]}".strip()


def _row(content: Mapping[str, Any], quantities: Sequence[str]) -> Record:
    """A row whose quantities have the unit given in the row."""
    unit = stored_unit(content["unit"])
    return Record({**content, "unit": unit}, {name: unit for name in quantities})
