"""Temporary folders for results."""

from __future__ import annotations

import pathlib
import shutil
import tempfile
import weakref


class TemporaryFolder:
    """A new folder, deleted with its content together with this object, at the latest when Python ends."""

    def __init__(self) -> None:
        self.path = pathlib.Path(tempfile.mkdtemp(prefix="overbend-"))
        self._end = weakref.finalize(self, shutil.rmtree, self.path, ignore_errors=True)

    def keep(self) -> None:
        """Keeps the folder."""
        self._end.detach()
