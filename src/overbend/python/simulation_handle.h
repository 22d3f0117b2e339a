/// A simulation as Python holds it.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "dynamics/run/simulation.h"
#include "python/given_controller.h"
#include "python/model_handle.h"
#include "recording/dynamic_stations.h"
#include "study/run/prepared_case.h"

namespace overbend {

/// A state of a simulation, for one of the same model.
struct SavedSimulation {
  std::string input;  ///< Of the case that it is of, with its seed.
  DynamicCheckpoint state;
};

class SimulationHandle {
 public:
  /// The model with its statics solved, at the beginning of the build-up. `stage`, `duration` and `seed` as of runs.
  /// Throws SolveFault, EndedRun and what ModelHandle throws.
  SimulationHandle(const ModelHandle& model, const std::string& stage, std::optional<double> duration,
                   std::optional<std::uint64_t> seed, GivenControllers controllers);

  /// Throws std::runtime_error while another thread goes on with it.
  const Simulation& simulation() const;
  const Model& model() const { return prepared_->model; }
  const GivenControllers& controllers() const { return controllers_; }
  /// The attachment of a machine, by its name; of a mooring line the one at its fairlead. Throws std::invalid_argument
  /// where there is none.
  std::size_t attachment_of(const std::string& machine) const;

  /// One step, or steps up to the first instant at or after a time, while `stop` is not set. Throws SolveFault where
  /// one fails, of a controller with `input`; std::runtime_error where it is at work already.
  bool step();
  void advance(double until, const std::atomic<bool>& stop);
  void command(const std::string& machine, const MachineCommand& command);

  /// Values at the nodes of the pipe, of the present.
  const Line& pipe() const;  ///< Throws std::invalid_argument where there is none.
  NodeValues values() const;
  /// Of these the first that is no laid pipe behind the line of statics.
  std::size_t first_node() const;

  SavedSimulation save() const;
  /// Throws std::invalid_argument where it is of another model, seed or other controllers.
  void restore(const SavedSimulation& saved);

 private:
  class Work;
  bool take_step();

  GivenControllers controllers_;
  std::shared_ptr<const PreparedCase> prepared_;
  std::string input_;
  std::optional<Simulation> simulation_;
  std::atomic<std::thread::id> worker_{};  ///< Of the thread that is at work; none.
};

}  // namespace overbend
