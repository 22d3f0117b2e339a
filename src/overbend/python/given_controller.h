/// Controllers as Python gives them: functions of Python, or compiled ones.
#pragma once

#include <pybind11/pybind11.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "dynamics/machines/controller.h"
#include "python/given.h"

namespace overbend {

/// A function of Python. Made, asked for what it raised and destroyed with the interpreter's lock; takes it to call.
class PythonController : public Controller {
 public:
  /// `save` gives a sequence of numbers that `restore` takes; both None where the function remembers nothing.
  PythonController(pybind11::function function, pybind11::object save, pybind11::object restore);

  MachineCommand command(const MachineReading& seen) override;
  std::vector<double> save() const override;
  void restore(const std::vector<double>& saved) override;

  /// Raises in Python what the function raised, where it did, with a note of where.
  void raise(const std::string& where);

 private:
  void keep(pybind11::error_already_set& error) const;

  pybind11::function function_;
  pybind11::object save_, restore_, set_tension_;
  mutable pybind11::object raised_;  ///< An exception; none.
};

/// A compiled function that ctypes knows, which is kept alive. Likewise.
class KeptController : public CompiledController {
 public:
  /// Throws pybind11::type_error where it is no function of ctypes, or a null pointer.
  KeptController(pybind11::object function, std::vector<double> memory);

 private:
  pybind11::object function_;
};

/// A controller of a machine, and how often it is asked.
struct GivenController {
  std::shared_ptr<Controller> controller;  ///< Null: the machine takes commands by calls alone.
  double interval = 0.1;                   ///< [s]
};

/// By the machine that each drives.
using GivenControllers = std::map<std::string, Given<GivenController>>;

/// For a run; what they point to belongs to `given`.
std::vector<ControllerUse> uses_of(const GivenControllers& given);

/// Raises what one of them raised while it was called: the end of a run that failed for it.
void raise_of_controllers(const GivenControllers& given, const std::string& why);

/// What Python says a machine shall do: None, a speed [m/s], or a `set_tension` [N], the class overbend.SetTension.
/// Throws std::invalid_argument.
MachineCommand command_of(const pybind11::handle& answer, const pybind11::object& set_tension);
pybind11::object set_tension_class();

}  // namespace overbend
