"""Results of a study over its axes, in the units that figures show."""

from __future__ import annotations

import warnings
from typing import Any, Callable, Mapping, Optional, Sequence

import numpy as np

from .units import shown, with_unit


class Axis:
    """Values of a key in the unit that figures show; names are at 0, 1, 2, ..."""

    def __init__(self, key: str, coordinate: Any) -> None:
        """
        Args:
            coordinate: Numbers with their unit in `attrs` [SI], or names.
        """
        values = np.asarray(coordinate)
        self.key, self.stored = key, values
        self.unit, factor, _ = shown(key, str(getattr(coordinate, "attrs", {}).get("units", "1")))
        self.numbers = values.dtype.kind in "fiu"
        self.positions = factor * values.astype(float) if self.numbers else np.arange(len(values), dtype=float)
        plain = [f"{value:g}" for value in self.positions] if self.numbers else [str(value) for value in values]
        self.labels = [f"{word} {self.unit}".rstrip() for word in plain]
        self.label = with_unit(key, self.unit) if self.numbers else key

    def ticks(self, axis: Any) -> None:
        """Names instead of numbers on an axis of matplotlib."""
        if not self.numbers:
            axis.set_ticks(self.positions, self.labels)

    def edges(self) -> np.ndarray:
        """Borders of cells around the values; half way between them."""
        if len(self.positions) == 1:
            return self.positions[0] + np.array([-0.5, 0.5])
        middle = 0.5 * (self.positions[1:] + self.positions[:-1])
        return np.concatenate([[2 * self.positions[0] - middle[0]], middle, [2 * self.positions[-1] - middle[-1]]])

    def nearest(self, value: Any) -> int:
        """Number of the value nearest to one given [SI], or of a name."""
        if not self.numbers:
            names = [str(name) for name in self.stored]
            if str(value) not in names:
                raise ValueError(f"{self.key}: found {value!r}, expected one of {', '.join(names)}")
            return names.index(str(value))
        return int(np.abs(self.stored - float(value)).argmin())


class Grid:
    """A column of a study's table over its axes; seeds are the last dimension, of length 1 for a single seed."""

    def __init__(self, study: Any, result: str) -> None:
        array = study.grid(result)
        self.unit, factor, _ = shown(result, array.attrs["units"])
        self.result = result
        self._values = factor * self._seeds_last(array)
        self._passed = self._seeds_last(study.grid("passed")).astype(bool)
        self._axes = [Axis(str(key), array.coords[key]) for key in array.dims if key != "seed"]

    @staticmethod
    def _seeds_last(array: Any) -> np.ndarray:
        values = np.asarray(array, dtype=float)
        return np.moveaxis(values, array.dims.index("seed"), -1) if "seed" in array.dims else values[..., np.newaxis]

    def axis(self, key: str) -> Axis:
        """The axis of a key. Raises: KeyError if there is none."""
        for axis in self._axes:
            if axis.key == key:
                return axis
        raise KeyError(f"the study has no axis '{key}'; there are: {', '.join(axis.key for axis in self._axes)}")

    def other_than(self, keys: Sequence[str], selected: Optional[Mapping[str, Any]], first: bool = False) -> Optional[str]:
        """The axis with several values that is neither among `keys` nor selected by `selected`; None if there is none.

        Raises: ValueError where there are several, unless the `first` of them will do.
        """
        taken = {*keys, *(selected or {})}
        free = [axis.key for axis in self._axes if len(axis.positions) > 1 and axis.key not in taken]
        if len(free) > 1 and not first:
            named = ", ".join(map(repr, free))
            raise ValueError(f"found further axes {named}, expected one: choose with by=KEY, at={{KEY: value}}")
        return free[0] if free else None

    def take(self, keys: Sequence[str], selected: Optional[Mapping[str, Any]], of: Optional[np.ndarray] = None) -> np.ndarray:
        """Values over the axes of `keys`, in that order, and seeds. Other axes are at the values of `selected`."""
        values = self._values if of is None else of
        for key in [*keys, *(selected or {})]:
            self.axis(key)
        rest = self.other_than(keys, selected)
        if rest is not None:
            raise ValueError(f"found a further axis {rest!r}, expected its value: at={{{rest!r}: value}}")
        for number in reversed(range(len(self._axes))):
            axis = self._axes[number]
            if axis.key not in keys:
                chosen = axis.nearest(selected[axis.key]) if selected and axis.key in selected else 0
                values = np.take(values, chosen, axis=number)
        kept = [axis.key for axis in self._axes if axis.key in keys]
        return np.transpose(values, [*(kept.index(key) for key in keys), len(kept)])

    def passed(self, keys: Sequence[str], selected: Optional[Mapping[str, Any]]) -> np.ndarray:
        """True where all seeds of a case pass every governing check, over the axes of `keys`."""
        good: np.ndarray = self.take(keys, selected, self._passed).all(axis=-1)
        return good

    @staticmethod
    def over_seeds(values: np.ndarray, rule: Callable[..., np.ndarray]) -> np.ndarray:
        """One value of all seeds; NaN if there is none."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", RuntimeWarning)  # of cases without any value
            return rule(values, axis=-1)
