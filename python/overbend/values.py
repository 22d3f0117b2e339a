"""Numbers and arrays with units."""

from __future__ import annotations

import functools
from typing import Any, Mapping, Sequence

import numpy as np

_use_xarray = True


class Number(float):
    """A float with unit and description [SI].

    Attributes:
        units: SI unit as in results.h5: "N", "Pa", "rad"; "1" for a plain number.
        description: Description of the quantity.
    """

    units: str
    description: str

    def __new__(cls, value: float, units: str = "1", description: str = "") -> "Number":
        number = super().__new__(cls, value)
        number.units = units
        number.description = description
        return number

    def to(self, unit: str) -> float:
        """The value in another unit of the same dimension: `static.top_tension.to('kN')`.

        Raises:
            ValueError: If the unit is unknown or of another dimension.
        """
        from ._core import quantity

        return float(self) / quantity(f"1 {unit}", self.units)

    def __getnewargs__(self) -> tuple[float, str, str]:  # type: ignore[override]
        return float(self), self.units, self.description


class LabelledArray(np.ndarray):
    """Replacement of xarray.DataArray if xarray is not installed: an array with `dims`, `coords`, `attrs`, `name`.

    Slices and results of arithmetic are plain arrays.
    """

    name: str
    dims: tuple[str, ...]
    coords: Mapping[str, np.ndarray]
    attrs: Mapping[str, str]

    def __new__(cls, values: Any, name: str, dims: Sequence[str], coords: Mapping[str, np.ndarray],
                attrs: Mapping[str, str]) -> "LabelledArray":
        array = np.asarray(values).view(cls)
        array.name, array.dims, array.coords, array.attrs = name, tuple(dims), dict(coords), dict(attrs)
        return array

    def __array_finalize__(self, source: Any) -> None:
        self.name, self.dims, self.coords, self.attrs = "", (), {}, {}

    def __array_wrap__(self, array: np.ndarray, context: Any = None) -> Any:
        return np.asarray(array)[()]

    def __getitem__(self, index: Any) -> Any:
        return np.asarray(self)[index]

    @property
    def values(self) -> np.ndarray:
        """The plain numpy array."""
        return np.asarray(self)


def stored_unit(unit: str) -> str:
    """The unit as written in results.h5: "Pa" for "N/m^2"."""
    return {"N*m": "N m", "N/m^2": "Pa", "m-1": "1/m"}.get(unit, unit)


def use_xarray(use: bool) -> None:
    """Selects xarray.DataArray for arrays (True, the default if xarray is installed) or LabelledArray (False)."""
    global _use_xarray
    _use_xarray = use


def use_units(system: str) -> None:
    """Selects the units of texts, text tables, reports and figures made from now on; numbers of results stay in SI.

    Args:
        system: 'metric' (kN, m, MPa), the default, or 'us' (kip, ft, ksi).

    Raises: ValueError for another value.
    """
    from . import _core

    _core.use_units(system)


@functools.cache
def _xarray() -> Any:
    try:
        import xarray
    except ImportError:
        return None
    return xarray


def xarray_module() -> Any:
    """The module xarray; None if it is not installed or not used."""
    return _xarray() if _use_xarray else None


def labelled(values: Any, name: str, dims: Sequence[str], coords: Mapping[str, Any], units: str = "1",
             description: str = "", frame: str = "") -> Any:
    """An array with labels: an xarray.DataArray, or a LabelledArray (see use_xarray).

    Args:
        values: Of shape (len of every dimension); not copied.
        name: Name of the quantity.
        dims: Names of its dimensions.
        coords: Arrays over them, each of one dimension of the same name.
        units: SI unit.
        description: Description of the quantity.
        frame: Frame of a vector's components; empty or "none" otherwise.
    """
    attrs = {"units": units, "description": description, "long_name": description}
    if frame and frame != "none":
        attrs["frame"] = frame
    xarray = xarray_module()
    if xarray is None:
        plain = {key: value if isinstance(value, LabelledArray) else np.asarray(value) for key, value in coords.items()}
        return LabelledArray(values, name, dims, plain, attrs)
    return xarray.DataArray(values, dims=tuple(dims), coords={key: (key, np.asarray(value), getattr(value, "attrs", {}))
                                                              for key, value in coords.items()}, name=name, attrs=attrs)
