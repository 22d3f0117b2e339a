/// Controllers from outside that drive the tensioner, or the winches of mooring lines, of a simulation. See
/// docs/theory/tensioner.md, "Commands from outside".
#pragma once

#include <string>
#include <vector>

#include "dynamics/machines/overbend_controller.h"

namespace overbend {

/// What a controller sees: what the instruments of its machine and of the vessel show.
using MachineReading = overbend_reading;

/// What a machine shall do until its controller is asked again.
struct MachineCommand {
  enum class Kind {
    leave,   ///< Work by its own law, with the tension that it was set to last.
    speed,   ///< Pay out at this speed, haul in where negative; within velocity, acceleration and travel [m/s].
    tension  ///< Restore this tension by its own law [N].
  };
  Kind kind = Kind::leave;
  double value = 0.0;
};

class Controller {
 public:
  Controller() = default;
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;
  virtual ~Controller() = default;

  /// Asked for the multiples of its interval, in order. An exception (of std::exception) ends the run, which tells
  /// what() of it.
  virtual MachineCommand command(const MachineReading& seen) = 0;
  /// What it remembers from one call to the next, for checkpoints.
  virtual std::vector<double> save() const { return {}; }
  virtual void restore(const std::vector<double>& /*saved*/) {}
};

inline constexpr const char* kTensionerMachine = "tensioner";

/// A controller and what it drives.
struct ControllerUse {
  std::string machine = kTensionerMachine;  ///< Or the name of a mooring line, whose winch it is.
  /// Has to outlive the simulation. Null: the machine takes commands between steps alone, see Simulation::command.
  Controller* controller = nullptr;
  double interval = 0.1;  ///< For whose multiples it is asked [s].
};

/// A compiled function with its memory.
class CompiledController : public Controller {
 public:
  explicit CompiledController(overbend_controller function, std::vector<double> memory = {})
      : function_(function), memory_(std::move(memory)) {}

  MachineCommand command(const MachineReading& seen) override;
  std::vector<double> save() const override { return memory_; }
  /// Throws std::runtime_error where the function would find another number of doubles than it was registered with. An
  /// empty memory is one that was not saved: its own stays.
  void restore(const std::vector<double>& saved) override;

 private:
  overbend_controller function_;
  std::vector<double> memory_;
};

}  // namespace overbend
