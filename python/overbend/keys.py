"""Values of model keys, as YAML."""

from __future__ import annotations

import itertools
import math
import numbers
from typing import Any, Iterable, Mapping, Optional, Union

import numpy as np

from . import _core
from .errors import ModelError
from .values import Number

#: A time: seconds, or a string with unit; None if omitted.
Time = Union[str, float, int, None]
#: As in a model file: the largest seed, and how many there may be.
MAX_SEED, MAX_SEEDS = 9_000_000_000_000_000, 10_000
Change = tuple[str, str, str]  # key, 'scalar' or 'flow' or 'remove', value


def make_changes(keys: Mapping[str, Any]) -> list[Change]:
    """Changes that write values into the text of a model.

    Args:
        keys: Values by model key: strings with units ("260 kN"), results (a Number), numbers for keys without unit,
            booleans, lists and dicts of these for groups, None to remove the key.
    """
    return [make_change(key, value) for key, value in keys.items()]


def make_change(key: str, value: Any) -> Change:
    """The change of one key."""
    if value is None:
        return key, "remove", ""
    if isinstance(value, (Mapping, list, tuple, np.ndarray)):
        return key, "flow", flow(value, key)
    return key, "scalar", scalar(value, key)


def scalar(value: Any, key: str = "") -> str:
    """A single value as YAML; numbers with all digits."""
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, (str, numbers.Integral)):
        return str(value)
    if isinstance(value, Number) and value.units != "1":
        return f"{float(value)!r} {value.units}"
    if isinstance(value, numbers.Real):
        return repr(float(value))
    raise ModelError(f"{key}: found {value!r}, expected a text such as '260 kN', a number, a truth value, a list or a dict")


def flow(value: Any, key: str = "") -> str:
    """A list or a group in YAML's flow style, on one line."""
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{name}: {flow(item, key)}" for name, item in value.items()) + "}"
    if isinstance(value, (list, tuple, np.ndarray)):
        return "[" + ", ".join(flow(item, key) for item in value) + "]"
    if isinstance(value, str):
        from ._core import flow_scalar

        return flow_scalar(value)
    return scalar(value, key)


def bound(value: Any, what: str, unit: str) -> str:
    """A quantity as a string with unit; a result (a Number) has its own.

    Raises:
        ModelError: If a number has no unit.
    """
    if isinstance(value, str) or (isinstance(value, Number) and value.units != "1"):
        return scalar(value)
    raise ModelError(f"{what}: found {value!r} without a unit, expected a text with its unit, such as '{value!r} {unit}'")


def require_seeds(seeds: Iterable[Any]) -> list[int]:
    """Seeds of random waves: non-negative integers."""
    chosen = list(itertools.islice(seeds, MAX_SEEDS + 1))
    if len(chosen) > MAX_SEEDS:
        raise ModelError(f"seeds: found more than {MAX_SEEDS} of them, expected fewer")
    for seed in chosen:
        whole = isinstance(seed, numbers.Integral) or (isinstance(seed, numbers.Real) and float(seed).is_integer())
        if not whole or not 0 <= seed <= MAX_SEED:
            raise ModelError(f"seeds: found {seed!r}, expected whole numbers from 0 to {MAX_SEED}")
    return [int(seed) for seed in chosen]


def seconds(duration: Time) -> Optional[float]:
    """A duration in seconds; None if omitted."""
    if duration is None:
        return None
    value = _core.quantity(duration, "s") if isinstance(duration, str) else float(duration)
    if not 0.0 < value < math.inf:
        raise ModelError(f"duration: found {duration!r}, expected a time such as '600 s'")
    return value
