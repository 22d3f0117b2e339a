"""Models: reading, changing and solving."""

from __future__ import annotations

import os
import pathlib
from typing import TYPE_CHECKING, Any, Callable, Iterable, Mapping, Optional, Union

from . import _core
from .controllers import Controllers, given_controllers
from .dynamic_results import DynamicResults
from .errors import Interrupted, ModelError
from .findings import Finding, make_findings
from .keys import Time, make_changes, require_seeds, seconds
from .progress import Progress, follower
from .results import StaticResults
from .runs import ComparisonResults, SeedsResults
from .simulation import Simulation, simulate
from .temporary import TemporaryFolder

if TYPE_CHECKING:
    from .lay_table import Depths, LayTable, RowProgress
    from .operation import OperationResults
    from .sensitivities import Sensitivities

PathLike = Union[str, "os.PathLike[str]"]
StageProgress = Callable[[int, int, str], object]


class Model:
    """A validated model file. It is immutable: `with_` returns a changed copy."""

    def __init__(self, core: "_core.Model"):
        """Not for users: see `read` and `from_text`."""
        if not isinstance(core, _core.Model):
            raise TypeError(f"Model(...): found {core!r}; a model is made by Model.read(path) or Model.from_text(text)")
        self._core = core

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickles the model as its text, for process pools."""
        return Model.from_text, (self.text, self.file)

    def __copy__(self) -> "Model":
        """Returns the model itself: it is immutable."""
        return self

    def __deepcopy__(self, memo: Any) -> "Model":
        """Returns the model itself: it is immutable."""
        return self

    @classmethod
    def read(cls, path: PathLike) -> "Model":
        """Reads a model file.

        Raises:
            ModelError: If the file has errors, with file, line and key of each.
        """
        return cls(_core.Model.read(os.fspath(path)))

    @classmethod
    def from_text(cls, text: str, file: PathLike = "model.yaml") -> "Model":
        """Makes a model from text.

        Args:
            text: Content of a model file.
            file: Name of the text in messages; relative paths in the text start from the folder of this file.

        Raises:
            ModelError: As in read().
        """
        return cls(_core.Model.from_text(text, os.fspath(file)))

    @property
    def text(self) -> str:
        """Text of the model file with any changed keys; comments and layout are kept."""
        return self._core.text

    @property
    def file(self) -> str:
        """Path of the file as given."""
        return self._core.file

    @property
    def title(self) -> str:
        """Title of the model."""
        return self._core.title

    @property
    def findings(self) -> list[Finding]:
        """Findings on the model before any analysis, such as unusual input."""
        return make_findings(self._core.findings)

    @property
    def warnings(self) -> list[str]:
        """Messages of the findings."""
        return [finding.message for finding in self.findings]

    @property
    def assumptions(self) -> list[str]:
        """Assumptions made for input that the file does not give."""
        return self._core.assumptions

    def with_(self, changes: Optional[Mapping[str, Any]] = None, /, **keys: Any) -> "Model":
        """Returns the model with keys changed, one after the other.

        Args:
            changes: Values by key: 'tensioner.tension', 'supports.stinger.boxes[stinger 3].z'; list items by index
                from 0, name or pattern (`stinger *`). A value is a string with unit ('260 kN'), a number for a key
                without unit, a boolean, a list or dict of these for a whole group, None to remove the key.
            keys: The same as keyword arguments: with_(title='Another').

        Raises:
            ModelError: If a key is unknown or a value is invalid.
        """
        return Model(self._core.changed(make_changes({**(changes or {}), **keys})))

    def get(self, key: str, default: Any = None) -> Any:
        """Value of a key in the text: a string such as '260 kN', a list or a dict; `default` if it is omitted."""
        value = self._core.value(key)
        return default if value is None else value

    def __getitem__(self, key: str) -> Any:
        value = self._core.value(key)
        if value is None:
            raise KeyError(f"the model's text has no '{key}'")
        return value

    def to_dict(self) -> dict[str, Any]:
        """Keys and values of the file as nested dicts and lists of strings."""
        return self._core.tree

    def write(self, path: PathLike, overwrite: bool = False) -> pathlib.Path:
        """Writes the model to a file. Relative paths in the model are adapted to the folder of the file.

        Raises:
            FileExistsError: If the file exists and `overwrite` is False.
        """
        target = pathlib.Path(path)
        text = self._core.moved(str(target.parent))
        with target.open("w" if overwrite else "x", encoding="utf-8") as stream:
            stream.write(text)
        return target

    def static(self, start: Optional[StaticResults] = None, stage: Union[str, int] = "") -> StaticResults:
        """Solves the static equilibrium and makes the code checks.

        Args:
            start: A similar equilibrium for a warm start, which saves iterations. Results agree with those solved from
                scratch to the accuracy of statics, as long as the equilibrium is unique: across a current there may be
                several, and the one found then depends on the start.
            stage: Stage of an operation, by name or number from 1.

        Raises:
            NoSolution: If there is no equilibrium, with the reason.
            ModelError: If the model requires an unsupported feature.
        """
        return StaticResults(_core.Statics(self._core, str(stage), start._solved if start is not None else None), self)

    def dynamic(self, duration: Time = None, seed: Optional[int] = None, out: Optional[PathLike] = None, *,
                stage: Union[str, int] = "", resume: bool = False, restart: bool = False, checkpoint: float = 30.0,
                controllers: Optional[Controllers] = None, interval: float = 0.1,
                progress: Union[bool, Progress] = False) -> DynamicResults:
        """Runs a dynamic analysis.

        Releases the GIL. Ctrl-C ends the run at a checkpoint.

        Args:
            duration: '600 s' or a number of seconds, instead of the model's duration.
            seed: Seed of the waves; the model's first if omitted.
            out: Folder for the results, with the files of `overbend dynamic -o`. If omitted: a temporary folder, deleted
                together with the results object; its save() keeps the files.
            stage: Stage of an operation, by name or number from 1.
            resume: Continues an unfinished run in `out`, if there is one.
            restart: Discards an unfinished run in `out`, if there is one.
            checkpoint: Time between checkpoints [s].
            controllers: Controllers by machine: 'tensioner', or the name of a mooring line for its winch; see
                controllers.Controller. A run started with controllers must be resumed with some for the same machines.
            interval: Time between calls of controller functions [s].
            progress: True for a line on the terminal, or a function (see progress.Progress), called ten times a second.

        Raises:
            Interrupted: After Ctrl-C, with the folder from which the run can be resumed.
            NoSolution: If statics or a time step cannot be solved.
            ControllerError: If a controller returns a command that its machine cannot execute. Exceptions of a controller
                are passed on.
            ModelError, ResultsError: If the input or the folder cannot be used.
        """
        folder, holder = self._run(out, stage=str(stage), duration=seconds(duration), resume=resume, restart=restart,
                                   seeds=[] if seed is None else require_seeds([seed]), checkpoint=checkpoint,
                                   progress=progress, controllers=given_controllers(controllers, interval))
        return DynamicResults(folder, self, holder)

    def simulation(self, duration: Time = None, seed: Optional[int] = None, *, stage: Union[str, int] = "",
                   controllers: Optional[Controllers] = None, interval: float = 0.1) -> Simulation:
        """A dynamic analysis advanced step by step, from the static state before the build-up. It writes no files.

        Args:
            duration: '600 s' or a number of seconds, instead of the model's duration.
            seed: Seed of the waves; the model's first if omitted.
            stage: Stage of an operation, by name or number from 1.
            controllers: As in dynamic(). A mooring line with None accepts commands by `sim.command()` only; the tensioner
                always accepts them.
            interval: Time between calls of controller functions [s].

        Raises:
            NoSolution: If there is no static equilibrium.
            ModelError: If the input, or a machine to be controlled, cannot be used.
        """
        return simulate(self._core, str(stage), duration, seed, given_controllers(controllers, interval))

    def seeds(self, seeds: Union[int, Iterable[int]], duration: Time = None, out: Optional[PathLike] = None, *,
              stage: Union[str, int] = "", threads: int = 0, resume: bool = False, restart: bool = False,
              checkpoint: float = 30.0, progress: Union[bool, Progress] = False) -> SeedsResults:
        """Runs several realisations of the same sea in parallel.

        Args:
            seeds: The seeds, or their number: 5 for 1 to 5.
            threads: Number of parallel runs; 0: one per core.

        Other arguments and exceptions are those of dynamic(). A failed run does not stop the others: `failed` of the results
        lists it.
        """
        chosen = require_seeds(range(1, seeds + 1) if isinstance(seeds, int) else seeds)
        folder, holder = self._run(out, stage=str(stage), duration=seconds(duration), seeds=chosen, several=True,
                                   threads=threads, resume=resume, restart=restart, checkpoint=checkpoint,
                                   progress=progress)
        return SeedsResults(folder, self, holder)

    def compare(self, of: str = "tensioner", duration: Time = None, out: Optional[PathLike] = None, *, threads: int = 0,
                resume: bool = False, restart: bool = False, checkpoint: float = 30.0,
                progress: Union[bool, Progress] = False) -> ComparisonResults:
        """Runs variants of the model in the same sea: tensioner off, controlled and constant; rollers and gap springs; or
        impacts resolved and captured.

        Args:
            of: 'tensioner', 'contact' or 'impacts'.

        Other arguments are those of dynamic() and seeds().
        """
        if of not in ("tensioner", "contact", "impacts"):
            raise ValueError(f"of: found {of!r}, expected 'tensioner', 'contact' or 'impacts'")
        folder, holder = self._run(out, of=of, duration=seconds(duration), threads=threads, resume=resume,
                                   restart=restart, checkpoint=checkpoint, progress=progress)
        return ComparisonResults(folder, self, holder)

    def operation(self, progress: Optional[StageProgress] = None) -> "OperationResults":
        """Solves the stages of the operation in sequence, each from the previous one.

        Args:
            progress: Called at intervals with the number of stages done, of all stages, and the name of the last one.

        Raises:
            ModelError: If the model has no operation.
        """
        from .operation import OperationResults

        return OperationResults(_core.Operation(self._core, progress), self)

    def lay_table(self, vary: Optional[str] = None, from_: Optional[str] = None, to: Optional[str] = None,
                  step: Optional[str] = None, steps: Optional[int] = None, *, depths: "Depths" = None,
                  least: bool = False, progress: "Optional[RowProgress]" = None) -> "LayTable":
        """Solves a lay table: one quantity in steps, or the points of a route.

            model.lay_table('tension', from_='200 kN', to='400 kN', step='20 kN').table['lay_back']

        Args:
            vary: 'tension' at the tensioner, 'lay_back' or water 'depth'; if omitted, as the model's key `lay_table` says,
                otherwise tension.
            from_, to: Smallest and largest value, with units; if omitted, they follow from the model's own solution.
            step: Increment between rows, or
            steps: Number of increments; there is one row more.
            depths: Instead of these, water depths along a route: pairs of distance and depth [m], or a CSV file with the
                columns distance_m or kp_km and depth_m.
            least: Along a route, uses the smallest tension at which every governing check is passed, at every point.
            progress: Called at intervals with the number of rows done and requested.

        Raises:
            ModelError: If a value is invalid.
        """
        from .lay_table import lay_table

        return lay_table(self, vary, from_, to, step, steps, depths, least, progress)

    def sensitivities(self, keys: Optional[Iterable[str]] = None, *, stage: Union[str, int] = "",
                      one_sided: bool = True) -> "Sensitivities":
        """Derivatives of all static results with respect to numbers of the model file, at the equilibrium.

        Args:
            keys: Keys with indices or names of items, 'supports.stinger.boxes[stinger 3].z'; every number in the file if
                omitted.
            stage: Stage of an operation, by name or number from 1.
            one_sided: True to include contacts that open or close within the tolerance of an input.

        Raises:
            NoSolution: If there is no equilibrium, or it is about to snap through.
            ModelError: If a key is not a number of the file.
        """
        from .sensitivities import Sensitivities, require_keys

        chosen = list(keys or [])
        content = _core.sensitivities(self._core, str(stage), chosen, one_sided)
        require_keys(content, chosen)
        return Sensitivities(content)

    def _run(self, out: Optional[PathLike], progress: Union[bool, Progress], **settings: Any) -> tuple[pathlib.Path, Any]:
        holder = TemporaryFolder() if out is None else None
        folder = holder.path / "results" if holder else pathlib.Path(os.fspath(out))  # type: ignore[arg-type]
        report, end = follower(progress)
        try:
            outcome = _core.run(self._core, str(folder), progress=report, **settings)
        finally:
            end()
        if outcome["interrupted"]:
            if holder:
                holder.keep()
            raise Interrupted(f"interrupted; model.dynamic(out='{folder}', resume=True) resumes it", folder)
        return folder, holder

    def __repr__(self) -> str:
        return f"<Model '{self.title}', {self.file}>"
