"""User-defined controllers for the tensioner and mooring winches."""

from __future__ import annotations

import ctypes
import numbers
import pathlib
from typing import Any, Callable, Mapping, Optional, Sequence, Union

from . import _core
from .errors import ModelError

#: Instrument readings passed to a controller; see overbend.controllers.Controller.
MachineReading = _core.MachineReading

#: Type of a compiled controller: int f(const struct overbend_reading *seen, double *command, double *memory).
CONTROLLER_TYPE = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.POINTER(ctypes.c_double), ctypes.POINTER(ctypes.c_double),
                                   ctypes.POINTER(ctypes.c_double))


class SetTension(float):
    """A target tension for the machine's own control law [N], returned by a controller instead of a speed.

    Args:
        tension: In newtons, or a string with unit: SetTension('250 kN').
    """

    def __new__(cls, tension: Union[float, str]) -> "SetTension":
        return super().__new__(cls, _core.quantity(tension, "N") if isinstance(tension, str) else tension)

    def __repr__(self) -> str:
        return f"SetTension({float(self):g} N)"


#: Command of a controller: a pay-out speed [m/s], a SetTension, or None for the machine's own control law.
Command = Union[float, SetTension, None]
ControllerFunction = Callable[[float, MachineReading], Command]


class Controller:
    """A control law for a machine of a run, and its sampling interval.

    A controller is a function `f(t, seen)` of the time [s] and the instrument readings. It returns the command that applies
    until the next call: a number is a pay-out speed [m/s], negative to haul in; a SetTension is a target for the machine's
    own control law; None leaves the machine to that law. The machine accelerates to a commanded speed and keeps it, within
    its velocity and travel limits.

    The controller is called exactly at multiples of its interval. A command takes effect at the end of the time step that
    contains this time; no step is longer than 1.25 intervals.

    `seen` has `time` [s], `tension` [N], `paid_out` [m], `speed` [m/s], `set_tension` [N], `length` of a mooring line [m],
    `guide_speed`, the speed of guide or fairlead along the line [m/s], `vessel` and `vessel_velocity`: (6,) surge, sway,
    heave [m], roll, pitch, yaw [rad] and their rates (world axes).

    A controller may keep a memory of its own. If the run is to be resumed, the controller should be an object with `save()`,
    which returns a list of numbers, and `restore(numbers)`.
    """

    def __init__(self, function: Union[ControllerFunction, Any], interval: float = 0.1, memory: Sequence[float] = ()):
        """
        Args:
            function: A Python function, or a compiled one: from ctypes (of its address CONTROLLER_TYPE(address)) or from
                numba's `cfunc`; see overbend_controller.h in get_include().
            interval: Time between calls [s].
            memory: For a compiled controller: initial values of the numbers that its last argument points to.
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
        """Memory of a compiled controller, after the last run if there was one."""
        return self._memory if self._core is None else self._core.memory

    def _given(self) -> _core.Controller:
        """The controller for the engine, for one run."""
        if self._compiled is not None:
            self._core = _core.Controller.compiled(self._compiled, self.interval, self._memory)
        else:
            self._core = _core.Controller(self._function, self.interval, getattr(self._function, "save", None),
                                          getattr(self._function, "restore", None))
        return self._core


#: Controllers by machine: 'tensioner', or the name of a mooring line for its winch. None: commands by calls only.
Controllers = Mapping[str, Union[ControllerFunction, Controller, None]]


def given_controllers(controllers: Optional[Controllers], interval: float = 0.1) -> dict[str, _core.Controller]:
    """Controllers for the engine, for one run; functions are called every `interval` [s]."""
    given = {}
    for machine, controller in (controllers or {}).items():
        if controller is None:
            given[machine] = _core.Controller.by_calls()
        else:
            given[machine] = (controller if isinstance(controller, Controller) else Controller(controller, interval))._given()
    return given


def get_include() -> str:
    """Folder of overbend_controller.h, the header for compiled controllers."""
    folder = pathlib.Path(__file__).resolve().parent / "include"
    if not (folder / "overbend_controller.h").is_file():
        raise ModelError(f"overbend_controller.h is not in '{folder}'")
    return str(folder)


def _compiled(function: Any) -> Any:
    """A compiled function as a ctypes function; None for a Python function."""
    if isinstance(function, numbers.Number):
        raise TypeError(f"a controller is a function, found the number {function!r}; an address in memory becomes one by "
                        "overbend.controllers.CONTROLLER_TYPE(address)")
    if hasattr(function, "address") and hasattr(function, "native_name"):  # numba
        return CONTROLLER_TYPE(function.address)
    return function if isinstance(function, ctypes._CFuncPtr) else None  # type: ignore[attr-defined]
