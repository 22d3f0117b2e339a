#include "python/simulation_handle.h"

#include <fmt/format.h>

#include <algorithm>

#include "python/python_errors.h"
#include "python/statics_handle.h"
#include "study/run/case.h"

namespace overbend {
namespace {

std::shared_ptr<const PreparedCase> taken(std::variant<std::shared_ptr<const PreparedCase>, RunResult> made) {
  if (const auto* error = std::get_if<RunResult>(&made)) throw EndedRun(*error);
  return std::get<std::shared_ptr<const PreparedCase>>(std::move(made));
}

std::shared_ptr<const PreparedCase> make_prepared_case(const ModelHandle& model, const std::string& stage,
                                                       std::optional<double> duration,
                                                       const GivenControllers& controllers) {
  Description description = chosen_description(model, stage);
  set_duration(description, duration);
  return taken(prepare_case(description, controller_uses(controllers)));
}

}  // namespace

SimulationHandle::SimulationHandle(const ModelHandle& model, const std::string& stage, std::optional<double> duration,
                                   std::optional<std::uint64_t> seed, GivenControllers controllers)
    : controllers_(std::move(controllers)), prepared_(make_prepared_case(model, stage, duration, controllers_)) {
  DynamicOptions options = dynamic_options(prepared_->model);
  options.seed = seed.value_or(options.seed);
  options.controllers = prepared_->controllers;
  input_ = fmt::format("{}\n# seed {}\n", prepared_->input, options.seed);
  simulation_.emplace(prepared_->model, prepared_->start, prepared_->statics.top_tension, options);
  if (simulation_->failure()) throw SolveError(*simulation_->failure());
}

std::size_t SimulationHandle::find_machine_attachment(const std::string& machine) const {
  const System& system = simulation().system();
  if (machine == kTensionerMachine) {
    if (const std::optional<LaidPipe> pipe = find_laid_pipe(system)) return pipe->tensioner;
    throw std::invalid_argument("the model has no tensioner");
  }
  for (const std::size_t line : find_lines(system, LineRole::mooring)) {
    if (system.lines[line].name != machine) continue;
    if (const std::optional<std::size_t> fairlead = find_attachment(system, line, LineEnd::last)) return *fairlead;
  }
  throw std::invalid_argument("there is no mooring line '" + machine + "' with elements");
}

/// Ensures that one thread advances the simulation at a time, and that controllers do not.
class SimulationHandle::Work {
 public:
  explicit Work(SimulationHandle& handle) : handle_(handle) {
    std::thread::id no_thread{};
    if (!handle_.worker_.compare_exchange_strong(no_thread, std::this_thread::get_id())) {
      throw std::runtime_error("the simulation is being advanced; a controller or another thread cannot advance it");
    }
  }
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;
  ~Work() { handle_.worker_ = std::thread::id{}; }

 private:
  SimulationHandle& handle_;
};

const Simulation& SimulationHandle::simulation() const {
  const std::thread::id worker = worker_;
  if (worker != std::thread::id{} && worker != std::this_thread::get_id()) {
    throw std::runtime_error("the simulation is being advanced by another thread");
  }
  return *simulation_;
}

bool SimulationHandle::take_step() {
  const bool stepped = simulation_->step();
  if (simulation_->failure()) throw SolveError(*simulation_->failure());
  return stepped;
}

bool SimulationHandle::step() {
  const Work work(*this);
  return take_step();
}

void SimulationHandle::advance(double until, const std::atomic<bool>& stop) {
  const Work work(*this);
  while (!stop && simulation_->time() < until && take_step()) {
  }
}

void SimulationHandle::command(const std::string& machine, const MachineCommand& command) {
  const Work work(*this);
  simulation_->command(machine, command);
}

const Line& SimulationHandle::pipe() const {
  const System& system = simulation().system();
  const std::optional<LaidPipe> pipe = find_laid_pipe(system);
  if (!pipe) throw std::invalid_argument("the model has no pipe");
  return system.lines[pipe->line];
}

NodeValues SimulationHandle::values() const {
  const Line& line = pipe();
  const Instant instant = simulation_->present();
  NodeValues values;
  values.resize(static_cast<std::size_t>(line.mesh.nodes()));
  NodeRecovery(prepared_->model, line).recover(instant.pipe(), instant.pipe_assembly(), instant.water(), values);
  return values;
}

std::size_t SimulationHandle::first_node() const {
  const std::vector<double>& s = pipe().mesh.s;
  return static_cast<std::size_t>(std::lower_bound(s.begin(), s.end(), 0.0) - s.begin());
}

SavedSimulation SimulationHandle::save() const {
  return {input_, simulation().checkpoint()};
}

void SimulationHandle::restore(const SavedSimulation& saved) {
  if (saved.input != input_) {
    throw std::invalid_argument("the state belongs to a simulation of another model, seed or set of controllers");
  }
  const Work work(*this);
  simulation_->restore(saved.state);
}

}  // namespace overbend
