"""Operations stage by stage: abandonment, recovery, start-up, passage of structures, lifts."""

from __future__ import annotations

import functools
import os
import pathlib
from typing import TYPE_CHECKING, Any, Iterator, Optional, Sequence, Union

import numpy as np

from . import _core
from .errors import NoSolution
from .findings import make_findings
from .groups import Record, Table, nearest, wrapped
from .lift import LiftedLines, named
from .objects import Objects, objects_in
from .results import StaticResults, summary_descriptions, summary_units
from .values import Number, labelled

if TYPE_CHECKING:
    from .model import Model

PathLike = Union[str, "os.PathLike[str]"]

# Key results in the table of stages, in addition to the targets.
_KEY_RESULTS = ("top_tension", "bottom_tension", "lay_back", "suspended_length")


# Results of a lift in the table of stages, by line and by davit.
_OF_LIFT = {"lines": (("first_end", "z"), ("first_end", "inclination"), ("largest_bending_moment", "value"),
                      ("largest_bending_stress",)),
            "davits": (("length",), ("tension_upper",), ("utilisation",))}


class Stage(Record):
    """A stage: its settings (`stage.cable_out`, `stage.tension`, `stage.barge_ahead`), its key results as in a static
    analysis (`stage.lay_back`, `stage.sagbend.max_bending_stress`), `status`, `failure` and `checks`.

    Attributes:
        static: StaticResults of the stage; raises NoSolution if it has no equilibrium.
        stands: True if it has one.
    """

    def __init__(self, operation: "OperationResults", number: int, content: dict[str, Any], units: dict[str, Any],
                 descriptions: dict[str, Any]):
        """Not for users: see OperationResults."""
        super().__init__(content, units, descriptions)
        self._operation, self._number = operation, number

    @property
    def stands(self) -> bool:
        """True if the stage has an equilibrium."""
        return bool(self["status"] == "converged")

    @property
    def static(self) -> StaticResults:
        """The equilibrium of the stage with its code checks."""
        return self._operation._static(self._number)

    def __repr__(self) -> str:
        return f"<Stage '{self['name']}', {self['status']}>"


class LiftStage(Stage):
    """A stage of a lift: the pipes and the davit wires.

    Attributes:
        lines: The pipes by name: `lines['pipe'].first_end.z`, `lines['pipe'].nodes.z`.
        davits: The davit wires by name: length [m], tension_upper, tension_lower [N], from_vertical_upper [rad],
            utilisation, force_on_pipe, and at their `attachment` moment, tension and shear.
        gap: Gap before a weld: dx, dy, dz [m], angle [rad].
        join: The last weld: x, z [m], inclination [rad], tension, shear [N], moment [N m].
        stands, static: As for every stage.
    """

    def __init__(self, operation: "OperationResults", number: int, content: dict[str, Any], units: dict[str, Any],
                 descriptions: dict[str, Any], source: Any):
        """Not for users: see OperationResults."""
        super().__init__(operation, number, content, {**units, **named(_core.lift_units(), content)},
                         {**descriptions, **named(_core.lift_descriptions(), content)})
        self._source = source

    @functools.cached_property
    def lines(self) -> LiftedLines:
        """The pipes by name."""
        return LiftedLines(self._values, self._source, f"/operation/stage_{self._number + 1:03}/static")


class OperationResults(Sequence[Stage]):
    """The stages of an operation in order, by number from 0 or by name: `operation['on the bed'].tension`.

    Attributes:
        title, type: Title and type of the operation: 'abandonment', 'recovery', 'start_up', ...
        findings, assumptions: Those of the whole operation; each stage has its own. `warnings` are messages of findings.
        model: The model.
        summary: Content of summary.json.
    """

    def __init__(self, core: "_core.Operation", model: "Model"):
        """Not for users: see Model.operation() and overbend.open()."""
        self._core, self.model = core, model
        self.summary: dict[str, Any] = core.summary()
        content = self.summary["operation"]
        self.title: str = self.summary.get("title", "")
        self.type: str = content["type"]
        self.findings = make_findings(self.summary.get("findings", []))
        self.warnings: list[str] = self.summary.get("warnings", [])
        self.assumptions: list[str] = self.summary.get("assumptions", [])
        tree = core.tree()
        self._stages = [self._stage(tree, number, stage) for number, stage in enumerate(content["stages"])]

    def _stage(self, tree: Any, number: int, content: dict[str, Any]) -> Stage:
        units, descriptions = dict(summary_units()["static"]), dict(summary_descriptions()["static"])
        units["checks"], descriptions["checks"] = summary_units().get("checks"), summary_descriptions().get("checks")
        group = f"/operation/stage_{number + 1:03}"
        for name in tree.names(group):
            if not name.endswith("/"):
                _, units[name], descriptions[name], _, _ = tree.dataset(f"{group}/{name}")
        if "davits" in content:
            return LiftStage(self, number, content, units, descriptions, tree)
        return Stage(self, number, content, units, descriptions)

    @functools.cache
    def _static(self, number: int) -> StaticResults:
        solved = self._core.stage(number)
        if solved is None:
            failure = self._stages[number]._values.get("failure", {})
            raise NoSolution(failure.get("what", "the stage has no equilibrium"), failure.get("where", ""),
                             failure.get("why", ""))
        return StaticResults(solved, self.model)

    def __getitem__(self, which: Any) -> Any:
        if not isinstance(which, str):
            return self._stages[which]
        for stage in self._stages:
            if stage["name"] == which:
                return stage
        raise KeyError(f"there is no stage '{which}'{nearest(which, self.names)}; there are: {', '.join(self.names)}")

    def __len__(self) -> int:
        return len(self._stages)

    def __iter__(self) -> Iterator[Stage]:
        return iter(self._stages)

    @property
    def names(self) -> list[str]:
        """Names of the stages."""
        return [stage["name"] for stage in self._stages]

    @functools.cached_property
    def objects(self) -> Objects:
        """Results by object: `objects.stages['half way'].lines['pipe'].static.lay_back`."""
        return objects_in(self.summary, {stage["name"]: stage._units for stage in self},
                          {stage["name"]: stage._descriptions for stage in self})

    @property
    def worst(self) -> Optional[Record]:
        """The check with the largest utilisation over all stages, with the name of its `stage`; None without checks."""
        worst = self.summary["checks"]["worst"]
        content = summary_units()["checks"]["worst"], summary_descriptions()["checks"]["worst"]
        return wrapped(worst, *content) if worst else None

    @functools.cached_property
    def table(self) -> Table:
        """One row per stage: name, settings, key results, governing check; NaN for missing values."""
        columns: dict[str, Any] = {"name": _Column([stage["name"] for stage in self], "1", "Name of the stage")}
        for stage in self:
            for name, value in stage._values.items():
                single = isinstance(value, (int, float)) and not isinstance(value, bool) and name in stage._units
                if single and (name not in summary_units()["static"] or name in _KEY_RESULTS) and name not in columns:
                    found = [each._values.get(name) for each in self]
                    columns[name] = _Column([np.nan if v is None else float(v) for v in found], stage._units[name],
                                            stage._descriptions.get(name, ""))
        columns.update(self._columns_of_lift())
        worst = [stage._values.get("checks", {}).get("worst") or {} for stage in self]
        columns["status"] = _Column([stage["status"] for stage in self], "1", "converged or failed")
        columns["worst_check"] = _Column([check.get("name", "") for check in worst], "1", "Check with the largest utilisation")
        columns["utilisation"] = _Column([check.get("utilisation", np.nan) for check in worst], "1",
                                         "Utilisation of that check")
        number = np.arange(len(self))

        def column(name: str) -> Any:
            if name == "stage":
                return labelled(number, name, ("stage",), {"stage": number}, "1", "Number of the stage, from 0")
            stored = columns[name]
            return labelled(np.array(stored.values), name, ("stage",), {"stage": number}, stored.units, stored.description)

        return Table(["stage", *columns], column)

    def _columns_of_lift(self) -> dict[str, "_Column"]:
        """Columns of a lift: results of every line and davit that change from stage to stage."""
        if not any(isinstance(stage, LiftStage) for stage in self):
            return {}
        units, content = _core.lift_units(), _core.lift_descriptions()
        columns = {}
        for group, paths in _OF_LIFT.items():
            for name in dict.fromkeys(name for stage in self for name in stage._values.get(group, {})):
                for path in paths:
                    found = [_below(stage._values, (group, name, *path)) for stage in self]
                    columns[".".join((name, *path))] = _Column(
                        [np.nan if v is None else v for v in found], _below(units, (group, "*", *path)),
                        _below(content, (group, "*", *path)))
        return columns

    def save(self, folder: PathLike) -> pathlib.Path:
        """Writes the files of `overbend static -o`: stages.csv, stages.xlsx, results.h5, summary.json, report.html.

        Raises:
            ResultsError: If the folder cannot be written.
        """
        self._core.save(os.fspath(folder))
        return pathlib.Path(folder)

    def __repr__(self) -> str:
        standing = sum(stage.stands for stage in self)
        return f"<OperationResults of '{self.title}', {self.type}: {standing} of {len(self)} stages solved>"


def _below(values: Any, path: Sequence[str]) -> Any:
    """Value at a path in nested groups; None if there is none."""
    for name in path:
        values = values.get(name) if isinstance(values, dict) else None
    return values


class _Column:
    def __init__(self, values: list[Any], units: Any, description: Any):
        self.values = values
        self.units = units if isinstance(units, str) else "1"
        self.description = description if isinstance(description, str) else ""
