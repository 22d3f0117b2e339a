"""Units in which figures show SI values: those of the reports (kN, kN m, MPa, deg, %, mm)."""

from __future__ import annotations

import math
from typing import NamedTuple


class Shown(NamedTuple):
    """A unit to read values in: an SI value times `factor` is in `unit`, usually written with `digits` decimals."""

    unit: str
    factor: float
    digits: int


_OF_UNIT = {
    "N": Shown("kN", 1e-3, 1),
    "N m": Shown("kN m", 1e-3, 1),
    "N/m": Shown("kN/m", 1e-3, 1),
    "N s": Shown("kN s", 1e-3, 3),
    "Pa": Shown("MPa", 1e-6, 1),
    "J": Shown("kJ", 1e-3, 3),
    "rad": Shown("deg", 180 / math.pi, 2),
    "rad/s": Shown("deg/s", 180 / math.pi, 3),
    "m": Shown("m", 1.0, 3),
    "s": Shown("s", 1.0, 4),
    "1": Shown("", 1.0, 6),
    "-": Shown("", 1.0, 6),
}

# Quantities that are read in a unit of their own: those whose name holds the word.
_OF_NAME = [
    ("strain", "1", Shown("%", 1e2, 4)),
    ("contact_share", "1", Shown("%", 1e2, 1)),
    ("dent_depth", "m", Shown("mm", 1e3, 3)),
]


def shown(name: str, units: str) -> Shown:
    """Returns how the quantity `name`, kept in the SI unit `units`, is shown."""
    for word, of, own in _OF_NAME:
        if word in name and units == of:
            return own
    return _OF_UNIT.get(units, Shown(units, 1.0, 3))


def with_unit(name: str, unit: str) -> str:
    """Returns a label such as "Tension [kN]"; the name alone for plain numbers."""
    return f"{name} [{unit}]" if unit else name


_WORDS = {"von_mises": "von Mises stress"}


def words_of(name: str) -> str:
    """Returns the name of a quantity or a history in words: "Bending moment", "Support, stinger 8, reaction"."""
    return _WORDS.get(name, (name[:1].upper() + name[1:]).replace("_", " ").replace("/", ", "))
