"""Calls every function and method of the extension module, or of the package, with what they cannot take.

    python3 wrong_arguments.py core|package     in a folder that may be filled; the last line is "done"

Each call is written down before it is made, so that the last line names the one that ended the process.
"""

import math
import signal
import sys

import overbend as ob
from lays import EXAMPLES, moving_lay, small_lay
from overbend import _core
from test_operation import OPERATION

JUNK = [None, True, 3, -1, 99, 2**63, 2**70, 1.5, -1.0, math.nan, math.inf, "", "x", "a[b].c", "\0", b"\xff", [], [None],
        [-1], [2**63], {}, {"tensioner": None}, {"tensioner": 3}, (), object(), lambda *given, **named: None]
FEW = [None, -1, 2**70, math.nan, b"\xff", [None], {"tensioner": None}, object()]
LONG = ("run", "LayTable.__init__")  # slow calls unless rejected, called with few of them
SECONDS = 30  # limit of a call, which is rejected in milliseconds or solves a small model

ORCAFLEX = EXAMPLES.parent / "data" / "orcaflex" / "shallow-lay.yml"


class TooLong(BaseException):
    """A call that does not end."""


def overdue(_number, _frame):
    raise TooLong()


def tried(call_label, function):
    """Calls; any exception it raises has to be an ordinary exception."""
    print(call_label, flush=True)
    signal.alarm(SECONDS)
    try:
        function()
    except (SystemError, MemoryError) as error:
        print("no ordinary exception:", repr(error), flush=True)
    except Exception as error:  # whichever it is, it is one that can be caught
        if not str(error):
            print("no word:", repr(error), flush=True)
    finally:
        signal.alarm(0)


def spoilt(call_label, function, given, named):
    """The function with each of its arguments replaced in turn."""
    for junk in FEW if call_label in LONG else JUNK:
        for place in range(len(given)):
            changed = [*given[:place], junk, *given[place + 1:]]
            tried(f"{call_label}: argument {place} is {junk!r:.60}", lambda: function(*changed, **named))
        for name in named:
            tried(f"{call_label}: {name} is {junk!r:.60}", lambda: function(*given, **{**named, name: junk}))
        tried(f"{call_label}: too many, {junk!r:.60}", lambda: function(*given, junk, **named))
    for count in range(len(given)):
        tried(f"{call_label}: {count} arguments", lambda: function(*given[:count]))


def core_subjects():
    """Objects of the classes of the extension module, and for everything that is called a way to call it."""
    model = small_lay()._core
    moving = moving_lay().with_({"analysis.dynamic": {"duration": "0.5 s", "build_up": "0 s"}})._core
    calm = small_lay().with_({"operation": OPERATION})
    statics = _core.Statics(model)
    statics.save("static")
    operation = _core.Operation(calm._core)
    operation.save("operation")
    study = "overbend_study: 1\nbase: model.yaml\naxes:\n  - {key: tensioner.tension, values: [300 kN, 310 kN]}\n"
    wanted = "{vary: [{key: tensioner.tension, from: 250 kN, to: 350 kN}], until: [{result: static.lay_back, equals: 180 m}]}"
    cases = _core.Study.of(model, study, "study")
    cases.run("study")
    simulation = _core.Simulation(moving)
    readings = []
    controller = _core.Controller(lambda time, seen: readings.append(seen), 0.1)
    _core.Simulation(moving, controllers={"tensioner": controller}).advance(0.2)
    function = ob.controllers.CONTROLLER_TYPE(lambda seen, command, memory: 0)
    file, tree = _core.ResultFile("static/results.h5"), statics.tree()
    with open("static/summary.json", encoding="utf-8") as stream:
        summary = stream.read()
    run = {"stage": "", "duration": 0.5, "seeds": [1], "several": False, "of": "", "resume": False, "restart": True,
           "checkpoint": 30.0, "threads": 1, "controllers": {"tensioner": controller}, "progress": None}
    objects = {"Controller": controller, "FolderComparison": _core.FolderComparison(["static", "static"]),
               "LayTable": _core.LayTable(model, range="290 kN..310 kN/1"), "MachineReading": readings[0], "Model": model,
               "Operation": operation, "ResultFile": file, "ResultTree": tree, "SavedSimulation": simulation.save(),
               "Simulation": simulation, "Sought": _core.seek(model, wanted), "Statics": statics, "Study": cases,
               "StudyTables": _core.StudyTables("study")}
    calls = {
        "Controller.__init__": ([lambda time, seen: None, 0.1], {"save": None, "restore": None}),
        "Controller.compiled": ([function, 0.1, [1.0]], {}), "Controller.by_calls": ([], {}),
        "FolderComparison.__init__": ([["static", "static"]], {}), "FolderComparison.content": ([], {}),
        "FolderComparison.save": (["comparison"], {}),
        "LayTable.__init__": ([model, "tension", "290 kN..310 kN/1", "", [], False, None], {}), "LayTable.summary": ([], {}),
        "LayTable.tree": ([], {}), "LayTable.save": (["table"], {}),
        "Model.read": ([str(EXAMPLES / "first-model.yaml")], {}), "Model.from_text": ([model.text, "model.yaml"], {}),
        "Model.changed": ([[("title", "scalar", "Another")]], {}), "Model.moved": (["folder"], {}),
        "Model.value": (["tensioner.tension"], {}),
        "Operation.__init__": ([calm._core, None], {}), "Operation.stored": (["operation/results.h5"], {}),
        "Operation.summary": ([], {}), "Operation.tree": ([], {}), "Operation.stage": ([0], {}),
        "Operation.save": (["operation"], {}),
        "ResultFile.__init__": (["static/results.h5"], {}), "ResultFile.names": (["/static"], {}),
        "ResultFile.has": (["/static"], {}), "ResultFile.dataset": (["/static/stations/s"], {}),
        "ResultFile.lines": (["/static/stations/s", 0, 3], {}), "ResultFile.extent": (["/static/stations/s"], {}),
        "ResultTree.names": (["/static"], {}), "ResultTree.has": (["/static"], {}),
        "ResultTree.dataset": (["/static/stations/s"], {}),
        "SavedSimulation.__getstate__": ([], {}), "SavedSimulation.__setstate__": ([simulation.save().__getstate__()], {}),
        "Simulation.__init__": ([moving], {"stage": "", "duration": 0.5, "seed": 1, "controllers": {"tensioner": controller}}),
        "Simulation.step": ([], {}), "Simulation.advance": ([0.1], {}), "Simulation.command": (["tensioner", 0.0], {}),
        "Simulation.state": ([], {}), "Simulation.reactions": ([], {}), "Simulation.vessel": ([], {}),
        "Simulation.energy": ([], {}), "Simulation.quasi_static": ([], {}), "Simulation.mooring": ([0], {}),
        "Simulation.line": ([0], {}),
        "Simulation.machine": (["tensioner"], {}), "Simulation.save": ([], {}),
        "Simulation.restore": ([simulation.save()], {}),
        "Sought.save": (["sought"], {}),
        "Statics.__init__": ([model, "", statics], {}), "Statics.summary": ([True], {}), "Statics.tree": ([], {}),
        "Statics.save": (["static"], {}),
        "Study.read": (["study/study.yaml"], {}), "Study.of": ([model, study, "study"], {}),
        "Study.run": (["study"], {"threads": 1, "retry_failed": False, "checkpoint": 60.0, "progress": None}),
        "Study.run_case": (["study", 0], {}),
        "StudyTables.__init__": (["study"], {}), "StudyTables.tree": ([], {}), "StudyTables.content": ([], {}),
        "import_orcaflex": ([str(ORCAFLEX), ".", None], {}), "flow_scalar": (["text"], {}), "has_operation": (["static/results.h5"], {}),
        "named_values": ([summary, "static.lay_back"], {}), "object_descriptions": ([], {}), "object_units": ([], {}),
        "lift_units": ([], {}), "lift_descriptions": ([], {}),
        "quantity": (["1 m", "m"], {}), "result_paths": ([], {}),
        "run": ([moving, "run"], run), "seek": ([model, wanted], {}),
        "sensitivities": ([model, "", ["tensioner.tension"], False], {}), "summary_descriptions": ([], {}),
        "summary_units": ([], {}), "section_length": ([], {}), "shown_unit": (["tension", "N"], {}),
        "use_units": (["metric"], {}),
    }
    return objects, calls


def public(owner):
    """Names of what users of a class may call, and of its properties."""
    kept = ("__init__", "__getstate__", "__setstate__")
    callables, properties = [], []
    for name, value in vars(owner).items():
        if name.startswith("_") and name not in kept:
            continue
        (properties if isinstance(value, property) else callables).append(name)
    return callables, properties


def spoil_core():
    objects, calls = core_subjects()
    for owner_name, owner in vars(_core).items():
        if not isinstance(owner, type):
            if callable(owner):
                spoilt(owner_name, owner, *calls[owner_name])
            continue
        callables, properties = public(owner)
        raw = owner.__new__(owner)
        for name in properties:
            for junk in [*JUNK, raw]:
                tried(f"{owner_name}.{name} of {junk!r:.60}", lambda: getattr(owner, name).__get__(junk))
                tried(f"{owner_name}.{name} of {junk!r:.60}", lambda: getattr(owner, name).fget(junk))
        made = f"{owner_name}.__init__" in calls
        for name in callables:
            if name == "__init__" and not made:
                tried(f"{owner_name}()", owner)
                continue
            given, named = calls[f"{owner_name}.{name}"]
            static = isinstance(vars(owner)[name], staticmethod)
            bound = owner if name == "__init__" else getattr(owner if static else objects[owner_name], name)
            spoilt(f"{owner_name}.{name}", bound, given, named)
            for junk in [] if static else [*JUNK, raw]:
                tried(f"{owner_name}.{name} of {junk!r:.60}", lambda: getattr(owner, name)(junk, *given, **named))


def package_subjects():
    """Objects of the package, each with the arguments that its methods have to have, by their names."""
    model, moving = small_lay(), moving_lay().with_({"analysis.dynamic": {"duration": "0.5 s", "build_up": "0 s"}})
    static, run = model.static(), moving.dynamic(out="run")
    static.save("static")
    axes = {"tensioner.tension": ["300 kN", "310 kN"]}
    study = ob.study(model, axes=axes, gather=["static.lay_back"], out="study")
    operation = small_lay().with_({"operation": OPERATION}).operation()
    until = {"static.lay_back": "180 m"}
    found = ob.seek(model, {"tensioner.tension": ("250 kN", "350 kN")}, until)
    sim = moving.simulation()
    needed = {"file": str(ORCAFLEX), "path": str(EXAMPLES / "first-model.yaml"), "text": model.text, "key": "tensioner.tension", "seeds": [1],
              "folder": "static", "folders": ["static", "run"], "name": "lay_back", "until": until, "machine": "tensioner",
              "command": 0.0, "tension": 3e5, "saved": sim.save(), "result": "static.lay_back", "input": "tensioner.tension",
              "number": 0, "study": model, "model": model, "vary": {"tensioner.tension": ("250 kN", "350 kN")},
              "function": lambda time, seen: None, "use": True, "unit": "m", "value": 1.0}
    optional = {"write": {"path": "written.yaml"}, "save": {"folder": "saved"}, "history": {"name": "top_tension"},
                "envelope": {"name": "effective_tension"}, "spectrum": {"name": "top_tension"},
                "snapshots": {"name": "z"}, "advance": {"until": 0.2}, "column": {"name": "s"},
                "study": {"axes": axes, "out": "study"}, "dynamic": {"out": "run", "restart": True},
                "compare": {"out": "compared", "restart": True}, "seeds": {"out": "seeds", "restart": True},
                "simulation": {}, "derivative": {"result": "lay_back"}, "foremost": {"result": "lay_back"}}
    objects = {"model": moving, "static": static, "run": run, "study": study, "operation": operation,
               "stage": operation[0], "found": found, "sim": sim, "state": sim.state, "table": static.pipe,
               "records": static.checks, "record": static.touchdown, "number": static.lay_back,
               "lay table": model.lay_table("tension", "290 kN", "310 kN", steps=1), "sensitivities": model.sensitivities(),
               "comparison": ob.compare_folders(["static", "run"]), "controller": ob.Controller(lambda time, seen: None)}
    return objects, needed, optional


def spoil_package():
    import inspect

    objects, needed, optional = package_subjects()
    calls = {f"ob.{name}": getattr(ob, name) for name in ob.__all__ if callable(getattr(ob, name))
             and not (isinstance(getattr(ob, name), type) and issubclass(getattr(ob, name), BaseException))}
    is_of_overbend = lambda method: getattr(method, "__module__", None) and method.__module__.startswith("overbend")
    for call_label, subject in objects.items():
        for name, method in inspect.getmembers(subject, callable):
            if not name.startswith("_") and is_of_overbend(method):
                calls[f"{call_label}.{name}"] = method
        if hasattr(subject, "__getitem__"):
            calls[f"{call_label}[]"] = lambda which=0, subject=subject: subject[which]
    for call_label, function in calls.items():
        short = call_label.rpartition(".")[2]
        parameters = [parameter for parameter in inspect.signature(function).parameters.values()
                      if parameter.kind not in (parameter.VAR_KEYWORD, parameter.VAR_POSITIONAL)]
        given = {parameter.name: needed[parameter.name] for parameter in parameters
                 if parameter.default is parameter.empty and parameter.name in needed and parameter.kind != parameter.POSITIONAL_ONLY}
        given.update({name: value for name, value in optional.get(short, {}).items() if name in {p.name for p in parameters}})
        for parameter in parameters:
            for junk in FEW:
                if parameter.kind == parameter.POSITIONAL_ONLY:
                    tried(f"{call_label}: {parameter.name} is {junk!r:.60}", lambda: function(junk))
                else:
                    tried(f"{call_label}: {parameter.name} is {junk!r:.60}", lambda: function(**{**given, parameter.name: junk}))


if __name__ == "__main__":
    signal.signal(signal.SIGALRM, overdue)
    {"core": spoil_core, "package": spoil_package}[sys.argv[1]]()
    print("done")
