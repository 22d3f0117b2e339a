"""Units in which figures show SI values: those of the reports."""

from __future__ import annotations

from typing import NamedTuple

from .. import _core


class Shown(NamedTuple):
    """A unit to read values in: an SI value times `factor` is in `unit`, usually written with `digits` decimals."""

    unit: str
    factor: float
    digits: int


def shown(name: str, units: str) -> Shown:
    """Returns how the quantity `name`, kept in the SI unit `units`, is shown: see overbend.use_units()."""
    return Shown(*_core.shown_unit(name, units))


def small() -> Shown:
    """Returns how gaps and other small lengths are shown: in millimetres or inches."""
    return Shown(*_core.section_length())


def with_unit(name: str, unit: str) -> str:
    """Returns a label such as "Tension [kN]"; the name alone for plain numbers."""
    return f"{name} [{unit}]" if unit else name


_WORDS = {"von_mises": "von Mises stress"}


def words_of(name: str) -> str:
    """Returns the name of a quantity or a history in words: "Bending moment", "Support, stinger 8, reaction"."""
    return _WORDS.get(name, (name[:1].upper() + name[1:]).replace("_", " ").replace("/", ", "))
