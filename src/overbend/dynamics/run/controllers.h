/// The machines of a simulation that somebody outside commands: when they are asked, what they are told, what of that
/// they can do.
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

/// How failures of controllers begin.
inline constexpr const char* kControllerOf = "the controller of ";

/// A machine that takes commands.
struct CommandedMachine {
  std::string name;   ///< kTensionerMachine, or the mooring line's.
  std::string words;  ///< For messages: "the tensioner", "the winch of mooring line 'bow'".
  std::size_t attachment = 0;
  Controller* controller = nullptr;
  double interval = 0.0;               ///< [s]
  MachineReading before{};             ///< What was seen at the instant before.
  std::int64_t next = 0;               ///< It is asked next at this multiple of the interval.
  double fastest_asked = 0.0;          ///< Largest speed that was asked for [m/s].
  std::optional<double> stopped_at{};  ///< When it was first found at the end of its travel [s].
  std::optional<double> forgot_at{};   ///< Where it was taken up last without a memory of its controller's [s].

  double asked_at() const { return static_cast<double>(next) * interval; }  ///< Next [s].
};

class Controllers {
 public:
  /// Gives winches their laws where they have none. `moorings`: names of the mooring lines, of elements or not.
  /// `start`: the first instant [s]. Throws std::invalid_argument for a machine that is not there.
  Controllers(const Model& model, const std::vector<ControllerUse>& uses, const std::vector<std::string>& moorings,
              double start, System& system);

  /// The tensioner first, where there is one, then those of the uses, in their order.
  const std::vector<CommandedMachine>& machines() const { return machines_; }
  /// Whether somebody is asked at all.
  bool active() const;
  /// The longest step that leaves them time to act: a quarter more than the shortest interval, so that the usual
  /// longest step serves the usual interval; infinite where nobody is asked [s].
  double longest_step() const;
  /// What winches measure, before the first step.
  void begin(const Assembly& assembly, SystemState& state) const;
  /// Asks at the present instant, for those times that have come since the instant before: what they see is between the
  /// two, straight; what they answer is in force from now on. `paid_out`: by the tensioner since the start [m].
  /// Allocates nothing but on failure.
  std::optional<StaticFailure> ask(const Assembly& assembly, double paid_out, System& system, SystemState& state);
  /// Throws std::invalid_argument for what the machine cannot do; the message begins with what was asked.
  void command(const std::string& machine, const MachineCommand& command, System& system, SystemState& state);

  /// What a reader of the results has to know of the controllers.
  Assumptions assumptions() const;
  Findings findings(const System& system) const;

  void save(const System& system, DynamicCheckpoint& checkpoint) const;
  /// Throws std::runtime_error where the checkpoint is of other controllers.
  void restore(const DynamicCheckpoint& checkpoint, System& system);

 private:
  std::vector<CommandedMachine> machines_;
};

}  // namespace overbend
