/// Controllers from Python: Python functions or compiled functions.
#pragma once

#include <pybind11/pybind11.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "dynamics/machines/controller.h"
#include "python/given.h"

namespace overbend {

/// A Python function. To be created, raised from and destroyed with the GIL held; acquires the GIL for calls.
class PythonController : public Controller {
 public:
  /// `save` returns a sequence of numbers that `restore` accepts; both are None if the function has no state.
  PythonController(pybind11::function function, pybind11::object save, pybind11::object restore);

  MachineCommand command(const MachineReading& seen) override;
  std::vector<double> save() const override;
  void restore(const std::vector<double>& saved) override;

  /// Raises the stored exception of the function, if any, with a note on `where`.
  void raise(const std::string& where);

 private:
  void keep(pybind11::error_already_set& error) const;

  pybind11::function function_;
  pybind11::object save_, restore_, set_tension_;
  mutable pybind11::object raised_;  ///< Stored exception; null if none.
};

/// A compiled function from ctypes, which is kept alive. Needs the GIL like PythonController.
class CtypesController : public CompiledController {
 public:
  /// Throws pybind11::type_error if `function` is not a ctypes function or is a null pointer.
  CtypesController(pybind11::object function, std::vector<double> memory);

 private:
  pybind11::object function_;
};

/// A controller of a machine and its sampling interval.
struct GivenController {
  std::shared_ptr<Controller> controller;  ///< Null: the machine is commanded by method calls only.
  double interval = 0.1;                   ///< [s]
};

/// Controllers by the name of the machine.
using GivenControllers = std::map<std::string, Given<GivenController>>;

/// Returns the controllers for a run. The pointers are owned by `controllers`.
std::vector<ControllerUse> controller_uses(const GivenControllers& controllers);

/// Raises the exception stored by one of the controllers, if any, with the note `why`.
void raise_controller_exception(const GivenControllers& controllers, const std::string& why);

/// Converts the return value of a controller: None, a speed [m/s], or an object of the class `set_tension`
/// (overbend.SetTension) [N]. Throws std::invalid_argument.
MachineCommand convert_command(const pybind11::handle& answer, const pybind11::object& set_tension);
/// Returns the class overbend.SetTension.
pybind11::object set_tension_class();

}  // namespace overbend
