#include "statics/solver/rest_together.h"

#include <algorithm>

#include "statics/solver/lines_statics.h"

namespace overbend {
namespace {

/// Time of the step without inertia, in which friction stretches and slides: so long that no rate makes a force [s].
constexpr double kLongTime = 1e6;
constexpr double kGrowthHeld = 10.0;  ///< Of the residual, that an iteration may bring: cables stiffen as they turn.
constexpr double kGrowthFree = 2.0;   ///< The same where bodies move: the pipe must not leave its rollers behind.
constexpr int kTries = 300;           ///< Iterations of a line by itself.
constexpr int kTogether = 20;         ///< Of all lines at once, before each is tried by itself.
constexpr double kAlmost = 0.05;      ///< Unbalanced force from which Newton's method is tried again in the fallback.

/// Friction of the rollers as in statics, or by the slip.
void set_static_friction(Assembly& assembly, bool of_statics) {
  Continuation continuation;
  continuation.friction_by_slip = !of_statics;
  continuation.roller_friction = assembly.system().rub;
  assembly.set(continuation);
}

class Rest {
 public:
  Rest(Assembly& assembly, SystemState& state, const RestSettings& settings)
      : assembly_(assembly),
        settings_(settings),
        before_(state),
        now_(state),
        equilibrium_(assembly, {LayHistory::monotonic, &before_, kLongTime}),
        dq_(assembly.increments()) {}

  RestReport find(SystemState& result) {
    rest_lines();
    all_together();
    while (!report_.converged && report_.rounds < settings_.max_rounds) {
      ++report_.rounds;
      move_bodies();
      if (report_.residual < kAlmost) {
        all_together();
      }
    }
    if (!report_.converged) {
      report_.residual = residual_of(false);  // the last evaluation may have been of a try that was given up
    }
    report_.worst_place = assembly_.worst_place();
    result = now_;
    at_rest(result);
    return report_;
  }

 private:
  /// Residual of the state; with its tangent where it is asked for.
  double residual_of(bool tangent) {
    equilibrium_.evaluate(now_, tangent);
    equilibrium_.hold(tangent);
    return equilibrium_.relative_residual();
  }

  void newton(int most, double growth) {
    NewtonSettings settings;
    settings.tolerance = settings_.tolerance;
    settings.max_iterations = most - 1;
    settings.search = StepSearch::bounded_residual;
    settings.max_growth = growth;
    settings.body_step = settings_.body_step;
    const NewtonReport report = solve_equilibrium(equilibrium_, now_, settings);
    report_.converged = report.converged();
    report_.residual = report.residual;
    report_.iterations += report.iterations;
  }

  /// Newton's method for all; where it fails all is as it was.
  void all_together() {
    const SystemState from = now_;
    newton(settings_.max_iterations, kGrowthFree);
    if (!report_.converged) {
      now_ = from;
    }
  }

  /// Lines between held ends, each by itself and searched along its steps: points of the bed's friction that now stick
  /// and now slide send a whole Newton step to and fro. What lies on rollers is left as it is.
  void rest_one_by_one() {
    residual_of(false);  // ends in their places
    for (std::size_t i = 0; i < now_.lines.size(); ++i) {
      if (assembly_.line(i).contacts().count() > 0) continue;
      const LineState start = now_.lines[i];
      const NewtonReport rest = rest_line(assembly_, i, before_, kLongTime, now_, {settings_.tolerance, kTries});
      report_.iterations += rest.iterations;
      if (!rest.converged()) now_.lines[i] = start;
    }
  }

  /// Lines on held bodies. Few iterations of all lines at once: on a bed that rubs they may be thrown about, further
  /// with each, until they come to rest by chance somewhere else, and drag the bodies there.
  void rest_lines() {
    const std::vector<std::pair<int, int>> held = hold_all();
    const SystemState from = now_;
    newton(std::min(kTogether, settings_.max_iterations), kGrowthHeld);
    if (!report_.converged) {
      now_ = from;
      rest_one_by_one();
      newton(settings_.max_iterations, kGrowthHeld);
    }
    for (const auto& [body, freedom] : held) {
      assembly_.hold_body(body, freedom, false);
    }
    report_.converged = false;
  }

  /// A round of the fallback: lines on held bodies, then the bodies by half a step.
  void move_bodies() {
    rest_lines();
    report_.residual = residual_of(true);
    if (!equilibrium_.solve(0.0, false, dq_)) return;
    for (std::size_t i = 0; i < now_.lines.size(); ++i) std::fill(dq_[i].begin(), dq_[i].end(), 0.0);
    const SystemState from = now_;
    equilibrium_.advance(now_, from, dq_, 0.5 * equilibrium_.body_limit(dq_, settings_.body_step));
  }

  /// Holds what is free of the bodies; returns what it held.
  std::vector<std::pair<int, int>> hold_all() {
    std::vector<std::pair<int, int>> held;
    for (const int body : free_bodies(assembly_.system())) {
      for (int freedom = 0; freedom < 6; ++freedom) {
        if (!assembly_.body_held(body, freedom)) {
          assembly_.hold_body(body, freedom, true);
          held.emplace_back(body, freedom);
        }
      }
    }
    return held;
  }

  void at_rest(SystemState& state) {
    for (LineState& line : state.lines) {
      std::fill(line.v.begin(), line.v.end(), 0.0);
      line.low.clear();
    }
    for (HullState& body : state.bodies) {
      body.v.setZero();
    }
    for (AttachmentState& end : state.attachments) {
      end.guide.v = end.travel.v = 0.0;
    }
  }

  Assembly& assembly_;
  RestSettings settings_;
  const SystemState before_;
  SystemState now_;
  Equilibrium equilibrium_;
  Increments dq_;
  RestReport report_;
};

}  // namespace

RestReport rest_together(Assembly& assembly, SystemState& state, const RestSettings& settings) {
  set_static_friction(assembly, true);
  const RestReport report = Rest(assembly, state, settings).find(state);
  set_static_friction(assembly, false);
  return report;
}

void mobilise_roller_friction(Assembly& assembly, SystemState& state) {
  if (!assembly.system().rub.any()) return;
  const SystemState before = state;
  set_static_friction(assembly, true);
  assembly.evaluate(state, before, {}, false);
  set_static_friction(assembly, false);
}

}  // namespace overbend
