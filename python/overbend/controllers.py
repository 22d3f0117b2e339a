"""Controllers of one's own for the tensioner and the winches of mooring lines."""

from __future__ import annotations

import ctypes
import numbers
import pathlib
from typing import Any, Callable, Mapping, Optional, Sequence, Union

from . import _core
from .errors import ModelError

#: What a controller sees; see overbend.controllers.Controller.
MachineReading = _core.MachineReading

#: Of a compiled controller: int f(const struct overbend_reading *seen, double *command, double *memory).
CONTROLLER_TYPE = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.POINTER(ctypes.c_double), ctypes.POINTER(ctypes.c_double),
                                   ctypes.POINTER(ctypes.c_double))


class SetTension(float):
    """A tension that a machine shall restore by its own law [N]: what a controller answers in place of a speed.

    Args:
        tension: In newtons, or a text with its unit: SetTension('250 kN').
    """

    def __new__(cls, tension: Union[float, str]) -> "SetTension":
        return super().__new__(cls, _core.quantity(tension, "N") if isinstance(tension, str) else tension)

    def __repr__(self) -> str:
        return f"SetTension({float(self):g} N)"


#: What a controller answers: a speed of paying out [m/s], a SetTension, or None: the machine works by its own law.
Command = Union[float, SetTension, None]
ControllerFunction = Callable[[float, MachineReading], Command]


class Controller:
    """What drives a machine of a run, and how often it is asked.

    A controller is a function `f(t, seen)` of the time [s] and of what the instruments show. It answers with what the
    machine shall do until it is asked again: a number is a speed of paying out [m/s], negative to haul in; a SetTension is
    a tension that the machine restores by its own law; None leaves it to that law. The machine goes to a speed within its
    acceleration and keeps it, within its velocity and its travel.

    It is asked for the multiples of its interval exactly. What it answers is in force from the end of the time step within
    which that instant falls; no step is longer than 1.25 intervals.

    `seen` has `time` [s], `tension` [N], `paid_out` [m], `speed` [m/s], `set_tension` [N], `length` of a mooring line [m],
    `guide_speed`, that of the guide or fairlead along the line [m/s], `vessel` and `vessel_velocity`: (6,) surge, sway,
    heave [m], roll, pitch, yaw [rad] and their rates (world axes).

    What a function remembers is its own affair as long as a run goes through. For one that is to be taken up again it may
    be an object with `save()`, which gives a list of numbers, and `restore(numbers)`.
    """

    def __init__(self, function: Union[ControllerFunction, Any], interval: float = 0.1, memory: Sequence[float] = ()):
        """
        Args:
            function: A function of Python, or a compiled one: from ctypes (of its address CONTROLLER_TYPE(address)) or from
                numba's `cfunc`; see overbend_controller.h in get_include().
            interval: It is asked for the multiples of this [s].
            memory: Of a compiled one: the numbers that its last argument points to at the start of a run.
        """
        self.interval = float(interval)
        self._function = function
        self._compiled = _compiled(function)
        self._memory = [float(value) for value in memory]
        self._core: Optional[_core.Controller] = None
        if self._compiled is None and not callable(function):
            raise TypeError(f"a controller is a function f(t, seen), found {function!r}")
        if self._compiled is None and self._memory:
            raise TypeError("memory is for compiled controllers; a function of Python remembers by itself")
        if hasattr(function, "save") != hasattr(function, "restore"):
            raise TypeError("a controller that has one of save() and restore() needs the other, too")

    @property
    def memory(self) -> list[float]:
        """What it remembers: of the last run, where it was in one."""
        return self._memory if self._core is None else self._core.memory

    def _given(self) -> _core.Controller:
        """For one run."""
        if self._compiled is not None:
            self._core = _core.Controller.compiled(self._compiled, self.interval, self._memory)
        else:
            self._core = _core.Controller(self._function, self.interval, getattr(self._function, "save", None),
                                          getattr(self._function, "restore", None))
        return self._core


#: By the machine: 'tensioner', or the name of a mooring line for its winch. None: the machine takes commands by calls.
Controllers = Mapping[str, Union[ControllerFunction, Controller, None]]


def given_controllers(controllers: Optional[Controllers], interval: float = 0.1) -> dict[str, _core.Controller]:
    """Controllers as the engine takes them, for one run; functions are asked every `interval` [s]."""
    given = {}
    for machine, one in (controllers or {}).items():
        if one is None:
            given[machine] = _core.Controller.by_calls()
        else:
            given[machine] = (one if isinstance(one, Controller) else Controller(one, interval))._given()
    return given


def get_include() -> str:
    """The folder of overbend_controller.h, which compiled controllers include."""
    folder = pathlib.Path(__file__).resolve().parent / "include"
    if not (folder / "overbend_controller.h").is_file():
        raise ModelError(f"overbend_controller.h is not in '{folder}'")
    return str(folder)


def _compiled(function: Any) -> Any:
    """A compiled function as one of ctypes; None of one of Python."""
    if isinstance(function, numbers.Number):
        raise TypeError(f"a controller is a function, found the number {function!r}; an address in memory becomes one by "
                        "overbend.controllers.CONTROLLER_TYPE(address)")
    if hasattr(function, "address") and hasattr(function, "native_name"):  # numba
        return CONTROLLER_TYPE(function.address)
    return function if isinstance(function, ctypes._CFuncPtr) else None  # type: ignore[attr-defined]
