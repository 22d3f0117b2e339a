"""Units in which figures show SI values: those of the reports."""

from __future__ import annotations

from typing import NamedTuple

from .. import _core


class Shown(NamedTuple):
    """A display unit: an SI value times `factor` is in `unit`, usually written with `digits` decimals."""

    unit: str
    factor: float
    digits: int


def shown(name: str, units: str) -> Shown:
    """Returns the display unit of the quantity `name` with the SI unit `units`: see overbend.use_units()."""
    return Shown(*_core.shown_unit(name, units))


def small() -> Shown:
    """Returns the display unit of gaps and other small lengths: millimetres or inches."""
    return Shown(*_core.section_length())


def with_unit(name: str, unit: str) -> str:
    """Returns a label such as "Tension [kN]"; the name alone for plain numbers."""
    return f"{name} [{unit}]" if unit else name


_DISPLAY_NAMES = {"von_mises": "von Mises stress"}


def display_name(name: str) -> str:
    """Returns the name of a quantity or a history in words: "Bending moment", "Support, stinger 8, reaction"."""
    return _DISPLAY_NAMES.get(name, (name[:1].upper() + name[1:]).replace("_", " ").replace("/", ", "))
