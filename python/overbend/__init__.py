"""Overbend: statics, dynamics, code checks and studies of offshore pipeline installation.

    import overbend as ob
    model = ob.Model.read('examples/bgl1.yaml')
    static = model.static()
    static.lay_back, static.pipe.effective_tension, static.supports['stinger 3'].reaction

All numbers are in SI units and carry them: `static.lay_back.units`. Values of model keys are strings with units:
`model.with_({'tensioner.tension': '260 kN'})`.
"""

from ._core import version as __version__
from .comparison import FolderComparison, compare_folders
from .controllers import Controller, SetTension, get_include
from .dynamic_results import DynamicResults
from .errors import ControllerError, Fault, Interrupted, ModelError, NoSolution, OverbendError, ResultsError
from .examples import example
from .findings import Finding, FindingNumber
from .groups import Record, Records, Table
from .importing import ImportAccount, Imported, import_orcaflex
from .lay_table import LayTable
from .model import Model
from .objects import Objects
from .opening import open  # noqa: A004  (as in xarray and others: ob.open)
from .operation import OperationResults
from .results import StaticResults
from .runs import ComparisonResults, SeedsResults
from .seeking import SeekResult, seek
from .sensitivities import Sensitivities
from .simulation import Simulation, State
from .studies import Operability, StudyResults, study
from .values import LabelledArray, Number, use_units, use_xarray

version = __version__

__all__ = [
    "ComparisonResults",
    "Controller",
    "ControllerError",
    "DynamicResults",
    "Fault",
    "Finding",
    "FindingNumber",
    "FolderComparison",
    "ImportAccount",
    "Imported",
    "Interrupted",
    "LabelledArray",
    "LayTable",
    "Model",
    "ModelError",
    "NoSolution",
    "Number",
    "Objects",
    "Operability",
    "OperationResults",
    "OverbendError",
    "Record",
    "Records",
    "ResultsError",
    "SeedsResults",
    "SeekResult",
    "Sensitivities",
    "SetTension",
    "Simulation",
    "State",
    "StaticResults",
    "StudyResults",
    "Table",
    "compare_folders",
    "example",
    "get_include",
    "import_orcaflex",
    "open",
    "seek",
    "study",
    "use_units",
    "use_xarray",
    "version",
]
