"""Dynamic analyses that go on step by step."""

from __future__ import annotations

import functools
from typing import Any, Optional, Union

import numpy as np

from . import _core
from .controllers import Command, SetTension
from .findings import Finding, findings_of
from .groups import Record, nearest
from .keys import seconds, seeds_of
from .values import Number, labelled

#: What save() gives: `time` [s] and `arrays` by name. It can be pickled.
SavedSimulation = _core.SavedSimulation

_MACHINE_UNITS = {"tension": "N", "anchor_tension": "N", "paid_out": "m", "speed": "m/s", "set_tension": "N",
                  "commanded_speed": "m/s"}
_MACHINE_WORDS = {
    "tension": "Of the pipe at the tensioner, or of the mooring line at its fairlead",
    "anchor_tension": "Of the mooring line at its anchor",
    "paid_out": "Since the start; hauled in negative",
    "speed": "Of paying out; hauling in negative",
    "set_tension": "That the machine's own law restores; 0 where it keeps none",
    "commanded_speed": "That a controller or a command asks for; None while the machine works by its own law",
}
_VESSEL_UNITS = {"surge": "m", "sway": "m", "heave": "m", "roll": "rad", "pitch": "rad", "yaw": "rad"}


class State:
    """The pipe at one instant: labelled arrays over `s` [m], the unstressed arc length from the anchor, of shape (n,), and of
    shape (n, 3) for vectors in the world frame.

    `position` [m], `tangent`, `velocity` [m/s], `acceleration` [m/s2], `effective_tension` [N], `bending_moment` [N m],
    `curvature` [1/m], `bending_stress` [Pa], `von_mises` [Pa], `strain`. The arrays stay when the simulation goes on.
    """

    def __init__(self, time: float, told: dict[str, Any]):
        self.time = Number(time, "s", "Time from the end of the build-up")
        self._told = told

    @functools.cached_property
    def s(self) -> Any:
        """Unstressed arc length from the anchor, shape (n,) [m]."""
        return self._array("s")

    def _array(self, name: str) -> Any:
        values, units, description, frame = self._told[name]
        coords = {"s": self._told["s"][0]}
        dims: tuple[str, ...] = ("s",)
        if values.ndim == 2:
            dims, coords["axis"] = ("s", "axis"), np.array(["x", "y", "z"])
        return labelled(values, name, dims, coords, units, description, frame)

    def keys(self) -> list[str]:
        """The names of the arrays."""
        return list(self._told)

    def __getitem__(self, name: str) -> Any:
        if name not in self._told:
            raise KeyError(f"there is no '{name}'{nearest(name, list(self._told))}")
        return self._array(name)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self[name]
        except KeyError as fault:
            raise AttributeError(fault.args[0]) from None

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._told})

    def __repr__(self) -> str:
        return f"<State at t = {float(self.time):g} s of {len(self._told['s'][0])} nodes: " + ", ".join(self._told) + ">"


class Simulation:
    """A dynamic analysis that goes on when it is told to: made by `Model.simulation()`.

        sim = model.simulation()
        while not sim.finished:
            sim.advance(sim.time + 1.0)
            if sim.tension > 280e3:
                sim.command('tensioner', 0.05)      # pays out at 5 cm/s from here on

    It begins at rest before the build-up of the sea, at t = -build_up, and ends with the duration. Its steps do not depend on
    how it is advanced. One thread works with it at a time.
    """

    def __init__(self, core: _core.Simulation):
        """Not for users: see Model.simulation()."""
        self._core = core

    def step(self) -> bool:
        """Takes one accepted step; False at the end of the run.

        Raises:
            NoSolution: Where no step can be solved.
            ControllerError: Where a controller answers what its machine cannot do. What a controller raises comes as it is.
        """
        return self._core.step()

    def advance(self, until: Union[float, str]) -> None:
        """Steps up to the first instant at or after a time, the end of the run at most.

        Rows of output are met exactly. Other threads of Python go on meanwhile; Ctrl-C ends
        it after an accepted step, from which it can go on.

        Args:
            until: Seconds from the end of the build-up, or a text with its unit.

        Raises:
            KeyboardInterrupt: After Ctrl-C.
            NoSolution, ControllerError: As of step().
        """
        self._core.advance(_core.quantity(until, "s") if isinstance(until, str) else float(until))

    def command(self, machine: str, command: Command) -> None:
        """Says what a machine shall do from now on, or until its controller says otherwise.

        Args:
            machine: 'tensioner', or the name of a mooring line that `controllers` of Model.simulation() names.
            command: A speed of paying out [m/s], negative to haul in; a SetTension; None: by its own law.

        Raises:
            ModelError: Where the machine is not there or cannot do that.
        """
        self._core.command(machine, command)

    def set_tension(self, tension: Union[float, str]) -> None:
        """Sets the tension that the tensioner restores by its own law, in newtons or as a text with its unit."""
        self.command("tensioner", SetTension(tension))

    @property
    def time(self) -> Number:
        """Time from the end of the build-up [s]; negative during it."""
        return Number(self._core.time, "s", "Time from the end of the build-up")

    @property
    def end(self) -> Number:
        """When the run ends [s]."""
        return Number(self._core.end, "s", "End of the run")

    @property
    def next_row(self) -> Number:
        """Time of the next row of output [s]: the model's analysis.dynamic.output_step says how often there is one."""
        return Number(self._core.next_row, "s", "Time of the next row of output")

    @property
    def finished(self) -> bool:
        """Whether the end is reached."""
        return self._core.finished

    @property
    def steps(self) -> int:
        """Accepted steps so far."""
        return self._core.steps

    @property
    def last_step(self) -> Number:
        """The step that led here [s]."""
        return Number(self._core.last_step, "s", "The step that led here")

    @property
    def wall_time(self) -> Number:
        """Time that the steps took, controllers included [s]."""
        return Number(self._core.wall_time, "s", "Time that the steps took")

    @property
    def state(self) -> State:
        """The pipe now: positions, velocities, tension, moments and stresses along it."""
        return State(self._core.time, self._core.state())

    @property
    def tension(self) -> Number:
        """Force of the tensioner on the pipe, along it [N]."""
        return self.tensioner.tension

    @property
    def travel(self) -> Number:
        """Length that the tensioner has paid out since the start [m]."""
        return self.tensioner.paid_out

    @property
    def tensioner(self) -> Record:
        """The tensioner now: tension, paid_out, speed, set_tension, commanded_speed and state ('hold', 'delay', 'pay_out',
        'haul_in', 'at_limit')."""
        return Record(self._core.machine("tensioner"), _MACHINE_UNITS, _MACHINE_WORDS)

    @property
    def moorings(self) -> dict[str, Record]:
        """The mooring lines now, by name: tension at fairlead and anchor; of lines of elements also what the winch does."""
        names = self._core.mooring_names
        if self._core.quasi_static():
            return {name: Record(self._core.mooring(i), _MACHINE_UNITS, _MACHINE_WORDS) for i, name in enumerate(names)}
        return {name: Record(self._core.machine(name), _MACHINE_UNITS, _MACHINE_WORDS) for name in names}

    @property
    def lines(self) -> dict[str, Record]:
        """The lines that stand by themselves now, by name: first_tension and second_tension at their ends [N]."""
        names = self._core.line_names
        return {name: Record(self._core.line(i), {"first_tension": "N", "second_tension": "N"})
                for i, name in enumerate(names)}

    @property
    def reactions(self) -> Any:
        """Force of every support on the pipe, its magnitude [N]: a labelled array over `support`."""
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
        """Normal force of every roller [N]: a labelled array over `roller`, the name of its support and its number there."""
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
        """The vessel now: surge, sway, heave [m], roll, pitch, yaw [rad] from its mean pose; position [m], velocity [m/s] of
        its origin, angular_velocity [rad/s], each (x, y, z) in the world; axes, a list of rows that turns from the vessel's
        axes into the world's."""
        return Record(self._core.vessel(), _VESSEL_UNITS)

    @property
    def elevation(self) -> Number:
        """Of the water at the mean place of the stern shoe, without a pipe of midship [m]."""
        return Number(self._core.elevation, "m", "Of the water at the mean place of the stern shoe or midship")

    @property
    def energy(self) -> Record:
        """The balance of energy since the start [J]: what is stored, also in a free hull or stinger (bodies), the work done
        on the pipe and on these, losses, the error that is left and the throughput, all that has passed."""
        told = self._core.energy()
        return Record(told, {name: "J" for name in told})

    @property
    def assumptions(self) -> list[str]:
        """What a reader of results has to know of controllers from outside."""
        return self._core.notes[0]

    @property
    def findings(self) -> list[Finding]:
        """Where machines could not do what they were asked for."""
        return findings_of(self._core.notes[1])

    @property
    def warnings(self) -> list[str]:
        """The messages of the findings."""
        return [finding.message for finding in self.findings]

    def save(self) -> SavedSimulation:
        """The state now, to come back to. Steps that follow a restore are the same bit for bit where it was saved at a row of
        output, and agree within the accuracy of the steps elsewhere."""
        return self._core.save()

    def restore(self, saved: SavedSimulation) -> None:
        """Goes back, or on, to a state of a simulation of the same model, seed, duration and machines with controllers.

        Raises:
            ModelError: Where it is of another.
        """
        self._core.restore(saved)

    def __repr__(self) -> str:
        return f"<Simulation at t = {float(self.time):g} s of {float(self.end):g} s>"


def simulate(model: "_core.Model", stage: str, duration: Union[float, str, None], seed: Optional[int],
             controllers: dict[str, _core.Controller]) -> Simulation:
    """A simulation of a model: see Model.simulation()."""
    given = None if seed is None else seeds_of([seed])[0]
    return Simulation(_core.Simulation(model, stage=stage, duration=seconds(duration), seed=given,
                                       controllers=controllers))
