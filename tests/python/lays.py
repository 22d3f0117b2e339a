"""What the tests of the Python package share: models, and the command line's answers."""

import json
import os
import pathlib
import subprocess

import overbend as ob

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples"
PROGRAM = os.environ["OVERBEND_PROGRAM"]


def small_lay():
    """The lay of examples/first-model.yaml, which is solved in milliseconds."""
    return ob.Model.read(EXAMPLES / "first-model.yaml")


def overbend(*arguments, code=0):
    """Runs the command line; its output."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, encoding="utf-8")
    if done.returncode != code:
        raise AssertionError(f"{arguments}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def load_summary(folder, file="summary.json"):
    """The content of summary.json, or of another file of results."""
    return json.loads(pathlib.Path(folder, file).read_text(encoding="utf-8"))


def without_times(value):
    """A summary without what differs from run to run."""
    if isinstance(value, dict):
        return {key: without_times(item) for key, item in value.items() if key not in ("wall_time", "history")}
    return [without_times(item) for item in value] if isinstance(value, list) else value


def moving_lay():
    """The same in a random sea on a heaving barge, ten seconds long, with a coarse mesh."""
    heave, pitch = {"amplitude": "0.3 m", "period": "7 s"}, {"amplitude": "0.5 deg", "period": "7 s"}
    return small_lay().with_({
        "environment.waves": {"type": "jonswap", "hs": "1 m", "tp": "7 s", "from": "60 deg", "components": 20,
                              "seed": 3},
        "vessel.motion": {"harmonic": {"heave": heave, "pitch": pitch}},
        "analysis.mesh": {"overbend_element": "2.5 m", "touchdown_element": "4 m", "longest_element": "8 m"},
        "analysis.dynamic": {"duration": "10 s", "build_up": "5 s", "output_step": "0.5 s"}})
