#include "python/given_controller.h"

#include <stdexcept>

namespace overbend {
namespace {

namespace py = pybind11;

std::string shown(const py::handle& object) {
  return py::repr(object).cast<std::string>();
}

/// Throws TypeError if the object is neither callable nor None.
void require_callable(const py::object& function, const char* name) {
  if (function.is_none() || PyCallable_Check(function.ptr()) != 0) return;
  throw py::type_error(std::string(name) + ": found " + shown(function) + ", expected a function or None");
}

overbend_controller compiled_function(const py::object& function) {
  const py::module_ ctypes = py::module_::import("ctypes");
  if (!py::isinstance(function, ctypes.attr("_CFuncPtr"))) {
    throw py::type_error("a compiled controller must be a ctypes function, found " + shown(function));
  }
  const py::object address = ctypes.attr("cast")(function, ctypes.attr("c_void_p")).attr("value");
  if (address.is_none()) throw py::type_error("the compiled controller is a null pointer");
  // NOLINTNEXTLINE(performance-no-int-to-ptr): ctypes returns the address of a function as a number
  return reinterpret_cast<overbend_controller>(address.cast<std::uintptr_t>());
}

}  // namespace

py::object set_tension_class() {
  return py::module_::import("overbend.controllers").attr("SetTension");
}

MachineCommand convert_command(const py::handle& answer, const py::object& set_tension) {
  using Kind = MachineCommand::Kind;
  if (answer.is_none()) return {Kind::leave, 0.0};
  if (!PyBool_Check(answer.ptr()) && !py::isinstance<py::str>(answer)) {
    const double value = PyFloat_AsDouble(answer.ptr());
    if (PyErr_Occurred() == nullptr) return {py::isinstance(answer, set_tension) ? Kind::tension : Kind::speed, value};
    PyErr_Clear();
  }
  throw std::invalid_argument("found " + shown(answer) + ", expected a speed [m/s], a SetTension or None");
}

PythonController::PythonController(py::function function, py::object save, py::object restore)
    : function_(std::move(function)),
      save_(std::move(save)),
      restore_(std::move(restore)),
      set_tension_(set_tension_class()) {
  require_callable(save_, "save");
  require_callable(restore_, "restore");
}

/// Stores the exception of a function, to be raised by the thread that started the run.
void PythonController::keep(py::error_already_set& error) const {
  raised_ = error.value();
  if (error.trace()) PyException_SetTraceback(raised_.ptr(), error.trace().ptr());
}

CtypesController::CtypesController(py::object function, std::vector<double> memory)
    : CompiledController(compiled_function(function), std::move(memory)), function_(std::move(function)) {}

MachineCommand PythonController::command(const MachineReading& seen) {
  const py::gil_scoped_acquire hold;
  try {
    return convert_command(function_(seen.time, seen), set_tension_);
  } catch (py::error_already_set& error) {
    keep(error);
    throw std::runtime_error(error.what());
  }
}

std::vector<double> PythonController::save() const {
  const py::gil_scoped_acquire hold;
  std::vector<double> saved;
  if (save_.is_none()) return saved;
  for (const py::handle value : save_()) saved.push_back(value.cast<double>());
  return saved;
}

void PythonController::restore(const std::vector<double>& saved) {
  const py::gil_scoped_acquire hold;
  if (restore_.is_none()) return;
  py::list values;
  for (const double value : saved) values.append(value);
  restore_(values);
}

void PythonController::raise(const std::string& where) {
  if (!raised_) return;
  const py::object raised = std::move(raised_);
  raised_ = py::object();
  if (py::hasattr(raised, "add_note")) raised.attr("add_note")(where);
  PyErr_SetObject(py::type::of(raised).ptr(), raised.ptr());
  throw py::error_already_set();
}

std::vector<ControllerUse> controller_uses(const GivenControllers& controllers) {
  std::vector<ControllerUse> uses;
  for (const auto& [machine, controller] : controllers) {
    uses.push_back({machine, controller->controller.get(), controller->interval});
  }
  return uses;
}

void raise_controller_exception(const GivenControllers& controllers, const std::string& why) {
  for (const auto& [machine, controller] : controllers) {
    if (auto* python = dynamic_cast<PythonController*>(controller->controller.get())) python->raise(why);
  }
}

}  // namespace overbend
