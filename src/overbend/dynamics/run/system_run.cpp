#include "dynamics/run/system_run.h"

#include <algorithm>
#include <limits>

#include "dynamics/integrator/step_failure.h"
#include "dynamics/integrator/step_loop.h"
#include "dynamics/integrator/wall_time.h"
#include "dynamics/machines/parting.h"
#include "dynamics/run/hull_limits.h"

namespace overbend {
namespace {

constexpr double kUnlimited = 1e300;
constexpr double kFarShorter = 0.3;  ///< Than the step taken, the one that its tension asks for: it is taken again.

/// Ends that give way take the force of jerks themselves, and settle in steps of usual length only.
bool follows_snaps(const System& system) {
  return std::ranges::none_of(system.attachments, [](const Attachment& held) {
    return held.winch || held.holding < std::numeric_limits<double>::infinity();
  });
}

}  // namespace

SystemRun::SystemRun(System system, LeadEnds lead, const Sea& sea, SystemState start, const DynamicOptions& options)
    : system_(std::move(system)),
      lead_(std::move(lead)),
      options_(options),
      clock_(make_clock(options, water_interval(sea, options.output_step))),
      water_memory_(system_.lines.size()),
      state_(std::move(start)),
      watches_(2 * system_.lines.size()) {
  for (std::size_t i = 0; i < system_.lines.size(); ++i) {
    water_.emplace_back(sea, system_.lines[i].mesh, state_.lines[i].q, options.build_up, clock_.interval);
  }
  system_.surroundings = [this](double time, Surroundings& now) { surroundings(time, now); };
  assembly_.emplace(system_);
  stepper_.emplace(*assembly_, options.step);
  state_.time = clock_.time();
  chooser_.wanted = options.fixed_step.value_or(std::min(kShortStep * options.time_scale, options.max_step));
  report_.smallest_step = options.max_step;
  if (!begin()) failure_ = StaticFailure{"the masses of the lines are singular", "", "a section without mass"};
}

void SystemRun::surroundings(double time, Surroundings& now) {
  lead_(system_, time, now);
  for (std::size_t i = 0; i < water_.size(); ++i) {
    if (water_[i].calm()) continue;
    now.water[i].resize(static_cast<std::size_t>(kWaterValues) *
                        static_cast<std::size_t>(system_.lines[i].mesh.nodes()));
    water_[i].nodes_at(water_memory_[i], time, now.water[i]);
  }
}

bool SystemRun::begin() {
  for (std::size_t i = 0; i < water_.size(); ++i) {
    if (!water_[i].calm()) water_[i].start(water_memory_[i], clock_.time(), state_.lines[i].q, state_.lines[i].v);
  }
  assembly_->set_time(state_.time, state_);
  if (!begin_motion(*assembly_, state_)) return false;
  const SystemState before = state_;
  assembly_->evaluate(state_, before, {}, false);
  double scale = 0.0;
  for (std::size_t i = 0; i < system_.lines.size(); ++i) {
    scale += system_.lines[i].force_scale;
    watches_[2 * i].start(end_force(i, LineEnd::first).norm());
    watches_[2 * i + 1].start(end_force(i, LineEnd::last).norm());
  }
  for (std::size_t i = 0; i < assembly_->free_bodies(); ++i) scale += assembly_->free_body(i).force_scale;
  energy_.start(*assembly_, state_, kLeastMotion * scale, assembly_->free_bodies() > 0);
  next_ = state_;
  return true;
}

Vec3 SystemRun::end_force(std::size_t line, LineEnd end) const {
  const std::array<double, 6>& force = assembly_->line(line).end_force(end);
  return {force[0], force[1], force[2]};
}

void SystemRun::adapt(double h) {
  chooser_.took(h);
  if (options_.fixed_step) {
    chooser_.wanted = *options_.fixed_step;
    return;
  }
  const double error =
      chooser_.error(options_.error_tolerance, options_.max_step, [&] { return stepper_->local_error(state_, next_); });
  chooser_.adapt(error, options_.error_tolerance, longest_by_tension(h));
  for (std::size_t i = 0; i < watches_.size(); ++i) watches_[i].took(watched_tension(i), h);
}

double SystemRun::watched_tension(std::size_t watch) const {
  return end_force(watch / 2, watch % 2 == 0 ? LineEnd::first : LineEnd::last).norm();
}

/// After a step of `h` just tried [s].
double SystemRun::longest_by_tension(double h) const {
  const double usual = kShortStep * options_.time_scale;
  const ShortestSteps shortest{usual, follows_snaps(system_) ? kEventStep * options_.time_scale : usual};
  double longest = options_.max_step;
  for (std::size_t i = 0; i < watches_.size(); ++i) {
    longest = std::min(longest, watches_[i].longest_step(watched_tension(i), h, shortest));
  }
  return longest;
}

/// Lines whose time has come hang free from here on, with the accelerations that they then have.
bool SystemRun::part_lines() {
  if (!part_due_lines(system_, state_)) return true;
  assembly_->set_time(state_.time, state_);
  stepper_->forget();
  if (!options_.fixed_step) chooser_.start_short(kEventStep * options_.time_scale);
  return begin_motion(*assembly_, state_);
}

/// Tries a step of `h` towards the tick at `target`.
bool SystemRun::attempt(double h, double target) {
  const StepReport step = stepper_->step(state_, h, next_);
  report_.newton_iterations += step.iterations;
  report_.factorisations += step.factorisations;
  if (!step.converged()) {
    ++report_.rejected_steps;
    chooser_.wanted = 0.5 * h;
    if (chooser_.wanted < kSmallestStep) failure_ = step_failure(step, system_, state_.time);
    return false;
  }
  failure_ = hull_failure(system_, next_);
  if (failure_) return false;
  const double longest = longest_by_tension(h);
  if (!options_.fixed_step && follows_snaps(system_) && longest < kFarShorter * h) {
    ++report_.rejected_steps;  // a line snapped within it
    chooser_.wanted = longest;
    return false;
  }
  if (target - state_.time - h < 1e-6 * h) next_.time = target;
  accept(h);
  return true;
}

void SystemRun::accept(double h) {
  adapt(h);
  energy_.add(*assembly_, next_, h);
  std::swap(state_, next_);
  ++report_.steps;
  report_.smallest_step = std::min(report_.smallest_step, h);
  report_.largest_step = std::max(report_.largest_step, h);
  for (SystemObserver* observer : observers_) observer->stepped(*this);
}

void SystemRun::reach_tick() {
  ++clock_.tick;
  for (std::size_t i = 0; i < water_.size(); ++i) {
    if (!water_[i].calm()) water_[i].advance(water_memory_[i], state_.lines[i].q, state_.lines[i].v);
  }
  if (!clock_.at_row()) return;
  for (SystemObserver* observer : observers_) observer->row(*this);
  stepper_->forget();
}

bool SystemRun::step() {
  if (failure_ || finished()) return false;
  const WallTime measured(report_.wall_time);
  if (!part_lines()) failure_ = StaticFailure{"the masses of a line that parts are singular", "", ""};
  const double target = static_cast<double>(clock_.tick + 1) * clock_.interval;
  const double to_parting = options_.fixed_step ? kUnlimited : time_to_parting(system_, state_);
  do {
    if (failure_) return false;
  } while (!attempt(std::min(chooser_.choose(target - state_.time, kUnlimited), to_parting), target));
  if (state_.time >= target) reach_tick();
  return true;
}

bool SystemRun::advance(double until) {
  while (state_.time < until && step()) {
  }
  return !failure_;
}

}  // namespace overbend
