"""Dynamic analyses advanced step by step."""

from __future__ import annotations

import functools
from typing import Any, Optional, Union

import numpy as np

from . import _core
from .controllers import Command, SetTension
from .findings import Finding, make_findings
from .groups import Record, nearest
from .keys import require_seeds, seconds
from .values import Number, labelled

#: A saved state: `time` [s] and `arrays` by name. It can be pickled.
SavedSimulation = _core.SavedSimulation

_MACHINE_UNITS = {"tension": "N", "anchor_tension": "N", "paid_out": "m", "speed": "m/s", "set_tension": "N",
                  "commanded_speed": "m/s"}
_MACHINE_DESCRIPTIONS = {
    "tension": "Tension of the pipe at the tensioner, or of the mooring line at its fairlead",
    "anchor_tension": "Tension of the mooring line at its anchor",
    "paid_out": "Length paid out since the start; negative when hauled in",
    "speed": "Pay-out speed; negative when hauling in",
    "set_tension": "Target tension of the machine's own control law; 0 if it has none",
    "commanded_speed": "Speed commanded by a controller or call; None under the machine's own control law",
}
_VESSEL_UNITS = {"surge": "m", "sway": "m", "heave": "m", "roll": "rad", "pitch": "rad", "yaw": "rad"}


class State:
    """The pipe at one time: labelled arrays over `s` [m], the unstressed arc length from the anchor, of shape (n,), and
    of shape (n, 3) for vectors in the world frame.

    `position` [m], `tangent`, `velocity` [m/s], `acceleration` [m/s2], `effective_tension` [N], `bending_moment` [N m],
    `curvature` [1/m], `bending_stress` [Pa], `von_mises` [Pa], `strain`. The arrays keep their values when the simulation
    continues.
    """

    def __init__(self, time: float, arrays: dict[str, Any]):
        self.time = Number(time, "s", "Time from the end of the build-up")
        self._arrays = arrays

    @functools.cached_property
    def s(self) -> Any:
        """Unstressed arc length from the anchor, shape (n,) [m]."""
        return self._array("s")

    def _array(self, name: str) -> Any:
        values, units, description, frame = self._arrays[name]
        coords = {"s": self._arrays["s"][0]}
        dims: tuple[str, ...] = ("s",)
        if values.ndim == 2:
            dims, coords["axis"] = ("s", "axis"), np.array(["x", "y", "z"])
        return labelled(values, name, dims, coords, units, description, frame)

    def keys(self) -> list[str]:
        """Names of the arrays."""
        return list(self._arrays)

    def __getitem__(self, name: str) -> Any:
        if name not in self._arrays:
            raise KeyError(f"there is no '{name}'{nearest(name, list(self._arrays))}")
        return self._array(name)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self[name]
        except KeyError as error:
            raise AttributeError(error.args[0]) from None

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._arrays})

    def __repr__(self) -> str:
        return f"<State at t = {float(self.time):g} s of {len(self._arrays['s'][0])} nodes: " + ", ".join(self._arrays) + ">"


class Simulation:
    """A dynamic analysis under the control of the caller, made by `Model.simulation()`.

        sim = model.simulation()
        while not sim.finished:
            sim.advance(sim.time + 1.0)
            if sim.tension > 280e3:
                sim.command('tensioner', 0.05)      # pays out at 5 cm/s from here on

    It starts from the static state before the build-up, at t = -build_up, and ends with the duration. Its time steps do not
    depend on how it is advanced. Use it from one thread at a time.
    """

    def __init__(self, core: _core.Simulation):
        """Not for users: see Model.simulation()."""
        self._core = core

    def step(self) -> bool:
        """Takes one accepted step; False at the end of the run.

        Raises:
            NoSolution: If no step can be solved.
            ControllerError: If a controller returns a command that its machine cannot execute. Exceptions of a controller
                are passed on.
        """
        return self._core.step()

    def advance(self, until: Union[float, str]) -> None:
        """Takes steps until a given time is reached, at most to the end of the run.

        Output times are met exactly. Releases the GIL. Ctrl-C stops after an accepted step; the simulation can continue from
        there.

        Args:
            until: Seconds from the end of the build-up, or a string with unit.

        Raises:
            KeyboardInterrupt: After Ctrl-C.
            NoSolution, ControllerError: As in step().
        """
        self._core.advance(_core.quantity(until, "s") if isinstance(until, str) else float(until))

    def command(self, machine: str, command: Command) -> None:
        """Commands a machine from now on, until the next command of its controller.

        Args:
            machine: 'tensioner', or the name of a mooring line listed in `controllers` of Model.simulation().
            command: A pay-out speed [m/s], negative to haul in; a SetTension; None for its own control law.

        Raises:
            ModelError: If there is no such machine, or it cannot execute the command.
        """
        self._core.command(machine, command)

    def set_tension(self, tension: Union[float, str]) -> None:
        """Sets the target tension of the tensioner's own control law, in newtons or as a string with unit."""
        self.command("tensioner", SetTension(tension))

    @property
    def time(self) -> Number:
        """Time from the end of the build-up [s]; negative during it."""
        return Number(self._core.time, "s", "Time from the end of the build-up")

    @property
    def end(self) -> Number:
        """End of the run [s]."""
        return Number(self._core.end, "s", "End of the run")

    @property
    def next_row(self) -> Number:
        """Time of the next output step [s]; their interval is analysis.dynamic.output_step of the model."""
        return Number(self._core.next_row, "s", "Time of the next output step")

    @property
    def finished(self) -> bool:
        """True at the end of the run."""
        return self._core.finished

    @property
    def steps(self) -> int:
        """Number of accepted steps."""
        return self._core.steps

    @property
    def last_step(self) -> Number:
        """Length of the last time step [s]."""
        return Number(self._core.last_step, "s", "Length of the last time step")

    @property
    def wall_time(self) -> Number:
        """Computing time of the steps, including controllers [s]."""
        return Number(self._core.wall_time, "s", "Computing time of the steps")

    @property
    def state(self) -> State:
        """Current state of the pipe: positions, velocities, tension, moments and stresses along it."""
        return State(self._core.time, self._core.state())

    @property
    def tension(self) -> Number:
        """Axial force of the tensioner on the pipe [N]."""
        return self.tensioner.tension

    @property
    def travel(self) -> Number:
        """Length paid out by the tensioner since the start [m]."""
        return self.tensioner.paid_out

    @property
    def tensioner(self) -> Record:
        """Current state of the tensioner: tension, paid_out, speed, set_tension, commanded_speed and state ('hold', 'delay',
        'pay_out', 'haul_in', 'at_limit')."""
        return Record(self._core.machine("tensioner"), _MACHINE_UNITS, _MACHINE_DESCRIPTIONS)

    @property
    def moorings(self) -> dict[str, Record]:
        """Current state of the mooring lines by name: tension at fairlead and anchor; lines modelled by elements also have
        values of their winch."""
        names = self._core.mooring_names
        if self._core.quasi_static():
            return {name: Record(self._core.mooring(i), _MACHINE_UNITS, _MACHINE_DESCRIPTIONS) for i, name in enumerate(names)}
        return {name: Record(self._core.machine(name), _MACHINE_UNITS, _MACHINE_DESCRIPTIONS) for name in names}

    @property
    def lines(self) -> dict[str, Record]:
        """Current end tensions of other lines by name: first_tension and second_tension [N]."""
        names = self._core.line_names
        return {name: Record(self._core.line(i), {"first_tension": "N", "second_tension": "N"})
                for i, name in enumerate(names)}

    @property
    def reactions(self) -> Any:
        """Magnitude of the force of every support on the pipe [N]: a labelled array over `support`."""
        names, sizes, _, _, _ = self._core.reactions()
        return labelled(np.array(sizes), "reaction", ("support",), {"support": np.array(names, dtype=str)}, "N",
                        "Resultant force of a support on the pipe")

    @property
    def reaction_forces(self) -> Any:
        """Force of every support on the pipe as a vector [N], shape (supports, 3), world frame."""
        names, _, forces, _, _ = self._core.reactions()
        coords = {"support": np.array(names, dtype=str), "axis": np.array(["x", "y", "z"])}
        return labelled(np.array(forces).reshape(-1, 3), "reaction_force", ("support", "axis"), coords, "N",
                        "Resultant force of a support on the pipe", "W")

    @property
    def rollers(self) -> Any:
        """Normal force of every roller [N]: a labelled array over `roller`, named by support and number."""
        _, _, _, boxes, normals = self._core.reactions()
        count: dict[str, int] = {}
        names = []
        for box in boxes:
            count[box] = count.get(box, 0) + 1
            names.append(f"{box}/{count[box]}")
        return labelled(np.array(normals), "normal_force", ("roller",), {"roller": np.array(names, dtype=str)}, "N",
                        "Normal force of a roller on the pipe")

    @property
    def vessel(self) -> Record:
        """Current state of the vessel: surge, sway, heave [m], roll, pitch, yaw [rad] from its mean pose; position [m],
        velocity [m/s] of its origin, angular_velocity [rad/s], each (x, y, z) in the world frame; axes, the rotation matrix
        from vessel to world axes as a list of rows."""
        return Record(self._core.vessel(), _VESSEL_UNITS)

    @property
    def elevation(self) -> Number:
        """Water surface elevation at the mean position of the stern shoe, without a pipe of midship [m]."""
        return Number(self._core.elevation, "m", "Water surface elevation at the mean position of stern shoe or midship")

    @property
    def energy(self) -> Record:
        """Energy balance since the start [J]: stored energy, also of a free hull or stinger (bodies), work done on the pipe and
        on these, losses, the remaining error and the throughput."""
        energies = self._core.energy()
        return Record(energies, {name: "J" for name in energies})

    @property
    def assumptions(self) -> list[str]:
        """Assumptions of the results on external controllers."""
        return self._core.notes[0]

    @property
    def findings(self) -> list[Finding]:
        """Findings on commands beyond the limits of machines."""
        return make_findings(self._core.notes[1])

    @property
    def warnings(self) -> list[str]:
        """Messages of the findings."""
        return [finding.message for finding in self.findings]

    def save(self) -> SavedSimulation:
        """Saves the current state. Steps after a restore are bit for bit the same if the state was saved at an output step, and
        agree within the accuracy of the steps otherwise."""
        return self._core.save()

    def restore(self, saved: SavedSimulation) -> None:
        """Restores a saved state of a simulation with the same model, seed, duration and controlled machines.

        Raises:
            ModelError: If it belongs to another simulation.
        """
        self._core.restore(saved)

    def __repr__(self) -> str:
        return f"<Simulation at t = {float(self.time):g} s of {float(self.end):g} s>"


def simulate(model: "_core.Model", stage: str, duration: Union[float, str, None], seed: Optional[int],
             controllers: dict[str, _core.Controller]) -> Simulation:
    """Makes a simulation of a model: see Model.simulation()."""
    given = None if seed is None else require_seeds([seed])[0]
    return Simulation(_core.Simulation(model, stage=stage, duration=seconds(duration), seed=given,
                                       controllers=controllers))
