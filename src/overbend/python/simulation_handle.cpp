#include "python/simulation_handle.h"

#include <fmt/format.h>

#include <algorithm>

#include "python/python_errors.h"
#include "python/statics_handle.h"
#include "study/run/case.h"

namespace overbend {
namespace {

std::shared_ptr<const PreparedCase> taken(std::variant<std::shared_ptr<const PreparedCase>, RunEnd> made) {
  if (const auto* fault = std::get_if<RunEnd>(&made)) throw EndedRun(*fault);
  return std::get<std::shared_ptr<const PreparedCase>>(std::move(made));
}

std::shared_ptr<const PreparedCase> prepared_of(const ModelHandle& model, const std::string& stage,
                                                std::optional<double> duration, const GivenControllers& controllers) {
  Description description = chosen_description(model, stage);
  set_duration(description, duration);
  return taken(prepare_case(description, uses_of(controllers)));
}

}  // namespace

SimulationHandle::SimulationHandle(const ModelHandle& model, const std::string& stage, std::optional<double> duration,
                                   std::optional<std::uint64_t> seed, GivenControllers controllers)
    : controllers_(std::move(controllers)), prepared_(prepared_of(model, stage, duration, controllers_)) {
  DynamicOptions options = dynamic_options(prepared_->model);
  options.seed = seed.value_or(options.seed);
  options.controllers = prepared_->controllers;
  input_ = fmt::format("{}\n# seed {}\n", prepared_->input, options.seed);
  simulation_.emplace(prepared_->model, prepared_->start, prepared_->statics.top_tension, options);
  if (simulation_->failure()) throw SolveFault(*simulation_->failure());
}

std::size_t SimulationHandle::attachment_of(const std::string& machine) const {
  const System& system = simulation().system();
  if (machine == kTensionerMachine) {
    if (const std::optional<LaidPipe> pipe = find_laid_pipe(system)) return pipe->tensioner;
    throw std::invalid_argument("the model has no tensioner");
  }
  for (const std::size_t line : find_lines(system, LineRole::mooring)) {
    if (system.lines[line].name != machine) continue;
    if (const std::optional<std::size_t> fairlead = find_attachment(system, line, LineEnd::last)) return *fairlead;
  }
  throw std::invalid_argument("there is no mooring line '" + machine + "' of elements");
}

/// One thread at a time, and no steps from within a controller.
class SimulationHandle::Work {
 public:
  explicit Work(SimulationHandle& handle) : handle_(handle) {
    std::thread::id nobody{};
    if (!handle_.worker_.compare_exchange_strong(nobody, std::this_thread::get_id())) {
      throw std::runtime_error("the simulation is at work: it cannot be advanced by a controller or another thread");
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
    throw std::runtime_error("the simulation is at work in another thread");
  }
  return *simulation_;
}

bool SimulationHandle::take_step() {
  const bool stepped = simulation_->step();
  if (simulation_->failure()) throw SolveFault(*simulation_->failure());
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
  const Instant now = simulation_->now();
  NodeValues values;
  values.resize(static_cast<std::size_t>(line.mesh.nodes()));
  NodeRecovery(prepared_->model, line).recover(now.pipe(), now.pipe_assembly(), now.water(), values);
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
    throw std::invalid_argument(
        "the state is of a simulation of another model, with another seed or other controllers");
  }
  const Work work(*this);
  simulation_->restore(saved.state);
}

}  // namespace overbend
