/// Machines of a simulation with external controllers: times of calls, readings, and execution of commands.
#pragma once

#include <cstdint>
#include <optional>

#include "base/assumption.h"
#include "base/finding.h"
#include "dynamics/machines/controller.h"
#include "model/model.h"
#include "results/dynamic_sink.h"
#include "statics/solver/statics.h"
#include "system/assembly.h"

namespace overbend {

/// Start of the messages about failed controllers.
inline constexpr const char* kControllerMessagePrefix = "the controller of ";

/// A machine that takes commands.
struct CommandedMachine {
  std::string name;   ///< kTensionerMachine, or the name of the mooring line.
  std::string label;  ///< Label in messages: "the tensioner", "the winch of mooring line 'bow'".
  std::size_t attachment = 0;
  Controller* controller = nullptr;
  double interval = 0.0;                   ///< [s]
  MachineReading before{};                 ///< Reading at the previous instant.
  std::int64_t next = 0;                   ///< Multiple of the interval at which it is called next.
  double max_requested_speed = 0.0;        ///< Maximum requested speed [m/s].
  std::optional<double> stopped_at{};      ///< Time when it first reached the end of its travel [s].
  std::optional<double> memory_lost_at{};  ///< Time of the last restart without the memory of its controller [s].

  double next_call_time() const { return static_cast<double>(next) * interval; }  ///< Time of the next call [s].
};

/// Calls the controllers of a run and passes their commands on.
class Controllers {
 public:
  /// Adds laws to winches that have none. `moorings`: names of all mooring lines, also quasi-static ones. `start`:
  /// first instant [s]. Throws std::invalid_argument for an unknown machine.
  Controllers(const Model& model, const std::vector<ControllerUse>& uses, const std::vector<std::string>& moorings,
              double start, System& system);

  /// The tensioner first, if there is one, then the machines in the order of `uses`.
  const std::vector<CommandedMachine>& machines() const { return machines_; }
  /// True if any machine has a controller.
  bool active() const;
  /// Returns the maximum step [s]: 1.25 times the minimum interval, so that the default maximum step fits the default
  /// interval; infinite without controllers.
  double max_allowed_step() const;
  /// Sets the tensions measured by winches before the first step.
  void begin(const Assembly& assembly, SystemState& state) const;
  /// Calls the controllers for their times since the previous instant. Readings are interpolated linearly between the
  /// two instants; commands act from now on. `paid_out`: payout of the tensioner since the start [m]. Does not allocate
  /// unless a controller fails.
  std::optional<StaticFailure> ask(const Assembly& assembly, double paid_out, System& system, SystemState& state);
  /// Throws std::invalid_argument if the machine cannot execute the command; the message begins with the request.
  void command(const std::string& machine, const MachineCommand& command, System& system, SystemState& state);

  /// Returns the assumptions about the controllers for the reader of the results.
  Assumptions assumptions() const;
  /// Returns warnings about limited commands and lost controller memory.
  Findings findings(const System& system) const;

  void save(const System& system, DynamicCheckpoint& checkpoint) const;
  /// Throws std::runtime_error if the checkpoint has other controllers.
  void restore(const DynamicCheckpoint& checkpoint, System& system);

 private:
  std::vector<CommandedMachine> machines_;
};

}  // namespace overbend
