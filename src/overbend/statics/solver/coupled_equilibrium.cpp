#include "statics/solver/coupled_equilibrium.h"

#include <algorithm>

#include "statics/solver/lines_statics.h"

namespace overbend {
namespace {

/// Pseudo time step for friction, without inertia: so long that rate forces are negligible [s].
constexpr double kLongTime = 1e6;
constexpr double kGrowthHeld = 10.0;  ///< Maximum growth of the residual per iteration: cables stiffen as they rotate.
constexpr double kGrowthFree = 2.0;   ///< Same with moving bodies: the pipe must stay on its rollers.
constexpr int kLineIterations = 300;  ///< Iterations of a single line.
constexpr int kCoupledIterations = 20;   ///< Iterations of all lines at once before they are solved one by one.
constexpr double kRetryResidual = 0.05;  ///< Residual below which the fallback retries the coupled Newton's method.

/// Sets roller friction as in statics, or by slip.
void set_static_friction(Assembly& assembly, bool of_statics) {
  Continuation continuation;
  continuation.friction_by_slip = !of_statics;
  continuation.roller_friction = assembly.system().rub;
  assembly.set(continuation);
}

class CoupledSolver {
 public:
  CoupledSolver(Assembly& assembly, SystemState& state, const CoupledSolveSettings& settings)
      : assembly_(assembly),
        settings_(settings),
        before_(state),
        now_(state),
        equilibrium_(assembly, {LayHistory::monotonic, &before_, kLongTime}),
        dq_(assembly.increments()) {}

  CoupledSolveReport find(SystemState& result) {
    solve_lines_on_fixed_bodies();
    solve_coupled();
    while (!report_.converged && report_.rounds < settings_.max_rounds) {
      ++report_.rounds;
      move_bodies();
      if (report_.residual < kRetryResidual) {
        solve_coupled();
      }
    }
    if (!report_.converged) {
      report_.residual = evaluate_residual(false);  // the last evaluation may belong to a rejected trial
    }
    report_.worst_place = assembly_.worst_place();
    result = now_;
    at_rest(result);
    return report_;
  }

 private:
  /// Residual of the state; `tangent`: evaluates the tangent as well.
  double evaluate_residual(bool tangent) {
    equilibrium_.evaluate(now_, tangent);
    equilibrium_.hold(tangent);
    return equilibrium_.relative_residual();
  }

  void newton(int max_iterations, double growth) {
    NewtonSettings settings;
    settings.tolerance = settings_.tolerance;
    settings.max_iterations = max_iterations - 1;
    settings.search = StepSearch::bounded_residual;
    settings.max_growth = growth;
    settings.body_step = settings_.body_step;
    const NewtonReport report = solve_equilibrium(equilibrium_, now_, settings);
    report_.converged = report.converged();
    report_.residual = report.residual;
    report_.iterations += report.iterations;
  }

  /// Newton's method for all unknowns; on failure the state is unchanged.
  void solve_coupled() {
    const SystemState from = now_;
    newton(settings_.max_iterations, kGrowthFree);
    if (!report_.converged) {
      now_ = from;
    }
  }

  /// Solves lines between held ends one by one, with a line search: points of bed friction that alternate between
  /// sticking and sliding make full Newton steps oscillate. Lines on rollers are unchanged.
  void solve_lines_individually() {
    evaluate_residual(false);  // moves the ends to their places
    for (std::size_t i = 0; i < now_.lines.size(); ++i) {
      if (assembly_.line(i).contacts().count() > 0) continue;
      const LineState start = now_.lines[i];
      const NewtonReport rest =
          solve_line_equilibrium(assembly_, i, before_, kLongTime, now_, {settings_.tolerance, kLineIterations});
      report_.iterations += rest.iterations;
      if (!rest.converged()) now_.lines[i] = start;
    }
  }

  /// Solves the lines with fixed bodies. Few iterations of all lines at once: with bed friction they may diverge until
  /// they converge by chance to a distant equilibrium, and drag the bodies there.
  void solve_lines_on_fixed_bodies() {
    const std::vector<std::pair<int, int>> held = hold_all();
    const SystemState from = now_;
    newton(std::min(kCoupledIterations, settings_.max_iterations), kGrowthHeld);
    if (!report_.converged) {
      now_ = from;
      solve_lines_individually();
      newton(settings_.max_iterations, kGrowthHeld);
    }
    for (const auto& [body, freedom] : held) {
      assembly_.hold_body(body, freedom, false);
    }
    report_.converged = false;
  }

  /// One round of the fallback: lines with fixed bodies, then bodies by half a step.
  void move_bodies() {
    solve_lines_on_fixed_bodies();
    report_.residual = evaluate_residual(true);
    if (!equilibrium_.solve(0.0, false, dq_)) return;
    for (std::size_t i = 0; i < now_.lines.size(); ++i) std::fill(dq_[i].begin(), dq_[i].end(), 0.0);
    const SystemState from = now_;
    equilibrium_.advance(now_, from, dq_, 0.5 * equilibrium_.body_limit(dq_, settings_.body_step));
  }

  /// Holds the free freedoms of the bodies and returns them.
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
  CoupledSolveSettings settings_;
  const SystemState before_;
  SystemState now_;
  Equilibrium equilibrium_;
  Increments dq_;
  CoupledSolveReport report_;
};

}  // namespace

CoupledSolveReport solve_coupled_equilibrium(Assembly& assembly, SystemState& state,
                                             const CoupledSolveSettings& settings) {
  set_static_friction(assembly, true);
  const CoupledSolveReport report = CoupledSolver(assembly, state, settings).find(state);
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
