#include "dynamics/run/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include "dynamics/integrator/step_failure.h"
#include "dynamics/integrator/step_loop.h"
#include "dynamics/integrator/wall_time.h"
#include "dynamics/machines/parting.h"
#include "dynamics/run/hull_limits.h"
#include "dynamics/setup/free_start.h"
#include "dynamics/setup/laid_tail.h"
#include "dynamics/setup/stinger_setup.h"
#include "statics/solver/rest_together.h"

namespace overbend {
namespace {

constexpr double kUnlimited = 1e300;

/// How the pipe is shared among side rollers hangs on where friction lets it slide across, as the contacts open and
/// turn: longer steps shift their loads by a tenth and halve those of light ones.
bool leans_on_sides(const RollerContacts& rollers) {
  for (int i = 0; i < rollers.count(); ++i) {
    const bool carries = rollers.contacts()[static_cast<std::size_t>(i)].normal > 0.0;
    if (carries && rollers.roller(i).position != RollerPosition::bottom) return true;
  }
  return false;
}

}  // namespace

Simulation::Simulation(const Model& model, const StaticSolution& start, double top_tension,
                       const DynamicOptions& options)
    : Simulation(model, options, with_laid_tail(model, start, top_tension, options.tail_reach), top_tension) {}

Simulation::Simulation(const Model& model, const DynamicOptions& options, const StaticSolution& start,
                       double top_tension)
    : options_(options),
      setup_(make_setup(model, start, top_tension, options)),
      clock_(make_clock(options, setup_.interval)),
      controllers_(model, options.controllers, setup_.mooring_names, clock_.time(), setup_.system),
      shoe_(point_from_ramp(model, model.mean_pose, Vec3::Zero())),
      ahead_W_(level_ahead(model.drawn_pose)) {
  options_.max_step = std::min(options_.max_step, controllers_.longest_step());
  setup_.system.surroundings = [this](double time, Surroundings& now) { surroundings(time, now); };
  assembly_.emplace(setup_.system);
  stepper_.emplace(*assembly_, options.step);
  tracker_.emplace(setup_.rollers, options.impacts);
  if (setup_.move) conveyor_.emplace(model, setup_.system);
  state_ = static_state(setup_.system, start, setup_.moorings, clock_.time());
  for (std::size_t i = 0; i < setup_.system.lines.size(); ++i) {
    water_.emplace_back(setup_.sea, setup_.system.lines[i].mesh, state_.lines[i].q, options.build_up, setup_.interval);
  }
  water_memory_.resize(water_.size());
  chooser_.wanted = options.fixed_step.value_or(std::min(kShortStep * options.time_scale, options.max_step));
  ended_.reserve(setup_.rollers.size());
  if (!begin() && !failure_) {
    failure_ = StaticFailure{"the masses of the line are singular", "", "a section without mass"};
  }
}

void Simulation::surroundings(double time, Surroundings& now) {
  move_vessel(setup_, time, now);
  lead_attachments(setup_.system, now);
  for (std::size_t i = 0; i < water_.size(); ++i) {
    if (water_[i].calm()) continue;
    std::vector<double>& water = now.water[i];
    water.resize(static_cast<std::size_t>(kWaterValues) *
                 static_cast<std::size_t>(setup_.system.lines[i].mesh.nodes()));
    water_[i].nodes_at(water_memory_[i], time, water);
  }
}

bool Simulation::begin() {
  for (std::size_t i = 0; i < water_.size(); ++i) {
    if (!water_[i].calm()) {
      water_[i].start(water_memory_[i], clock_.time(), state_.lines[i].q, state_.lines[i].v);
    }
  }
  if (setup_.hull) {
    let_hull_go();
  } else if (!setup_.moorings.empty()) {
    rest_moorings();
  }
  if (failure_) {
    return false;
  }
  assembly_->set_time(state_.time, state_);
  assembly_->set_drive(first_drive(tensioner_of(setup_.system), tensioner(state_).machine));
  assembly_->impose_ends(state_);
  mobilise_roller_friction(*assembly_, state_);
  lean_on_stops(*assembly_, state_, setup_.system);
  if (!begin_motion(*assembly_, state_)) return false;
  const SystemState before = state_;
  assembly_->evaluate(state_, before, {}, false);
  observe_tension(state_, 0.0);
  controllers_.begin(*assembly_, state_);
  watch_.start(assembly_->machine_tension());
  energy_.start(*assembly_, state_, kLeastMotion * pipe().force_scale, assembly_->free_bodies() > 0);
  ended_.clear();
  tracker_->accept(contacts(), state_.time, 1.0, ended_);
  report_.smallest_step = options_.max_step;
  find_elevation();
  return true;
}

/// Hull, lines and pipe to rest. What the tensioner has paid out for that is where it begins.
void Simulation::let_hull_go() {
  failure_ = overbend::let_hull_go(setup_.system, setup_.ballast, setup_.hull->hull, options_.release, state_);
  Attachment& top = setup_.system.attachments[machine()];
  top.place -= tensioner(state_).travel.q * top.direction;
  tensioner(state_).travel = {};
}

/// On a vessel whose motion is told the lines alone come to rest.
void Simulation::rest_moorings() {
  assembly_->set_time(state_.time, state_);
  failure_ = rest_mooring_lines(setup_.system, assembly_->surroundings().bodies, setup_.mooring_names, state_);
}

/// Lines whose time has come hang free from here on, with the accelerations that all then have.
bool Simulation::part_lines() {
  if (!part_due_lines(setup_.system, state_)) return true;
  assembly_->set_time(state_.time, state_);
  assembly_->set_drive(tensioner(state_).machine.drive);
  stepper_->forget();
  if (!options_.fixed_step) chooser_.start_short(kEventStep * options_.time_scale);
  return begin_motion(*assembly_, state_);
}

void Simulation::find_elevation() {
  const Vec3 shoe = shoe_ + (setup_.move ? setup_.move->at(state_.time).way : 0.0) * ahead_W_;
  elevation_ = elevation(setup_.sea, state_.time, half_cosine(state_.time, options_.build_up), shoe.x(), shoe.y());
}

Instant Simulation::now() const {
  Instant at{&state_, &*assembly_, &tensioner(state_), state_.last_step, elevation_, energy_.balance().drift(), {}};
  at.move.paid_out = tensioner(state_).travel.q;
  if (setup_.move) {
    at.move.moves = true;
    at.move.way = setup_.move->at(state_.time);
    at.move.ahead_W = at.move.way.way * ahead_W_;
    at.move.paid_out += conveyor_->travelled();
    at.move.joints = conveyor_->fed() / setup_.joint;
  }
  return at;
}

/// Pipe that was paid out becomes part of the line.
void Simulation::convey() {
  if (!conveyor_ || !conveyor_->due(setup_.system, state_)) return;
  const InstantEnergy before = assembly_->energy(state_);
  conveyor_->act(setup_.system, state_, assembly_->surroundings().ends[machine()]);
  if (!water_.front().calm()) {
    const LineState& pipe = state_.lines.front();
    water_.front() =
        WaterField(setup_.sea, setup_.system.lines.front().mesh, pipe.q, options_.build_up, setup_.interval);
    water_.front().renew(water_memory_.front(), state_.time, pipe.q, pipe.v);
  }
  renew_system();
  energy_.carry(before, *assembly_, state_);
  watch_.last = assembly_->machine_tension();
}

/// Assembly and stepper of the sizes that the lines have now, at the present state.
void Simulation::renew_system() {
  assembly_.emplace(setup_.system);
  stepper_.emplace(*assembly_, options_.step);
  evaluate_present();
}

void Simulation::observe(SimulationObserver& observer) {
  observers_.push_back(&observer);
  observer.begun(now());
}

void Simulation::set_tension(double wanted) {
  set_wanted_tension(set_law(), wanted);
}

void Simulation::command(const std::string& machine, const MachineCommand& command) {
  controllers_.command(machine, command, setup_.system, state_);
}

void Simulation::ask_controllers() {
  if (!failure_ && controllers_.active()) {
    failure_ = controllers_.ask(*assembly_, now().move.paid_out, setup_.system, state_);
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
  const double shortest = kShortStep * options_.time_scale, tension = assembly_->machine_tension();
  const bool leans = !options_.impacts.captured && leans_on_sides(assembly_->line(0).contacts());
  const double longest =
      std::min(leans ? shortest : options_.max_step, watch_.longest_step(tension, h, {shortest, shortest}));
  watch_.took(tension, h);
  chooser_.adapt(error, options_.error_tolerance, std::min(longest, options_.max_step));
}

/// The tensioner takes the tension at the end of a step of `h`, and stops or starts.
void Simulation::observe_tension(SystemState& state, double h) {
  AttachmentState& held = tensioner(state);
  const Travel travel{held.travel.q, held.travel.v, held.travel.acc};
  const Travel after =
      overbend::observe(tensioner_of(setup_.system), assembly_->machine_tension(), h, travel, held.machine);
  if (after.length != travel.length || after.speed != travel.speed) {
    held.travel = {after.length, after.speed, after.acceleration, after.acceleration};
  }
}

/// Until the tensioner's delay is over, or a line parts [s].
double Simulation::to_timed_event() const {
  if (options_.fixed_step) {
    return kUnlimited;
  }
  const double to_parting = time_to_parting(setup_.system, state_);
  const TensionerLaw& law = tensioner_of(setup_.system);
  if (law.mode != TensionerMode::controlled) {
    return to_parting;
  }
  return std::min(to_parting, std::max(time_to_move(law, tensioner(state_).machine), kEventStep * options_.time_scale));
}

/// How long the step just tried may be to meet the instant at which its tension makes the tensioner change [s]; `tried`
/// is the try before, and becomes this one.
double Simulation::step_to_tensioner(double h, EventTry& tried) const {
  const TensionerLaw& law = tensioner_of(setup_.system);
  if (law.mode != TensionerMode::controlled || options_.fixed_step) {
    return h;
  }
  const AttachmentState &now = tensioner(state_), &next = tensioner(next_);
  const EventTry before =
      tried.h > 0.0 ? tried : EventTry{0.0, excess(law, now.machine, now.machine.tension, now.travel.v)};
  tried = {h, excess(law, next.machine, assembly_->machine_tension(), next.travel.v)};
  return step_to_event(law, before, tried, kEventStep * options_.time_scale);
}

bool Simulation::reject(double wanted) {
  ++report_.rejected_steps;
  chooser_.wanted = wanted;
  return false;
}

/// Tries a step of `h` towards the tick at `target`. `to_event` receives what the tensioner allows the next try,
/// `tried` what this one did.
bool Simulation::attempt(double h, double target, double& to_event, EventTry& tried) {
  const StepReport step = stepper_->step(state_, h, next_);
  report_.newton_iterations += step.iterations;
  report_.factorisations += step.factorisations;
  if (!step.converged()) {
    reject(0.5 * h);
    if (chooser_.wanted < kSmallestStep) failure_ = step_failure(step, setup_.system, state_.time);
    return false;
  }
  const ImpactLimit impact = tracker_->check(contacts(), h);
  if (impact.reject && !options_.fixed_step) return reject(impact.step);
  to_event = step_to_tensioner(h, tried);
  if (to_event < h) return reject(chooser_.wanted);
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
  observe_tension(next_, h);
  std::swap(state_, next_);
  find_elevation();
  ++report_.steps;
  report_.smallest_step = std::min(report_.smallest_step, h);
  report_.largest_step = std::max(report_.largest_step, h);
  const Instant at = now();
  for (SimulationObserver* observer : observers_) {
    for (const EndedImpact& ended : ended_) observer->impact(ended);
    observer->stepped(at);
  }
}

void Simulation::reach_tick() {
  ++clock_.tick;
  for (std::size_t i = 0; i < water_.size(); ++i) {
    if (!water_[i].calm()) {
      water_[i].advance(water_memory_[i], state_.lines[i].q, state_.lines[i].v);
    }
  }
  if (!clock_.at_row()) return;
  const Instant at = now();
  for (SimulationObserver* observer : observers_) observer->row(at, row_number());
  stepper_->forget();  // a simulation restored here has none
}

bool Simulation::step() {
  if (failure_ || finished()) return false;
  const WallTime measured(report_.wall_time);
  if (!part_lines()) failure_ = StaticFailure{"the masses of a line that parts are singular", "", ""};
  ask_controllers();
  const double target = static_cast<double>(clock_.tick + 1) * clock_.interval;
  double to_event = kUnlimited, h = 0.0;
  EventTry tried;
  do {
    if (failure_) return false;
    const double longest = options_.fixed_step ? kUnlimited : tracker_->step_limit();
    h = std::min(chooser_.choose(target - state_.time, longest), std::min(to_event, to_timed_event()));
  } while (!attempt(h, target, to_event, tried));
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
