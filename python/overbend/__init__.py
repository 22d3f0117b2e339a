"""Overbend: statics, dynamics, code checks and studies of offshore pipeline installation.

    import overbend as ob
    model = ob.Model.read('examples/bgl1.yaml')
    static = model.static()
    static.lay_back, static.pipe.effective_tension, static.supports['stinger 3'].reaction

All numbers are in SI units and know them: `static.lay_back.units`. Values given for keys of a model have theirs in the text:
`model.with_({'tensioner.tension': '260 kN'})`.
"""

from ._core import version as __version__
from .controllers import Controller, SetTension, get_include
from .errors import ControllerError, Fault, Interrupted, ModelError, NoSolution, OverbendError, ResultsError
from .groups import Record, Records, Table
from .model import Model
from .opening import open  # noqa: A004  (as in xarray and others: ob.open)
from .results import DynamicResults, SeedsResults, ComparisonResults, StaticResults
from .simulation import Simulation, State
from .values import LabelledArray, Number, use_xarray

version = __version__

__all__ = [
    "ComparisonResults",
    "Controller",
    "ControllerError",
    "DynamicResults",
    "Fault",
    "Interrupted",
    "LabelledArray",
    "Model",
    "ModelError",
    "NoSolution",
    "Number",
    "OverbendError",
    "Record",
    "Records",
    "ResultsError",
    "SetTension",
    "SeedsResults",
    "Simulation",
    "State",
    "StaticResults",
    "Table",
    "get_include",
    "open",
    "use_xarray",
    "version",
]
