"""Models from files of other programs."""

from __future__ import annotations

import dataclasses
import os
from typing import Optional, Union

from . import _core
from .model import Model

PathLike = Union[str, "os.PathLike[str]"]


@dataclasses.dataclass(frozen=True)
class ImportAccount:
    """What an import did with the data of a file."""

    translated: list[str]
    approximated: list[str]  #: With how, and by how much.
    left_out: list[tuple[str, bool]]  #: Each with whether results may depend on it.

    @property
    def is_complete(self) -> bool:
        """False if something was left out that results may depend on."""
        return not any(matters for _, matters in self.left_out)


@dataclasses.dataclass(frozen=True)
class Imported:
    """A translated model, with the account of the translation."""

    model: Model
    account: ImportAccount


def import_orcaflex(file: PathLike, *, folder: PathLike = ".", yield_stress: Optional[float] = None) -> Imported:
    """Translates an OrcaFlex text data file (.yml), with the files that it includes, into a model.

    Args:
        file: The file.
        folder: Folder of the model, from which it refers to files with RAOs.
        yield_stress: Yield stress of the steel of pipes of which the file has none [Pa].

    Raises:
        ModelError: If the file is damaged or ambiguous, with file, line and key of each error.
    """
    path = os.fspath(file)
    text, translated, approximated, left_out = _core.import_orcaflex(path, os.fspath(folder), yield_stress)
    name = os.path.splitext(os.path.basename(path))[0] + ".yaml"
    model = Model.from_text(text, os.path.join(os.fspath(folder), name))
    return Imported(model, ImportAccount(translated, approximated, left_out))
