/// A simulation in Python.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "dynamics/run/simulation.h"
#include "python/given_controller.h"
#include "python/model_handle.h"
#include "recording/node_recovery.h"
#include "study/run/prepared_case.h"

namespace overbend {

/// State of a simulation, which can be restored in a simulation of the same model.
struct SavedSimulation {
  std::string input;  ///< Input of the case, including its seed.
  DynamicCheckpoint state;
};

class SimulationHandle {
 public:
  /// Solves the statics and starts at the beginning of the build-up. `stage`, `duration` and `seed` as for runs. Throws
  /// SolveError, EndedRun and the exceptions of ModelHandle.
  SimulationHandle(const ModelHandle& model, const std::string& stage, std::optional<double> duration,
                   std::optional<std::uint64_t> seed, GivenControllers controllers);

  /// Throws std::runtime_error while another thread advances it.
  const Simulation& simulation() const;
  const Model& model() const { return prepared_->model; }
  const GivenControllers& controllers() const { return controllers_; }
  /// Returns the index of the attachment of a machine; for a mooring line, that at its fairlead. Throws
  /// std::invalid_argument if there is none.
  std::size_t find_machine_attachment(const std::string& machine) const;

  /// Takes one step, or steps until the time `until` [s] is reached or `stop` is set. Throws SolveError if a step fails
  /// (with `input` set for a failure of a controller); std::runtime_error if it is already being advanced.
  bool step();
  void advance(double until, const std::atomic<bool>& stop);
  void command(const std::string& machine, const MachineCommand& command);

  /// Returns the pipe; throws std::invalid_argument if there is none.
  const Line& pipe() const;
  /// Returns the current values at the nodes of the pipe.
  NodeValues values() const;
  /// Returns the first node that is not on the laid pipe added behind the static line.
  std::size_t first_node() const;

  SavedSimulation save() const;
  /// Throws std::invalid_argument if the state belongs to another model, seed or set of controllers.
  void restore(const SavedSimulation& saved);

 private:
  class Work;
  bool take_step();

  GivenControllers controllers_;
  std::shared_ptr<const PreparedCase> prepared_;
  std::string input_;
  std::optional<Simulation> simulation_;
  std::atomic<std::thread::id> worker_{};  ///< Thread that advances the simulation; default value if none.
};

}  // namespace overbend
