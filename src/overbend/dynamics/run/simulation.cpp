#include "dynamics/run/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>

#include "dynamics/integrator/initial_acceleration.h"
#include "dynamics/integrator/step_failure.h"
#include "dynamics/integrator/wall_time.h"
#include "dynamics/machines/line_failure.h"
#include "dynamics/machines/tensioner_events.h"
#include "dynamics/run/hull_limits.h"
#include "dynamics/setup/stinger_setup.h"
#include "statics/solver/coupled_equilibrium.h"

namespace overbend {
namespace {

constexpr double kUnlimited = 1e300;

/// The distribution of the pipe's load among side rollers depends on the friction that lets it slide across as the
/// contacts open and turn: longer steps change their loads by a tenth and halve those of lightly loaded ones.
bool is_on_side_rollers(const RollerContacts& rollers) {
  for (int i = 0; i < rollers.count(); ++i) {
    const bool carries = rollers.contacts()[static_cast<std::size_t>(i)].normal > 0.0;
    if (carries && rollers.roller(i).position != RollerPosition::bottom) return true;
  }
  return false;
}

}  // namespace

Simulation::Simulation(const Model& model, const StaticSolution& start, double top_tension,
                       const DynamicOptions& options)
    : Simulation(model, make_run_start(model, start, top_tension, options), options) {}

Simulation::Simulation(const Model& model, RunStart start, const DynamicOptions& options)
    : options_(options),
      setup_(std::move(start.setup)),
      clock_(make_clock(options, setup_.interval)),
      pipe_(find_laid_pipe(setup_.system)),
      controllers_(model, options.controllers, setup_.mooring_names, clock_.time(), setup_.system),
      ahead_W_(level_ahead(model.nominal_pose)),
      state_(std::move(start.state)),
      monitors_(setup_.system, options.time_scale) {
  options_.max_step = std::min(options_.max_step, controllers_.max_allowed_step());
  setup_.system.surroundings = [this](double time, Surroundings& target) { surroundings(time, target); };
  failure_ = solve_initial_equilibrium(setup_, options_.release, state_);
  if (failure_) return;
  water_.emplace(setup_.sea, setup_.system, state_, options.build_up, setup_.interval);
  assembly_.emplace(setup_.system);
  stepper_.emplace(*assembly_, options.step);
  tracker_.emplace(setup_.rollers, options.impacts);
  if (setup_.move && pipe_) conveyor_.emplace(model, setup_.system);
  chooser_.wanted = options.fixed_step.value_or(std::min(kShortStep * options.time_scale, options.max_step));
  ended_.reserve(setup_.rollers.size());
  tried_.resize(assembly_->tensioners().size());
  begin();
}

void Simulation::surroundings(double time, Surroundings& target) {
  set_prescribed_motions(setup_, time, target);
  if (water_) water_->fill(time, target.water);
}

void Simulation::begin() {
  water_->start(state_);
  assembly_->set_time(state_.time, state_);
  for (std::size_t i = 0; i < assembly_->tensioners().size(); ++i) {
    const std::size_t attachment = assembly_->tensioners()[i].attachment;
    assembly_->set_drive(
        i, first_drive(*setup_.system.attachments[attachment].tensioner, state_.attachments[attachment].machine));
  }
  assembly_->impose_ends(state_);
  mobilise_roller_friction(*assembly_, state_);
  preload_hinge_stops(*assembly_, state_, setup_.system);
  if (!begin_motion(*assembly_, state_)) {
    failure_ = StaticFailure{"the masses of the lines are singular", "", "a section without mass"};
    return;
  }
  const SystemState before = state_;
  assembly_->evaluate(state_, before, {}, false);
  observe_tensions(*assembly_, 0.0, state_);
  controllers_.begin(*assembly_, state_);
  monitors_.start(*assembly_);
  energy_.start(*assembly_, state_, kMinMotion * energy_scale(), assembly_->free_bodies() > 0);
  ended_.clear();
  tracker_->accept(contacts(), state_.time, 1.0, ended_);
  report_.min_step_taken = options_.max_step;
  next_ = state_;
  find_elevation();
}

/// Contacts of the rollers with the pipe.
const std::vector<RollerContact>& Simulation::contacts() const {
  static const std::vector<RollerContact> none;
  return pipe_ ? assembly_->line(pipe_->line).contacts().contacts() : none;
}

/// Sets the last drive modes of the tensioners.
void Simulation::set_drives() {
  for (std::size_t i = 0; i < assembly_->tensioners().size(); ++i) {
    assembly_->set_drive(i, state_.attachments[assembly_->tensioners()[i].attachment].machine.drive);
  }
}

/// Force scale of the minimum energy throughput: of the pipe that is laid, else of all moving lines [N].
double Simulation::energy_scale() const {
  if (pipe_) return setup_.system.lines[pipe_->line].force_scale;
  double scale = 0.0;
  for (const Line& line : setup_.system.lines) scale += line.force_scale;
  for (std::size_t i = 0; i < assembly_->free_bodies(); ++i) scale += assembly_->free_body(i).force_scale;
  return scale;
}

/// Releases the ends of lines that fail now and recomputes the accelerations.
bool Simulation::fail_lines() {
  if (!fail_due_lines(setup_.system, state_)) return true;
  assembly_->set_time(state_.time, state_);
  set_drives();
  stepper_->forget();
  if (!options_.fixed_step) chooser_.restart_with_step(kEventStep * options_.time_scale);
  return begin_motion(*assembly_, state_);
}

void Simulation::find_elevation() {
  const Vec3 place = setup_.water_place + (setup_.move ? setup_.move->at(state_.time).distance : 0.0) * ahead_W_;
  elevation_ = elevation(setup_.sea, state_.time, half_cosine(state_.time, options_.build_up), place.x(), place.y());
}

Instant Simulation::present() const {
  Instant instant{&state_, &*assembly_, tensioner(), state_.last_step, elevation_, energy_.balance().drift(), {}, {}};
  if (pipe_) instant.pipe_line = pipe_->line;
  if (instant.tensioner != nullptr) instant.move.paid_out = instant.tensioner->travel.q;
  if (setup_.move) {
    instant.move.moves = true;
    instant.move.planned = setup_.move->at(state_.time);
    instant.move.ahead_W = instant.move.planned.distance * ahead_W_;
  }
  if (conveyor_) {
    instant.move.paid_out += conveyor_->travelled();
    instant.move.joints = conveyor_->fed() / setup_.joint;
  }
  return instant;
}

/// Converts paid-out pipe to elements.
void Simulation::convey() {
  if (!conveyor_ || !conveyor_->due(setup_.system, state_)) return;
  const InstantEnergy before = assembly_->energy(state_);
  conveyor_->act(setup_.system, state_, assembly_->surroundings().ends[pipe_->tensioner]);
  water_->renew(pipe_->line, setup_.system.lines[pipe_->line].mesh, state_);
  renew_system();
  energy_.carry(before, *assembly_, state_);
  monitors_.renew(*assembly_);
}

/// Rebuilds assembly and stepper for the present sizes of the lines, at the present state.
void Simulation::renew_system() {
  assembly_.emplace(setup_.system);
  stepper_.emplace(*assembly_, options_.step);
  evaluate_present();
}

void Simulation::observe(SimulationObserver& observer) {
  observers_.push_back(&observer);
  observer.begun(present());
}

void Simulation::set_tension(double wanted) {
  if (!pipe_) throw std::invalid_argument("there is no tensioner to set");
  set_target_tension(*setup_.system.attachments[pipe_->tensioner].tensioner, wanted);
}

void Simulation::command(const std::string& machine, const MachineCommand& command) {
  controllers_.command(machine, command, setup_.system, state_);
}

void Simulation::call_controllers() {
  if (!failure_ && controllers_.active()) {
    failure_ = controllers_.ask(*assembly_, present().move.paid_out, setup_.system, state_);
  }
}

void Simulation::adapt(double h) {
  chooser_.took(h);
  if (options_.fixed_step) {
    chooser_.wanted = *options_.fixed_step;
    return;
  }
  const double error =
      chooser_.error(options_.error_tolerance, options_.max_step, [&] { return stepper_->local_error(state_, next_); });
  double max_step = std::min(options_.max_step, monitors_.max_allowed_step(*assembly_, h));
  if (pipe_ && !options_.impacts.captured && is_on_side_rollers(assembly_->line(pipe_->line).contacts())) {
    max_step = std::min(max_step, kShortStep * options_.time_scale);
  }
  monitors_.took(*assembly_, h);
  chooser_.adapt(error, options_.error_tolerance, max_step);
}

/// Time until the tensioner's delay ends or a line fails [s].
double Simulation::time_to_event() const {
  if (options_.fixed_step) return kUnlimited;
  return std::min(time_to_line_failure(setup_.system, state_),
                  time_to_tensioner(setup_.system, state_, kEventStep * options_.time_scale));
}

bool Simulation::reject(double wanted) {
  ++report_.rejected_steps;
  chooser_.wanted = wanted;
  return false;
}

/// Tries a step of `h` towards the tick at `target`. `to_event` receives the tensioners' limit for the next attempt.
bool Simulation::attempt(double h, double target, double& to_event) {
  const StepReport step = stepper_->step(state_, h, next_);
  report_.newton_iterations += step.iterations;
  report_.factorisations += step.factorisations;
  if (!step.converged()) {
    reject(0.5 * h);
    if (chooser_.wanted < kMinTimeStep) failure_ = step_failure(step, setup_.system, state_.time);
    return false;
  }
  if (!options_.fixed_step) {
    const ImpactLimit impact = tracker_->check(contacts(), h);
    if (impact.reject) return reject(impact.step);
    to_event = step_to_tensioner(*assembly_, h, state_, next_, kEventStep * options_.time_scale, tried_);
    if (to_event < h) return reject(chooser_.wanted);
    const double max_step = monitors_.max_allowed_step(*assembly_, h);
    if (monitors_.snapped(h, max_step)) return reject(max_step);
  }
  failure_ = hull_failure(setup_.system, next_);
  if (failure_) return false;
  if (target - state_.time - h < 1e-6 * h) next_.time = target;
  accept(h);
  return true;
}

void Simulation::accept(double h) {
  adapt(h);
  energy_.add(*assembly_, next_, h);
  ended_.clear();
  tracker_->accept(contacts(), next_.time, h, ended_);
  observe_tensions(*assembly_, h, next_);
  std::swap(state_, next_);
  find_elevation();
  ++report_.steps;
  report_.min_step_taken = std::min(report_.min_step_taken, h);
  report_.max_step_taken = std::max(report_.max_step_taken, h);
  const Instant instant = present();
  for (SimulationObserver* observer : observers_) {
    for (const EndedImpact& ended : ended_) observer->impact(ended);
    observer->stepped(instant);
  }
}

void Simulation::reach_tick() {
  ++clock_.tick;
  water_->advance(state_);
  if (!clock_.at_row()) return;
  const Instant instant = present();
  for (SimulationObserver* observer : observers_) observer->row(instant, row_number());
  stepper_->forget();  // as after a restart
}

bool Simulation::step() {
  if (failure_ || finished()) return false;
  const WallTime measured(report_.wall_time);
  if (!fail_lines()) failure_ = StaticFailure{"the masses of a line that parts are singular", "", ""};
  call_controllers();
  const double target = static_cast<double>(clock_.tick + 1) * clock_.interval;
  double to_event = kUnlimited, h = 0.0;
  std::fill(tried_.begin(), tried_.end(), EventTry{});
  do {
    if (failure_) return false;
    const double max_step = options_.fixed_step ? kUnlimited : tracker_->step_limit();
    h = std::min(chooser_.choose(target - state_.time, max_step), std::min(to_event, time_to_event()));
  } while (!attempt(h, target, to_event));
  if (state_.time >= target) reach_tick();
  convey();
  return true;
}

bool Simulation::advance(double until) {
  while (state_.time < until && step()) {
  }
  return !failure_;
}

}  // namespace overbend
