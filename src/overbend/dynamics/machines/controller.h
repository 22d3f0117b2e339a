/// External controllers that command the tensioner or the mooring winches of a simulation. See
/// docs/theory/tensioner.md, "Commands from outside".
#pragma once

#include <string>
#include <vector>

#include "dynamics/machines/overbend_controller.h"

namespace overbend {

/// Readings of the instruments of the machine and the vessel.
using MachineReading = overbend_reading;

/// Command to a machine, valid until its controller is called again.
struct MachineCommand {
  enum class Kind {
    leave,   ///< Work by the machine's own law, with its last set tension.
    speed,   ///< Pay out at this speed, negative: haul in; within velocity, acceleration and travel [m/s].
    tension  ///< Restore this tension by the machine's own law [N].
  };
  Kind kind = Kind::leave;
  double value = 0.0;
};

/// Interface of external controllers.
class Controller {
 public:
  Controller() = default;
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;
  virtual ~Controller() = default;

  /// Returns the command at the multiples of its interval, called in order. An exception (of std::exception) ends the
  /// run with its what() as message.
  virtual MachineCommand command(const MachineReading& seen) = 0;
  /// Returns the memory between calls, for checkpoints.
  virtual std::vector<double> save() const { return {}; }
  virtual void restore(const std::vector<double>& /*saved*/) {}
};

inline constexpr const char* kTensionerMachine = "tensioner";

/// A controller and the machine it commands.
struct ControllerUse {
  std::string machine = kTensionerMachine;  ///< kTensionerMachine, or the name of the mooring line of a winch.
  /// Must outlive the simulation. Null: the machine takes commands between steps only, see Simulation::command.
  Controller* controller = nullptr;
  double interval = 0.1;  ///< Interval between calls [s].
};

/// A controller in compiled code with its memory.
class CompiledController : public Controller {
 public:
  explicit CompiledController(overbend_controller function, std::vector<double> memory = {})
      : function_(function), memory_(std::move(memory)) {}

  MachineCommand command(const MachineReading& seen) override;
  std::vector<double> save() const override { return memory_; }
  /// Throws std::runtime_error if the number of saved values differs from the registered one. An empty memory was not
  /// saved and leaves the present one.
  void restore(const std::vector<double>& saved) override;

 private:
  overbend_controller function_;
  std::vector<double> memory_;
};

}  // namespace overbend
