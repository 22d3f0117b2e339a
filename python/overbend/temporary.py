"""Folders for results that nobody asked to keep."""

from __future__ import annotations

import pathlib
import shutil
import tempfile
import weakref


class TemporaryFolder:
    """A new folder that goes, with all that is in it, when nobody holds this any more, at the end of Python at the latest."""

    def __init__(self) -> None:
        self.path = pathlib.Path(tempfile.mkdtemp(prefix="overbend-"))
        self._end = weakref.finalize(self, shutil.rmtree, self.path, ignore_errors=True)

    def keep(self) -> None:
        """The folder stays."""
        self._end.detach()
