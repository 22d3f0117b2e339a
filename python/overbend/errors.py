"""The errors of the package: every one is an `OverbendError`, but for `Interrupted`."""

from __future__ import annotations

import pathlib
from dataclasses import dataclass
from typing import Any, Mapping, Sequence


class OverbendError(Exception):
    """Whatever goes wrong in here."""


@dataclass(frozen=True)
class Fault:
    """One thing that is wrong in a model file.

    Attributes:
        message: The whole in one line, as the command line prints it.
        file: Name of the file, as it was given.
        line: Line from 1; 0 where it belongs to no place.
        column: Column from 1; 0 likewise.
        key: Full path of the key, "pipe.steel.wall_thickness".
        found: What was found.
        expected: What should have been.
        hint: How to correct it; may be empty.
    """

    message: str
    file: str = ""
    line: int = 0
    column: int = 0
    key: str = ""
    found: str = ""
    expected: str = ""
    hint: str = ""


class ModelError(OverbendError, ValueError):
    """A model, or a key or value given for one, that cannot be used.

    `faults` has all that is wrong; `file`, `line`, `column`, `key`, `found`, `expected` and `hint` are those of the first.
    """

    def __init__(self, sentence: str | None, faults: Sequence[Mapping[str, Any]] = ()):
        self.faults: tuple[Fault, ...] = tuple(Fault(**fault) for fault in faults)
        super().__init__(sentence or "\n".join(fault.message for fault in self.faults))
        first = self.faults[0] if self.faults else Fault(sentence or "")
        self.file, self.line, self.column, self.key = first.file, first.line, first.column, first.key
        self.found, self.expected, self.hint = first.found, first.expected, first.hint


class NoSolution(OverbendError):
    """There is no equilibrium, or a time step cannot be solved.

    Attributes:
        what: What went wrong, in one sentence.
        where: Place along the line or instant; empty where it is the whole.
        why: The reason, and what would mend it.
    """

    def __init__(self, what: str, where: str = "", why: str = ""):
        self.what, self.where, self.why = what, where, why
        super().__init__(what + (f" ({where})" if where else "") + (f": {why}" if why else ""))


class ControllerError(OverbendError, ValueError):
    """A controller answered what its machine cannot do.

    Attributes:
        what: Which controller, in one sentence.
        where: The instant.
        why: What is wrong with the answer.
    """

    def __init__(self, what: str, where: str = "", why: str = ""):
        self.what, self.where, self.why = what, where, why
        super().__init__(what + (f" ({where})" if where else "") + (f": {why}" if why else ""))


class ResultsError(OverbendError):
    """A folder or a file of results that cannot be read or written."""


class Interrupted(KeyboardInterrupt):
    """A run that Ctrl-C stopped. A checkpoint is in its folder, from which it goes on.

    Attributes:
        folder: Where the checkpoint is; given as `out` with `resume=True` the run goes on.
    """

    def __init__(self, sentence: str, folder: pathlib.Path):
        self.folder = folder
        super().__init__(sentence)
