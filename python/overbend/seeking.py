"""Goal seek: values of keys with which results are as wanted."""

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
Wish = Union[str, float, Mapping[str, Any]]

_RELATIONS = {"<=": "at_most", ">=": "at_least", "==": "equals", "=": "equals", "": "equals"}


def seek(model: Model, vary: Union[str, Sequence[str], Mapping[str, Bounds], None] = None,
         until: Optional[Mapping[str, Wish]] = None, minimise: Optional[str] = None) -> "SeekResult":
    """Finds values of keys with which the results of statics are as wanted; the model is not changed.

    One key with one condition is searched over all its bounds: every answer and every jump of the result is told.
    Several keys, several conditions or something to minimise are searched from the model's values to the nearest
    optimum, and where the conditions are not met there from the best of places over the bounds.

        ob.seek(model, vary='tensioner.tension', until={'static.sagbend.max_bending_stress': '100 MPa'})
        ob.seek(model, vary={'supports.stinger.boxes[stinger *].z': {'within': '0.5 m'}},
                until={'static.stinger_tip_clearance': '>= 0.3 m'}, minimise='spread(static.supports[*].reaction)')
        ob.seek(lift, vary={'operation.stages[level].lengths[davit *]': {'within': '3 m'}},
                until={'operation.stages[level].lines.pipe.first_end.z': '2.5 m'},
                minimise='operation.stages[level].lines.pipe.largest_bending_moment.value')

    Args:
        model: The model that it begins with.
        vary: A key, several, or keys with their bounds: (lowest, highest), or {'within': how far either way}. Without
            bounds from half the model's value to twice that; places and offsets 1 m either way. An item of a list is
            chosen by index from 0, name or pattern; each that a pattern matches is an unknown of its own. All left out:
            what the model file has as its key `seek`.
        until: Conditions by results: '100 MPa' or '== 100 MPa', '<= 100 MPa', '>= 3 m'; or {'at_most': '100 MPa'}.
            Results have their names in summary.json.
        minimise: A result to make as small as the conditions allow.

    Raises:
        NoSolution: Where nothing within the bounds meets the conditions; `why` says what is reached, and `results` is
            the SeekResult without an answer.
        ModelError: Where a key, a result or a value cannot be.
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
    """What a goal seek found.

    Attributes:
        found: Whether there is an answer.
        why: Why there is none; else empty.
        keys: The keys that were varied: key, unit, from, to, before, answer, at_bound; values in `unit`, SI.
        goals: The conditions and what was minimised: result, is, wanted, before, reached, unit, slope.
        others: Further answers of a single key [SI].
        jumps: Places where a single result leaps over the value wanted: at, below, above, why.
        remarks: What there is to say besides.
        stages: Of a lift: the stages with the answer, each as a line for a model file.
        residual: Largest distance from a condition, relative to what is wanted.
        evaluations: Number of models solved.
        summary: All that, as summary.json has it as `seek`.
    """

    def __init__(self, found: "_core.Sought", model: Model):
        """Not for users: see seek()."""
        self._found, self._before = found, model
        told: dict[str, Any] = found.results
        self.summary = told
        self.found: bool = told["found"]
        self.why: str = told["why"] or ""
        self.keys = Records([_row(one, ("from", "to", "before", "answer")) for one in told["keys"]])
        self.goals = Records([_row(one, ("wanted", "before", "reached")) for one in told["goals"]])
        units = [stored_unit(one["unit"]) for one in told["keys"]]
        self.others = [Number(value, units[0]) for value in told["others"]]
        self.jumps = Records([Record(jump) for jump in told["jumps"]])
        self.remarks: list[str] = told["remarks"]
        self.stages: list[str] = told.get("stages", [])
        self.residual: float = told["residual"]
        self.evaluations: int = told["evaluations"]

    @property
    def answer(self) -> Any:
        """The value of a single key, a Number [SI]; of several a Record of them by key; None without an answer."""
        if not self.found:
            return None
        units = {one["key"]: stored_unit(one["unit"]) for one in self.summary["keys"]}
        answers = {one["key"]: one["answer"] for one in self.summary["keys"]}
        if len(answers) > 1:
            return Record(answers, units)
        key, value = next(iter(answers.items()))
        return Number(value, units[key], key)

    @property
    def model(self) -> Model:
        """The model with the answer put in; without an answer that which the search began with."""
        return Model(self._found.model) if self.found else self._before

    @property
    def static(self) -> Optional[StaticResults]:
        """The statics of that model; None without an answer, and of a lift."""
        return StaticResults(self._found.statics, self.model) if self._found.statics else None

    @property
    def operation(self) -> Optional[OperationResults]:
        """Of a lift the stages of that model; else None."""
        return OperationResults(self._found.operation, self.model) if self._found.operation else None

    @property
    def path(self) -> Table:
        """Every model on the way: columns by keys, results and `failure` [SI]; NaN where there is no equilibrium."""
        columns: dict[str, tuple[Any, str]] = {}
        steps = self.summary["path"]
        for index, one in enumerate(self.summary["keys"]):
            columns[one["key"]] = ([step["values"][index] for step in steps], stored_unit(one["unit"]))
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
        """Writes the files of `overbend seek -o`: statics of the answer with report, model.yaml, seek.csv,
        summary.json.

        Raises:
            ResultsError: Where the folder cannot be written.
        """
        self._found.save(os.fspath(folder))
        return pathlib.Path(folder)

    def __repr__(self) -> str:
        if not self.found:
            return f"<SeekResult without an answer: {self.why}>"
        answers = ", ".join(f"{one['key']} = {one['answer']:.6g} {one['unit']}" for one in self.summary["keys"])
        return f"<SeekResult: {answers}; {self.evaluations} models>"


def conditions(until: Mapping[str, Wish]) -> list[dict[str, Any]]:
    """Conditions by results as a model or study file has them: [{'result': name, 'at_most': '100 MPa'}]."""
    return [{"result": result, **_relation(result, wish)} for result, wish in until.items()]


def _relation(result: str, wish: Wish) -> dict[str, Any]:
    if isinstance(wish, Mapping):
        return dict(wish)
    if not isinstance(wish, str):
        return {"equals": wish}
    sign, value = re.fullmatch(r"\s*(<=|>=|==|=|)\s*(.*?)\s*", wish, re.DOTALL).groups()  # type: ignore[union-attr]
    if value.startswith(("<", ">")):
        raise ModelError(f"{result}: found {wish!r}, expected '<= value' or '>= value'")
    return {_RELATIONS[sign]: value}


def _wanted(model: Model, vary: Any, until: Optional[Mapping[str, Wish]], minimise: Optional[str]) -> dict[str, Any]:
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
    """Half and twice the value in the model, 1 m either way of places; a key that cannot be is told by the engine."""
    if re.search(r"\.(x|y|z|offset)$", key):
        return {"within": "1 m"}
    value = model.get(key)
    parts = re.fullmatch(r"\s*([-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)\s*(.*)", str(value), re.DOTALL)
    if parts is None or float(parts[1]) == 0.0 or "*" in key:
        return {}
    low, high = sorted((0.5 * float(parts[1]), 2.0 * float(parts[1])))
    return f"{low!r} {parts[2]}".strip(), f"{high!r} {parts[2]}".strip()


def _row(told: Mapping[str, Any], quantities: Sequence[str]) -> Record:
    """A row whose quantities have the unit that stands beside them."""
    unit = stored_unit(told["unit"])
    return Record({**told, "unit": unit}, {name: unit for name in quantities})
