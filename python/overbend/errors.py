"""Exceptions of the package: all are an `OverbendError`, except `Interrupted`."""

from __future__ import annotations

import pathlib
from dataclasses import dataclass
from typing import Any, Mapping, Sequence


class OverbendError(Exception):
    """Base class of the exceptions of this package."""


@dataclass(frozen=True)
class Fault:
    """One error in a model file.

    Attributes:
        message: The message in one line, as the command line prints it.
        file: Name of the file as given.
        line: Line number from 1; 0 if the error has no location.
        column: Column number from 1; 0 likewise.
        key: Full path of the key, "pipe.steel.wall_thickness".
        found: Value found.
        expected: Value expected.
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

    `faults` lists all errors; `file`, `line`, `column`, `key`, `found`, `expected` and `hint` are those of the first.
    """

    def __init__(self, sentence: str | None, faults: Sequence[Mapping[str, Any]] = ()):
        self.faults: tuple[Fault, ...] = tuple(Fault(**error) for error in faults)
        super().__init__(sentence or "\n".join(error.message for error in self.faults))
        first = self.faults[0] if self.faults else Fault(sentence or "")
        self.file, self.line, self.column, self.key = first.file, first.line, first.column, first.key
        self.found, self.expected, self.hint = first.found, first.expected, first.hint


class NoSolution(OverbendError):
    """There is no equilibrium, or a time step cannot be solved.

    Attributes:
        what: Description of the failure, in one sentence.
        where: Location along the line, or time; empty if it concerns the whole.
        why: Reason and remedy.
    """

    def __init__(self, what: str, where: str = "", why: str = ""):
        self.what, self.where, self.why = what, where, why
        super().__init__(what + (f" ({where})" if where else "") + (f": {why}" if why else ""))


class ControllerError(OverbendError, ValueError):
    """A controller returned a command that its machine cannot execute.

    Attributes:
        what: The controller, in one sentence.
        where: The time.
        why: The error in the command.
    """

    def __init__(self, what: str, where: str = "", why: str = ""):
        self.what, self.where, self.why = what, where, why
        super().__init__(what + (f" ({where})" if where else "") + (f": {why}" if why else ""))


class ResultsError(OverbendError):
    """A folder or a file of results that cannot be read or written."""


class Interrupted(KeyboardInterrupt):
    """A run was stopped by Ctrl-C. It can be resumed from the checkpoint in its folder.

    Attributes:
        folder: Folder of the checkpoint; give it as `out` with `resume=True` to resume the run.
    """

    def __init__(self, sentence: str, folder: pathlib.Path):
        self.folder = folder
        super().__init__(sentence)
