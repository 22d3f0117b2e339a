#include "dynamics/dynamics.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include "checks/run_checks.h"
#include "dynamics/dynamic_checkpoint.h"
#include "dynamics/dynamic_clock.h"
#include "dynamics/dynamic_warnings.h"
#include "dynamics/energy_account.h"
#include "dynamics/laid_tail.h"
#include "dynamics/run_setup.h"
#include "dynamics/water_field.h"
#include "recording/dynamic_recorder.h"

namespace overbend {
namespace {

constexpr double kLeastMotion = 1e-6;      ///< Of the whole line: less is rest [m].
constexpr double kSmallestStep = 1e-7;     ///< [s]
constexpr double kMostGrowth = 1.5;        ///< Of the step, from one to the next.
constexpr double kMostSnapshots = 2400.0;  ///< Of a run.
constexpr double kShortestToEvent = 1e-3;  ///< Steps are not cut further to meet a change of the tensioner [s].

std::string place_text(double time, double s) {
  return "at t = " + std::to_string(time) + " s, " + std::to_string(s) + " m from the anchor";
}

StaticFailure step_failure(const StepReport& report, const System& system, double time) {
  const auto [line, node] = report.worst_place;
  const double s = system.lines[static_cast<std::size_t>(line)].mesh.s[static_cast<std::size_t>(node)];
  return {"the time step cannot be solved", place_text(time, s),
          report.end == StepEnd::singular ? "the equations have no solution there"
                                          : "forces stay out of balance however short the step is"};
}

class Run {
 public:
  Run(const Model& model, const StaticSolution& start, double static_tension, const DynamicOptions& options)
      : model_(model),
        options_(options),
        setup_(make_setup(model, start, static_tension, options)),
        clock_(make_clock(options, setup_.interval)),
        water_(setup_.sea, start.mesh, start.state.q, options.build_up, setup_.interval),
        shoe_(point_from_ramp(model, model.mean_pose, Vec3::Zero())) {
    setup_.system.surroundings = [this](double time, Surroundings& now) { surroundings(time, now); };
    system_.emplace(setup_.system);
    stepper_.emplace(*system_, options.step);
    tracker_.emplace(setup_.system.bodies.front().rollers, options.impacts);
    recorder_.emplace(model, setup_.system);
    state_ = static_state(setup_.system, start, clock_.time());
    chooser_.wanted = options.fixed_step.value_or(std::min(chooser_.wanted, options.max_step));
    ended_.reserve(setup_.system.bodies.front().rollers.size());
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  DynamicOutcome go(DynamicSink& sink, const DynamicCheckpoint* from, const StaticResults& statics,
                    const std::function<DynamicControl(const DynamicProgress&)>& control);

 private:
  const Line& pipe() const { return setup_.system.lines.front(); }
  const std::vector<RollerContact>& contacts() const { return system_->line(0).contacts().contacts(); }
  AttachmentState& tensioner(SystemState& state) const {
    return state.attachments[static_cast<std::size_t>(setup_.system.machine)];
  }
  void surroundings(double time, Surroundings& now);
  bool begin();
  void resume(const DynamicCheckpoint& checkpoint);
  DynamicCheckpoint checkpoint() const;
  std::optional<StaticFailure> to_next_tick(DynamicSink& sink);
  void accept(DynamicSink& sink, double h);
  void adapt(double h);
  void observe_tension(SystemState& state, double h);
  double to_timed_event();
  double step_to_tensioner(double h);
  RecordedInstant instant() const;
  void write_row(DynamicSink& sink);
  DynamicResults results(const StaticResults& statics) const;

  const Model& model_;
  DynamicOptions options_;
  RunSetup setup_;
  Clock clock_;
  WaterField water_;
  WaterMemory water_memory_;
  Vec3 shoe_;
  std::optional<Assembly> system_;
  std::optional<TimeStepper> stepper_;
  std::optional<ImpactTracker> tracker_;
  std::optional<DynamicRecorder> recorder_;
  EnergyAccount energy_;
  SystemState state_, next_;
  StepChooser chooser_;
  TensionWatch watch_;
  std::vector<Impact> ended_;
  DynamicRunReport report_;
};

void Run::surroundings(double time, Surroundings& now) {
  now.bodies.front() = vessel_motion(setup_.motion, time, half_cosine(time, options_.build_up));
  lead_attachments(setup_.system, now);
  if (!water_.calm()) {
    std::vector<double>& water = now.water.front();
    water.resize(static_cast<std::size_t>(kWaterValues) * static_cast<std::size_t>(pipe().mesh.nodes()));
    water_.nodes_at(water_memory_, time, water);
  }
}

RecordedInstant Run::instant() const {
  return {&state_, &*system_, state_.last_step,
          elevation(setup_.sea, state_.time, half_cosine(state_.time, options_.build_up), shoe_.x(), shoe_.y()),
          energy_.balance().drift()};
}

bool Run::begin() {
  if (!water_.calm()) {
    water_.start(water_memory_, clock_.time(), state_.lines.front().q, state_.lines.front().v);
  }
  system_->set_time(state_.time, state_);
  system_->set_drive(first_drive(tensioner_of(setup_.system), tensioner(state_).machine));
  system_->impose_ends(state_);
  if (!system_->find_accelerations(state_)) {
    return false;
  }
  for (LineState& line : state_.lines) {
    line.alg = line.acc;
  }
  for (AttachmentState& attachment : state_.attachments) {
    attachment.guide.alg = attachment.guide.acc;
  }
  const SystemState before = state_;
  system_->evaluate(state_, before, {}, false);
  observe_tension(state_, 0.0);
  watch_.start(system_->machine_tension());
  energy_.start(system_->energy(state_), kLeastMotion * pipe().force_scale);
  ended_.clear();
  tracker_->accept(contacts(), state_.time, 1.0, ended_);
  recorder_->start(instant());
  report_.smallest_step = options_.max_step;
  return true;
}

void Run::adapt(double h) {
  if (options_.fixed_step) {
    chooser_.wanted = *options_.fixed_step;
    return;
  }
  const double error = stepper_->local_error(state_, next_);
  const double growth =
      std::clamp(0.9 * std::cbrt(options_.error_tolerance / std::max(error, 1e-12)), 0.3, kMostGrowth);
  const double longest = std::min(options_.max_step, watch_.longest_step(system_->machine_tension(), h));
  chooser_.wanted = std::clamp(h * growth, kSmallestStep, longest);
}

void Run::accept(DynamicSink& sink, double h) {
  adapt(h);
  energy_.add(system_->energy(next_), h);
  ended_.clear();
  tracker_->accept(contacts(), next_.time, h, ended_);
  observe_tension(next_, h);
  std::swap(state_, next_);
  for (Impact& impact : ended_) {
    recorder_->count(impact);
    sink.impact(impact);
  }
  recorder_->step(instant());
  ++report_.steps;
  report_.smallest_step = std::min(report_.smallest_step, h);
  report_.largest_step = std::max(report_.largest_step, h);
}

/// The tensioner takes the tension at the end of a step of `h`, and stops or starts.
void Run::observe_tension(SystemState& state, double h) {
  AttachmentState& machine = tensioner(state);
  const Travel travel{machine.travel.q, machine.travel.v, machine.travel.acc};
  const Travel after = observe(tensioner_of(setup_.system), system_->machine_tension(), h, travel, machine.machine);
  if (after.length != travel.length || after.speed != travel.speed) {
    machine.travel = {after.length, after.speed, after.acceleration, after.acceleration};
  }
}

/// Until the tensioner's delay is over [s].
double Run::to_timed_event() {
  const TensionerLaw& law = tensioner_of(setup_.system);
  if (law.mode != TensionerMode::controlled || options_.fixed_step) {
    return 1e300;
  }
  return std::max(time_to_move(law, tensioner(state_).machine), kShortestToEvent);
}

/// How long the step just tried may be to meet the moment at which its tension makes the tensioner change [s].
double Run::step_to_tensioner(double h) {
  const TensionerLaw& law = tensioner_of(setup_.system);
  if (law.mode != TensionerMode::controlled || options_.fixed_step) {
    return h;
  }
  const AttachmentState &now = tensioner(state_), &next = tensioner(next_);
  return step_to_event(law, excess(law, now.machine, now.machine.tension, now.travel.v),
                       excess(law, next.machine, system_->machine_tension(), next.travel.v), h, kShortestToEvent);
}

std::optional<StaticFailure> Run::to_next_tick(DynamicSink& sink) {
  const double target = static_cast<double>(clock_.tick + 1) * clock_.interval;
  double to_event = 1e300;
  while (state_.time < target) {
    const double remaining = target - state_.time;
    const double h = std::min(chooser_.choose(remaining, options_.fixed_step ? 1e300 : tracker_->step_limit()),
                              std::min(to_event, to_timed_event()));
    const StepReport step = stepper_->step(state_, h, next_);
    report_.newton_iterations += step.iterations;
    report_.factorisations += step.factorisations;
    if (!step.converged()) {
      ++report_.rejected_steps;
      chooser_.wanted = 0.5 * h;
      if (chooser_.wanted < kSmallestStep) {
        return step_failure(step, setup_.system, state_.time);
      }
      continue;
    }
    const ImpactLimit impact = tracker_->check(contacts(), h);
    if (impact.reject && !options_.fixed_step) {
      ++report_.rejected_steps;
      chooser_.wanted = impact.step;
      continue;
    }
    to_event = step_to_tensioner(h);
    if (to_event < h) {
      ++report_.rejected_steps;
      continue;
    }
    to_event = 1e300;
    if (remaining - h < 1e-6 * h) {
      next_.time = target;
    }
    accept(sink, h);
  }
  ++clock_.tick;
  if (!water_.calm()) {
    water_.advance(water_memory_, state_.lines.front().q, state_.lines.front().v);
  }
  return std::nullopt;
}

void Run::write_row(DynamicSink& sink) {
  const RecordedInstant now = instant();
  sink.row(recorder_->row(now));
  const double rows = options_.duration / options_.output_step;
  const std::int64_t stride = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(rows / kMostSnapshots)));
  if (state_.time >= 0.0 && (clock_.tick / clock_.ticks_per_row) % stride == 0) {
    sink.snapshot(state_.time, recorder_->snapshot(now));
  }
}

DynamicCheckpoint Run::checkpoint() const {
  DynamicCheckpoint c;
  c.time = state_.time;
  save_state(c, state_);
  save_water(c, water_memory_);
  c.arrays.push_back({"impacts", tracker_->save()});
  c.arrays.push_back({"energy", energy_.save()});
  c.arrays.push_back({"control",
                      {chooser_.wanted, chooser_.last, static_cast<double>(clock_.tick), watch_.last, watch_.slope,
                       watch_.least, watch_.most}});
  save_report(c, report_);
  recorder_->save(c);
  return c;
}

void Run::resume(const DynamicCheckpoint& checkpoint) {
  restore_state(checkpoint, state_);
  restore_water(checkpoint, water_memory_);
  tracker_->restore(checkpoint_array(checkpoint, "impacts"));
  energy_.restore(checkpoint_array(checkpoint, "energy"));
  const std::vector<double>& control = checkpoint_array(checkpoint, "control");
  chooser_ = {control.at(0), control.at(1)};
  watch_ = {control.at(3), control.at(4), control.at(5), control.at(6)};
  clock_.tick = std::llround(control.at(2));
  restore_report(checkpoint, report_);
  recorder_->restore(checkpoint);
}

DynamicOutcome Run::go(DynamicSink& sink, const DynamicCheckpoint* from, const StaticResults& statics,
                       const std::function<DynamicControl(const DynamicProgress&)>& control) {
  DynamicOutcome outcome;
  const double end = static_cast<double>(clock_.last_tick) * clock_.interval;
  recorder_->tell_current(statics);
  const bool balanced = begin();  // also when resumed: the recorder keeps the static state from here
  if (!balanced) {
    outcome.failure = StaticFailure{"the masses of the line are singular", "", "a section without mass"};
    return outcome;
  }
  sink.begin(recorder_->columns(), recorder_->stations());
  if (from != nullptr) {
    resume(*from);
  } else {
    write_row(sink);
  }
  const double wall_before = report_.wall_time;
  const auto started = std::chrono::steady_clock::now();
  while (clock_.tick < clock_.last_tick) {
    outcome.failure = to_next_tick(sink);
    if (outcome.failure) {
      return outcome;
    }
    if (!clock_.at_row()) {
      continue;
    }
    write_row(sink);
    stepper_->forget_factors();  // a run taken up here has none
    report_.wall_time = wall_before + std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    const DynamicControl wanted = control({state_.time, end, report_.steps, recorder_->top_tension()});
    if (wanted != DynamicControl::go_on) {
      sink.checkpoint(checkpoint());
    }
    if (wanted == DynamicControl::stop && clock_.tick < clock_.last_tick) {
      outcome.stopped = true;
      if (state_.time > 0.0) {
        outcome.results = results(statics);
      }
      return outcome;
    }
  }
  outcome.results = results(statics);
  return outcome;
}

DynamicResults Run::results(const StaticResults& statics) const {
  DynamicResults r;
  r.duration = static_cast<double>(clock_.tick) * clock_.interval;
  r.build_up = options_.build_up;
  r.output_step = options_.output_step;
  r.seed = options_.seed;
  recorder_->fill(r);
  for (std::size_t i = 0; i < r.supports.size(); ++i) {
    r.supports[i].s = statics.supports.at(i).s;
  }
  r.energy = energy_.balance();
  r.run = report_;
  const double simulated = r.duration + static_cast<double>(std::ceil(r.build_up / r.output_step)) * r.output_step;
  r.run.real_time_ratio = report_.wall_time > 0.0 ? simulated / report_.wall_time : 0.0;
  r.run.integrator = "generalized-alpha, spectral radius " +
                     std::to_string(options_.step.spectral_radius).substr(0, 4) +
                     (options_.fixed_step ? ", fixed step" : ", adaptive step");
  warn_of_slack(statics, r);
  r.checks = check_dynamics(model_, statics, r);
  r.assumptions.insert(r.assumptions.end(), r.checks.assumptions.begin(), r.checks.assumptions.end());
  return r;
}

}  // namespace

DynamicOptions dynamic_options(const Model& model) {
  DynamicOptions options;
  const DynamicSettings settings = model.description.dynamics.value_or(DynamicSettings{});
  options.seed = settings.seeds.empty() ? model.description.environment.waves.seed : settings.seeds.front();
  options.duration = settings.duration;
  options.build_up = settings.build_up;
  options.output_step = settings.output_step;
  options.fixed_step = settings.step;
  options.max_step = settings.max_step.value_or(options.max_step);
  options.error_tolerance = settings.step_error;
  options.step.spectral_radius = settings.spectral_radius;
  options.step.tolerance = settings.tolerance;
  options.impacts.steps = settings.impact_steps;
  options.impacts.least_force = settings.impact_force;
  return options;
}

DynamicOutcome run_dynamics(const Model& model, const StaticSolution& start, const StaticResults& statics,
                            const DynamicOptions& options, DynamicSink& sink, const DynamicCheckpoint* from,
                            const std::function<DynamicControl(const DynamicProgress&)>& control) {
  Run run(model, with_laid_tail(model, start, statics.top_tension, options.tail_reach), statics.top_tension, options);
  return run.go(sink, from, statics, control);
}

}  // namespace overbend
