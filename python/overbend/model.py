"""Models: read, changed, solved."""

from __future__ import annotations

import os
import pathlib
from typing import TYPE_CHECKING, Any, Callable, Iterable, Mapping, Optional, Union

from . import _core
from .controllers import Controllers, given_controllers
from .dynamic_results import DynamicResults
from .errors import Interrupted, ModelError
from .findings import Finding, findings_of
from .keys import Time, changes_of, seconds, seeds_of
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
    """A model file as it was read. It does not change: `with_` gives another one."""

    def __init__(self, core: "_core.Model"):
        """Not for users: see `read` and `from_text`."""
        if not isinstance(core, _core.Model):
            raise TypeError(f"Model(...): found {core!r}; a model is made by Model.read(path) or Model.from_text(text)")
        self._core = core

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickled and copied as its text, for pools of processes."""
        return Model.from_text, (self.text, self.file)

    def __copy__(self) -> "Model":
        """The same: a model does not change."""
        return self

    def __deepcopy__(self, memo: Any) -> "Model":
        """The same: a model does not change."""
        return self

    @classmethod
    def read(cls, path: PathLike) -> "Model":
        """The model of a file.

        Raises:
            ModelError: With file, line and key of everything that is wrong.
        """
        return cls(_core.Model.read(os.fspath(path)))

    @classmethod
    def from_text(cls, text: str, file: PathLike = "model.yaml") -> "Model":
        """The model of a text.

        Args:
            text: As a model file has it.
            file: Names the text in messages; files that it mentions lie beside this one.

        Raises:
            ModelError: As of read().
        """
        return cls(_core.Model.from_text(text, os.fspath(file)))

    @property
    def text(self) -> str:
        """The text of the model file; with changed keys, comments and layout kept."""
        return self._core.text

    @property
    def file(self) -> str:
        """Path of the file as it was given."""
        return self._core.file

    @property
    def title(self) -> str:
        """The title in the model."""
        return self._core.title

    @property
    def findings(self) -> list[Finding]:
        """Unusual input that was accepted, and what the model alone shows."""
        return findings_of(self._core.findings)

    @property
    def warnings(self) -> list[str]:
        """The messages of the findings."""
        return [finding.message for finding in self.findings]

    @property
    def assumptions(self) -> list[str]:
        """What was assumed where the file says nothing."""
        return self._core.assumptions

    def with_(self, changes: Optional[Mapping[str, Any]] = None, /, **keys: Any) -> "Model":
        """The model with keys set anew, one after the other.

        Args:
            changes: Values by key: 'tensioner.tension', 'supports.stinger.boxes[stinger 3].z'; items of lists by index
                from 0, name or pattern (`stinger *`). A value is a text with its unit ('260 kN'), a number where the key
                has no unit, a truth value, a list or dict of these for a whole group, None to remove the key.
            keys: The same: with_(title='Another').

        Raises:
            ModelError: Where a key is unknown or a value cannot be.
        """
        return Model(self._core.changed(changes_of({**(changes or {}), **keys})))

    def get(self, key: str, default: Any = None) -> Any:
        """What the text has for a key: a text such as '260 kN', a list or a dict; `default` where it is left out."""
        value = self._core.value(key)
        return default if value is None else value

    def __getitem__(self, key: str) -> Any:
        value = self._core.value(key)
        if value is None:
            raise KeyError(f"the model's text has no '{key}'")
        return value

    def to_dict(self) -> dict[str, Any]:
        """The keys and texts of the file as nested dicts and lists."""
        return self._core.tree

    def write(self, path: PathLike, overwrite: bool = False) -> pathlib.Path:
        """Writes the model to a file. In another folder, files that the model names are named from there.

        Raises:
            FileExistsError: Where the file is there and is not to be overwritten.
        """
        target = pathlib.Path(path)
        text = self._core.moved(str(target.parent))
        with target.open("w" if overwrite else "x", encoding="utf-8") as stream:
            stream.write(text)
        return target

    def static(self, start: Optional[StaticResults] = None, stage: Union[str, int] = "") -> StaticResults:
        """The static equilibrium with its code checks.

        Args:
            start: An equilibrium close by, from which this one is found in a few iterations. Results agree with those found
                from nothing to the accuracy of statics, as long as there is one equilibrium only: across a current there may
                be several, and the one that is found then depends on the start.
            stage: Of an operation on the line, by name or number from 1.

        Raises:
            NoSolution: Where there is no equilibrium, with the reason.
            ModelError: Where the model asks for what is not computed.
        """
        return StaticResults(_core.Statics(self._core, str(stage), start._solved if start is not None else None), self)

    def dynamic(self, duration: Time = None, seed: Optional[int] = None, out: Optional[PathLike] = None, *,
                stage: Union[str, int] = "", resume: bool = False, restart: bool = False, checkpoint: float = 30.0,
                controllers: Optional[Controllers] = None, interval: float = 0.1,
                progress: Union[bool, Progress] = False) -> DynamicResults:
        """A dynamic analysis: one run in time.

        Other threads of Python go on meanwhile. Ctrl-C ends the run at a checkpoint.

        Args:
            duration: '600 s' or a number of seconds, in place of the model's.
            seed: Of the waves; left out the model's first.
            out: Folder for the results, as `overbend dynamic -o` writes them. Left out: a temporary folder, which goes when
                the results do; their save() keeps them.
            stage: Of an operation on the line, by name or number from 1.
            resume: Goes on with an unfinished run in `out`, where there is one.
            restart: Begins anew where there is one.
            checkpoint: Time between checkpoints [s].
            controllers: Functions that drive machines, by 'tensioner' or the name of a mooring line for its winch; see
                controllers.Controller. A run that was begun with some is resumed with some for the same machines.
            interval: For whose multiples functions are asked [s].
            progress: True for a line on the terminal, or a function (see progress.Progress), called ten times a second.

        Raises:
            Interrupted: After Ctrl-C, with the folder from which the run can go on.
            NoSolution: Where statics or a time step cannot be solved.
            ControllerError: Where a controller answers what its machine cannot do. What a controller raises comes as it is.
            ModelError, ResultsError: Where the input or the folder cannot be used.
        """
        folder, holder = self._run(out, stage=str(stage), duration=seconds(duration), resume=resume, restart=restart,
                                   seeds=[] if seed is None else seeds_of([seed]), checkpoint=checkpoint, progress=progress,
                                   controllers=given_controllers(controllers, interval))
        return DynamicResults(folder, self, holder)

    def simulation(self, duration: Time = None, seed: Optional[int] = None, *, stage: Union[str, int] = "",
                   controllers: Optional[Controllers] = None, interval: float = 0.1) -> Simulation:
        """A dynamic analysis that goes on step by step, from rest before the build-up of the sea. It writes no files.

        Args:
            duration: '600 s' or a number of seconds, in place of the model's.
            seed: Of the waves; left out the model's first.
            stage: Of an operation on the line, by name or number from 1.
            controllers: As of dynamic(). A mooring line with None takes commands by `sim.command()` alone; the tensioner
                takes them always.
            interval: For whose multiples functions are asked [s].

        Raises:
            NoSolution: Where there is no equilibrium to begin with.
            ModelError: Where the input, or a machine that is to be controlled, cannot be used.
        """
        return simulate(self._core, str(stage), duration, seed, given_controllers(controllers, interval))

    def seeds(self, seeds: Union[int, Iterable[int]], duration: Time = None, out: Optional[PathLike] = None, *,
              stage: Union[str, int] = "", threads: int = 0, resume: bool = False, restart: bool = False,
              checkpoint: float = 30.0, progress: Union[bool, Progress] = False) -> SeedsResults:
        """Several realisations of the same sea side by side.

        Args:
            seeds: The seeds, or how many: 5 for 1 to 5.
            threads: Runs at the same time; 0: as many as there are cores.

        The others as of dynamic(), which also says what is raised. A run that fails does not stop the others: `failed` of the
        results lists it.
        """
        chosen = seeds_of(range(1, seeds + 1) if isinstance(seeds, int) else seeds)
        folder, holder = self._run(out, stage=str(stage), duration=seconds(duration), seeds=chosen, several=True,
                                   threads=threads, resume=resume, restart=restart, checkpoint=checkpoint,
                                   progress=progress)
        return SeedsResults(folder, self, holder)

    def compare(self, of: str = "tensioner", duration: Time = None, out: Optional[PathLike] = None, *, threads: int = 0,
                resume: bool = False, restart: bool = False, checkpoint: float = 30.0,
                progress: Union[bool, Progress] = False) -> ComparisonResults:
        """Variants of the model in the same sea: the tensioner off, controlled and constant, rollers against gap springs, or
        impacts resolved and captured.

        Args:
            of: 'tensioner', 'contact' or 'impacts'.

        The others as of dynamic() and seeds().
        """
        if of not in ("tensioner", "contact", "impacts"):
            raise ValueError(f"of: found {of!r}, expected 'tensioner', 'contact' or 'impacts'")
        folder, holder = self._run(out, of=of, duration=seconds(duration), threads=threads, resume=resume,
                                   restart=restart, checkpoint=checkpoint, progress=progress)
        return ComparisonResults(folder, self, holder)

    def operation(self, progress: Optional[StageProgress] = None) -> "OperationResults":
        """Solves the stages of the operation on the line one after the other, each from the one before.

        Args:
            progress: Called now and then with stages done, stages, and the name of the last one.

        Raises:
            ModelError: Where the model has no operation on the line.
        """
        from .operation import OperationResults

        return OperationResults(_core.Operation(self._core, progress), self)

    def lay_table(self, vary: Optional[str] = None, from_: Optional[str] = None, to: Optional[str] = None,
                  step: Optional[str] = None, steps: Optional[int] = None, *, depths: "Depths" = None,
                  least: bool = False, progress: "Optional[RowProgress]" = None) -> "LayTable":
        """A table of lays: one quantity in steps, or the points of a route.

            model.lay_table('tension', from_='200 kN', to='400 kN', step='20 kN').table['lay_back']

        Args:
            vary: 'tension' at the tensioner, 'lay_back' or 'depth' of the water; left out what the model's key
                `lay_table` says, else tension.
            from_, to: The least and the largest value, with units; left out they follow from the model's own lay.
            step: Difference of neighbouring rows, or
            steps: number of steps; rows are one more.
            depths: In place of these, water depths along a route: pairs of distance and depth [m], or a CSV file with
                the columns distance_m or kp_km and depth_m.
            least: Along a route with the least tension with which every governing check is passed, at every point.
            progress: Called now and then with rows done and rows asked for.

        Raises:
            ModelError: Where a value cannot be.
        """
        from .lay_table import lay_table

        return lay_table(self, vary, from_, to, step, steps, depths, least, progress)

    def sensitivities(self, keys: Optional[Iterable[str]] = None, *, stage: Union[str, int] = "",
                      one_sided: bool = True) -> "Sensitivities":
        """The derivatives of all results of statics by numbers of the model file, at its equilibrium.

        Args:
            keys: Keys with indices or names of items, 'supports.stinger.boxes[stinger 3].z'; left out every number that
                the file has.
            stage: Of an operation on the line, by name or number from 1.
            one_sided: Whether contacts that open or close within the tolerance of an input are looked at.

        Raises:
            NoSolution: Where there is no equilibrium, or it is about to snap to another place.
            ModelError: Where a key is none of these.
        """
        from .sensitivities import Sensitivities, require_keys

        chosen = list(keys or [])
        told = _core.sensitivities(self._core, str(stage), chosen, one_sided)
        require_keys(told, chosen)
        return Sensitivities(told)

    def _run(self, out: Optional[PathLike], progress: Union[bool, Progress], **wish: Any) -> tuple[pathlib.Path, Any]:
        holder = TemporaryFolder() if out is None else None
        folder = holder.path / "results" if holder else pathlib.Path(os.fspath(out))  # type: ignore[arg-type]
        tell, end = follower(progress)
        try:
            told = _core.run(self._core, str(folder), progress=tell, **wish)
        finally:
            end()
        if told["interrupted"]:
            if holder:
                holder.keep()
            raise Interrupted(f"interrupted; model.dynamic(out='{folder}', resume=True) goes on", folder)
        return folder, holder

    def __repr__(self) -> str:
        return f"<Model '{self.title}', {self.file}>"
