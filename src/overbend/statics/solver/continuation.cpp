#include "statics/solver/continuation.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "mechanics/plastic_bending.h"
#include "model/lay_stage.h"
#include "statics/initial_shape/stage_shape.h"
#include "statics/solver/newton.h"
#include "statics/solver/relaxation.h"
#include "statics/solver/starting_point.h"

namespace overbend {
namespace {

constexpr int kHistoryIterationFactor = 3;  ///< Factor on the iterations for steel with memory: they converge linearly.
constexpr double kMaxWork = 2.3e6;          ///< Maximum effort per problem, in Newton steps times elements: about 3 s.
constexpr double kRollerCost = 0.25;        ///< Time of a roller relative to that of an element,
constexpr double kRollerSearchCost = 1e-3;  ///< and of its search along an element: measured.
constexpr double kMinNewtonBudget = 150.0;  ///< Minimum Newton budget per problem, independent of mesh size.
constexpr double kResidualEvaluationCost = 0.2;  ///< Cost of a residual evaluation relative to a Newton step.
constexpr double kRelaxationShare = 0.75;  ///< Share of the remaining effort for dynamic relaxation; the rest is for
                                           ///< the final Newton steps.
constexpr double kHigherTension = 3.0;     ///< Factor on the target tension at which the line is nearly straight.

/// Roller stiffness at which a pipe sinks by decimetres: weight and curvature load of ten metres of pipe over 0.3 m
/// [N/m].
double soft_roller(const EquilibriumProblem& problem, double tension) {
  return 40.0 * std::max(problem.model.pipe_section().weight_in_air, tension / 150.0);
}

/// Stiffness of a bed in which the pipe sinks by half its diameter [N/m2].
double soft_bed(const EquilibriumProblem& problem) {
  const Section& pipe = problem.model.pipe_section();
  return pipe.weight_submerged / (0.5 * pipe.outer_diameter);
}

/// Changes parameters of the continuation; the others are kept.
template <class Change>
void change_continuation(EquilibriumProblem& problem, const Change& change) {
  Continuation continuation = problem.system.continuation();
  change(continuation);
  problem.system.set(continuation);
}

/// Solves one load step with the given continuation parameters.
bool run_newton(EquilibriumProblem& problem, const Continuation& continuation, NewtonSettings settings,
                const char* stage) {
  problem.system.set(continuation);
  if (problem.is_exhausted()) return false;
  settings.has_plastic_memory = problem.system.has_plastic_memory();
  settings.max_iterations =
      problem.model.description.statics.max_iterations * (settings.has_plastic_memory ? kHistoryIterationFactor : 1);
  const NewtonReport r = solve_equilibrium(problem.system, problem.state, settings);
  problem.work += problem.size() * (r.iterations + kResidualEvaluationCost * r.trials);
  problem.report.iterations += r.iterations;
  problem.report.force_residual = r.residual;
  problem.report.history.push_back(fmt::format("{}: {} iterations, residual {:.2e}{}", stage, r.iterations, r.residual,
                                               r.converged() ? "" : ", not converged"));
  if (r.end == NewtonEnd::slack && settings.tolerance <= problem.model.description.statics.tolerance) {
    problem.tension_at_compression = problem.target.value + problem.system.target_error(problem.state, problem.target);
  }
  return r.converged();
}

NewtonSettings to_tolerance(const EquilibriumProblem& problem, double tolerance) {
  NewtonSettings settings;
  settings.tolerance = tolerance;
  settings.target = problem.target;
  return settings;
}

NewtonSettings coarse_newton_settings(const EquilibriumProblem& problem) {
  return to_tolerance(problem, 1e-3);
}

/// Limits the increase of roller penetration per step.
NewtonSettings limit_roller_penetration(NewtonSettings settings, const EquilibriumProblem& problem) {
  settings.max_entering = 0.25 * problem.model.pipe_section().outer_diameter;
  return settings;
}

/// Stiffness of the stiffest roller [N/m].
double find_max_roller_stiffness(const EquilibriumProblem& problem) {
  double hardest = 0.0;
  for (int i = 0; i < problem.system.rollers().count(); ++i) {
    hardest = std::max(hardest, problem.system.rollers().roller(i).law.stiffness);
  }
  return hardest;
}

/// Effect of the last digit of a position on a roller force, over the weight. Relevant for a light line, mostly cable,
/// on nearly rigid rollers.
double rounding(const EquilibriumProblem& problem) {
  constexpr double kLastDigit = 2e-14;  // for positions of 100 m [m]
  return has_cable(problem.model.description)
             ? kLastDigit * find_max_roller_stiffness(problem) / problem.system.total_weight()
             : 0.0;
}

NewtonSettings final_newton_settings(const EquilibriumProblem& problem) {
  return limit_roller_penetration(
      to_tolerance(problem, std::max(problem.model.description.statics.tolerance, rounding(problem))), problem);
}

/// Settings of an intermediate load step.
NewtonSettings load_step_newton_settings(const EquilibriumProblem& problem) {
  NewtonSettings settings = final_newton_settings(problem);
  settings.tolerance = std::max(settings.tolerance, 1e-6);
  return settings;
}

/// Step control of a continuation from 0 to 1.
struct Steps {
  double first = 0.25, growth = 1.5, min_step = 1e-3;
};

/// Follows the solutions from `reached` = 0, which is solved, to 1; `set_parameters` sets the parameters at a value. A
/// failed step is reverted and halved, a successful one lets the next grow.
bool continue_in_steps(EquilibriumProblem& problem, const char* stage, const Steps& steps,
                       const std::function<void(double reached, Continuation&)>& set_parameters) {
  Continuation continuation = problem.system.continuation();
  double reached = 0.0, step = steps.first;
  while (reached < 1.0 && step > steps.min_step && !problem.is_exhausted()) {
    const LineState before = problem.state;
    const double next = std::min(1.0, reached + step);
    set_parameters(next, continuation);
    if (run_newton(problem, continuation,
                   next < 1.0 ? load_step_newton_settings(problem) : final_newton_settings(problem), stage)) {
      reached = next;
      step *= steps.growth;
    } else {
      problem.state = before;
      step *= 0.5;
    }
  }
  return reached >= 1.0;
}

/// True if bottom rollers are inclined across the pipe, so that it slides off them unless side rollers hold it.
bool rollers_lean(const EquilibriumProblem& problem) {
  constexpr double kLevel = 1e-6;
  return std::abs(problem.model.mean_pose.R_WV.col(1).z()) > kLevel;
}

/// Soft rollers, then harder ones, in the vertical plane: without current, and with side rollers only if the vessel
/// heels.
bool solve_in_plane(EquilibriumProblem& problem) {
  Continuation in_plane = problem.system.continuation();
  in_plane.side_rollers = rollers_lean(problem);
  in_plane.current = 0.0;
  in_plane.max_roller_stiffness = soft_roller(problem, problem.target.value);
  NewtonSettings at_given_force = coarse_newton_settings(problem);
  at_given_force.target.reset();
  run_newton(problem, in_plane, at_given_force, "soft rollers");
  in_plane.max_roller_stiffness *= 10.0;
  return run_newton(problem, in_plane, coarse_newton_settings(problem), "harder rollers");
}

/// True if a roller carries the pipe or the line has no supports.
bool rests_on_a_roller(const EquilibriumProblem& problem) {
  return !check_supports(problem.model, problem.system);
}

bool is_spatial(const EquilibriumProblem& problem) {
  return !problem.model.current.z.empty() ||
         std::any_of(problem.model.supports.rollers.begin(), problem.model.supports.rollers.end(),
                     [](const Roller& r) { return r.position != RollerPosition::bottom; });
}

constexpr double kNoLimit = 1e300;

/// Side rollers and current as in the model; roller stiffness limited.
Continuation spatial_continuation(const EquilibriumProblem& problem, double max_roller_stiffness = kNoLimit) {
  Continuation continuation = problem.system.continuation();
  continuation.side_rollers = true;
  continuation.current = 1.0;
  continuation.max_roller_stiffness = max_roller_stiffness;
  return continuation;
}

/// The same, with the bed of the model or of limited stiffness.
Continuation full_continuation(const EquilibriumProblem& problem, double max_roller_stiffness = kNoLimit,
                               double max_bed_stiffness = kNoLimit) {
  Continuation continuation = spatial_continuation(problem, max_roller_stiffness);
  continuation.max_bed_stiffness = max_bed_stiffness;
  return continuation;
}

/// Continuation in roller stiffness, first in the vertical plane, then with side rollers and current.
bool continue_in_roller_stiffness(EquilibriumProblem& problem) {
  if (!solve_in_plane(problem)) {
    return false;
  }
  run_newton(problem, spatial_continuation(problem, 100.0 * soft_roller(problem, problem.target.value)),
             limit_roller_penetration(coarse_newton_settings(problem), problem),
             is_spatial(problem) ? "side rollers and current" : "hard rollers");
  return run_newton(problem, spatial_continuation(problem), final_newton_settings(problem), "full stiffness") &&
         rests_on_a_roller(problem);
}

/// True if a cable, which has no bending stiffness, runs over rollers: sharp turns need continuation in small steps.
bool cable_on_rollers(const Model& model) {
  if (!has_cable(model.description) || model.supports.rollers.empty()) return false;
  return !is_dragged(model.description) || pipe_end_distance(model.description) < model.supports.rows.back().from_top;
}

/// Raises the current in steps on hard rollers, so that the pipe meets its side rollers gently. A failed step is
/// halved; otherwise the softer methods would follow, in which a pipe may slip off rollers that can hold it.
bool continue_in_current(EquilibriumProblem& problem) {
  if (problem.model.current.z.empty() || cable_on_rollers(problem.model) || !solve_in_plane(problem)) {
    return false;
  }
  constexpr double kFirst = 0.02, kGrowth = 1.5;
  Continuation first = spatial_continuation(problem);
  first.current = kFirst;
  if (!run_newton(problem, first, final_newton_settings(problem), "rising current")) {
    return false;
  }
  const Steps steps{.first = std::log(kGrowth) / -std::log(kFirst), .growth = 1.0, .min_step = 2e-3};
  const auto raise = [](double reached, Continuation& c) { c.current = std::pow(kFirst, 1.0 - reached); };
  return continue_in_steps(problem, "rising current", steps, raise) && solve_from_warm_start(problem, "full current") &&
         rests_on_a_roller(problem);
}

/// Raises the stiffness of rollers and bed from ten times a soft roller and a soft bed, at which the state is solved,
/// to full.
bool continue_in_contact_stiffness(EquilibriumProblem& problem) {
  const double soft = 10.0 * soft_roller(problem, problem.target.value), bed = soft_bed(problem);
  const double rollers = std::max(find_max_roller_stiffness(problem) / soft, 1.0),
               beds = std::max(problem.model.seabed.stiffness / bed, 1.0);
  return continue_in_steps(problem, "hardening in steps", Steps{}, [&](double reached, Continuation& continuation) {
    continuation.max_roller_stiffness = reached < 1.0 ? soft * std::pow(rollers, reached) : kNoLimit;
    continuation.max_bed_stiffness = reached < 1.0 ? bed * std::pow(beds, reached) : kNoLimit;
  });
}

/// Raises the current in steps on soft rollers and a soft bed, then raises both stiffnesses in steps.
bool continue_in_contact_and_current(EquilibriumProblem& problem) {
  change_continuation(problem, [&](Continuation& c) { c.max_bed_stiffness = soft_bed(problem); });
  if (!solve_in_plane(problem)) {
    return false;
  }
  const auto raise = [](double reached, Continuation& continuation) {
    continuation.side_rollers = true;
    continuation.current = reached;
  };
  return continue_in_steps(problem, "rising current on soft rollers", Steps{}, raise) &&
         continue_in_contact_stiffness(problem) && rests_on_a_roller(problem);
}

/// Raises the bed from a level one at the landing height of the initial shape to its own shape.
bool continue_in_bed_relief(EquilibriumProblem& problem) {
  LayPlane level = problem.system.plane();
  const LayShape landing = lay_shape(problem.model, level, problem.target.value);
  if (!landing.problem.empty() || has_cable(problem.model.description)) return false;
  const auto touchdown = ranges::lower_bound(landing.length, landing.touchdown);
  const double height = landing.z[static_cast<std::size_t>(touchdown - landing.length.begin())] - level.radius;
  level.surface = SeabedSurface(height * Vec3::UnitZ(), Vec3::UnitZ());
  problem.state = sample_shape(problem.system, lay_shape(problem.model, level, problem.target.value));
  change_continuation(problem, [&](Continuation& c) {
    c.bed_relief = 0.0;
    c.bed_level = height;
  });
  const auto raise = [](double reached, Continuation& c) { c.bed_relief = reached; };
  const bool risen =
      continue_in_roller_stiffness(problem) && continue_in_steps(problem, "bed raised to its shape", Steps{}, raise);
  change_continuation(problem, [](Continuation& c) {
    c.bed_relief = 1.0;
    c.bed_level = 0.0;
  });
  return risen && rests_on_a_roller(problem);
}

/// Continuation in tension: from a much larger tension, at which the line is nearly straight, down to the target.
bool continue_in_tension(EquilibriumProblem& problem) {
  const double wanted = problem.target.value;
  const double higher = kHigherTension * wanted;
  const LayShape high = has_cable(problem.model.description)
                            ? stage_shape(problem.model, problem.system.plane(), higher)
                            : lay_shape(problem.model, problem.system.plane(), higher);
  problem.state = sample_shape(problem.system, high);
  problem.target.value = higher;
  bool solved = cable_on_rollers(problem.model) ? continue_in_contact_and_current(problem)
                                                : continue_in_roller_stiffness(problem);
  double ratio = 0.8;
  while (solved && problem.target.value > wanted) {
    const LineState before = problem.state;
    const double tension_before = problem.target.value;
    problem.target.value = std::max(wanted, tension_before * ratio);
    if (!solve_from_warm_start(problem, "lower tension")) {
      problem.state = before;
      problem.target.value = tension_before;
      ratio = std::sqrt(ratio);
      solved = ratio <= 0.99;
    }
  }
  problem.target.value = wanted;  // restore the target also on failure
  return solved;
}

bool relax_then_newton(EquilibriumProblem& problem) {
  const Continuation hard = full_continuation(problem, 100.0 * soft_roller(problem, problem.target.value));
  problem.system.set(hard);
  RelaxationSettings settings;
  // if relaxation is requested, it gets its full number of steps
  if (problem.model.description.statics.method == StaticMethod::newton) {
    const double step = kResidualEvaluationCost * problem.size();
    const double steps = kRelaxationShare * (problem.max_work() - problem.work) / step;
    settings.max_steps = static_cast<int>(std::clamp(steps, 0.0, 1.0 * settings.max_steps));
    problem.work += step * settings.max_steps;
  }
  const RelaxationReport r = relax(problem.system, problem.state, settings);
  problem.report.relaxation_steps += r.steps;
  problem.report.history.push_back(fmt::format("dynamic relaxation: {} steps, residual {:.2e}{}", r.steps, r.residual,
                                               r.diverged ? ", diverged" : ""));
  if (r.diverged || !std::isfinite(r.residual)) {
    return false;
  }
  run_newton(problem, hard, limit_roller_penetration(coarse_newton_settings(problem), problem),
             "Newton after relaxation");
  return solve_from_warm_start(problem, "full stiffness");
}

void note_missed_box(EquilibriumProblem& problem) {
  if (const std::optional<std::string> box = box_above_pipe(problem.model, problem.system, problem.state)) {
    problem.missed_box_message =
        fmt::format(". In a failed attempt the pipe lay below the rollers of '{}', through which it cannot pass", *box);
  } else if (const std::optional<MissedBox> missed = find_missed_box(problem.model, problem.system)) {
    problem.missed_box_message =
        fmt::format(". In a failed attempt the pipe missed '{}', {}", missed->name, off_end_message(*missed));
  }
}

/// A solution with the pipe off some of its boxes is one of several: a pipe on its boxes in still water stays there as
/// the current rises, if its rollers can hold it. That solution is preferred, if it exists.
void prefer_equilibrium_on_rollers(EquilibriumProblem& problem, const LayShape& shape) {
  if (problem.model.current.z.empty() || cable_on_rollers(problem.model) ||
      count_missed_boxes(problem.model, problem.system) == 0) {
    return;
  }
  const LineState off_rollers = problem.state;
  const double residual = problem.report.force_residual, min_step = problem.tension_at_compression;
  problem.state = sample_shape(problem.system, shape);
  if (continue_in_current(problem) && count_missed_boxes(problem.model, problem.system) == 0) {
    problem.report.method = "newton, current raised in steps";
    return;
  }
  problem.state = off_rollers;
  problem.report.force_residual = residual;
  problem.tension_at_compression = min_step;
  problem.system.set(full_continuation(problem));
  problem.system.evaluate(problem.state, true);
}

/// Last-resort equilibrium: converged, but the pipe misses most roller boxes.
struct FallbackEquilibrium {
  std::optional<LineState> state;
  std::string method;
  double residual = 0.0;

  /// Stores the present solution, if it is one and the first. Returns true if it is one.
  bool offer(const EquilibriumProblem& problem) {
    const auto boxes = static_cast<int>(problem.model.supports.boxes.size());
    if (2 * count_missed_boxes(problem.model, problem.system) <= boxes) return false;
    if (!state) {
      state = problem.state;
      method = problem.report.method;
      residual = problem.report.force_residual;
    }
    return true;
  }
  bool restore(EquilibriumProblem& problem) const {
    if (!state) return false;
    problem.state = *state;
    problem.report.method = method + ", last resort";
    problem.report.force_residual = residual;
    problem.system.set(full_continuation(problem));
    problem.system.evaluate(problem.state, true);
    return true;
  }
};

/// Tries one method after another from the initial shape, with linear steel.
bool try_methods(EquilibriumProblem& problem, const LayShape& shape, FallbackEquilibrium& fallback) {
  const auto works = [&](bool found) {
    if (found && !box_above_pipe(problem.model, problem.system, problem.state)) return !fallback.offer(problem);
    note_missed_box(problem);
    return false;
  };
  const StaticMethod wanted = problem.model.description.statics.method;
  problem.state = sample_shape(problem.system, shape);
  if (wanted == StaticMethod::newton) {
    problem.report.method = "newton";
    if (!cable_on_rollers(problem.model) && works(continue_in_roller_stiffness(problem))) {
      prefer_equilibrium_on_rollers(problem, shape);
      return true;
    }
    if (problem.model.seabed.surface.shape() != nullptr &&
        problem.target.kind == EquilibriumTarget::Kind::top_tension) {
      problem.report.method = "newton, bed raised to its shape";
      if (works(continue_in_bed_relief(problem))) {
        prefer_equilibrium_on_rollers(problem, shape);
        return true;
      }
    }
    problem.report.method = "newton, current raised in steps";
    problem.state = sample_shape(problem.system, shape);
    if (works(continue_in_current(problem))) {
      return true;
    }
    problem.report.method = "newton, hardened in steps";
    problem.state = sample_shape(problem.system, shape);
    problem.tension_at_compression = 0.0;
    if (works(continue_in_contact_and_current(problem))) {
      return true;
    }
    if (problem.tension_at_compression > 0.0) {
      return false;  // slack line even with the softest method: no other can do better
    }
    change_continuation(problem, [](Continuation& c) { c.max_bed_stiffness = kNoLimit; });
    problem.report.method = "newton, tension lowered in steps";
    if (problem.target.kind == EquilibriumTarget::Kind::top_tension && works(continue_in_tension(problem))) {
      return true;
    }
    problem.state = sample_shape(problem.system, shape);
  }
  problem.report.method = "dynamic relaxation, then newton";
  return works(relax_then_newton(problem));
}

}  // namespace

double EquilibriumProblem::size() const {
  const double elements = system.mesh().elements(), rollers = static_cast<double>(system.contacts().size());
  return elements + rollers * (kRollerCost + kRollerSearchCost * elements);
}

double EquilibriumProblem::max_work() const {
  return std::max(kMaxWork, kMinNewtonBudget * size());
}

bool solve_from_warm_start(EquilibriumProblem& problem, const char* stage) {
  return run_newton(problem, full_continuation(problem), final_newton_settings(problem), stage);
}

bool solve_with_penalty_continuation(EquilibriumProblem& problem) {
  const Continuation soft =
      full_continuation(problem, 10.0 * soft_roller(problem, problem.target.value), soft_bed(problem));
  return run_newton(problem, soft, load_step_newton_settings(problem), "softened") &&
         continue_in_contact_stiffness(problem);
}

namespace {

bool solve_by_continuation(EquilibriumProblem& problem, const LayShape& shape) {
  FallbackEquilibrium fallback;
  return try_methods(problem, shape, fallback) || fallback.restore(problem);
}

/// Solves the bare pipe first, then raises the forces of structures fixed to it, from very small ones: a wire may be
/// much too short at the position of the bare pipe.
bool attach_in_steps(EquilibriumProblem& problem, const LayShape& shape) {
  constexpr double kFirst = 1e-6;
  change_continuation(problem, [](Continuation& c) { c.attached = 0.0; });
  const bool solved =
      solve_by_continuation(problem, shape) &&
      continue_in_steps(problem, "clumps, buoys and wires in steps", Steps{},
                        [](double reached, Continuation& c) { c.attached = std::pow(kFirst, 1.0 - reached); });
  change_continuation(problem, [](Continuation& c) { c.attached = 1.0; });
  return solved && rests_on_a_roller(problem);
}

}  // namespace

bool solve_elastic(EquilibriumProblem& problem, const LayShape& shape) {
  const bool attached = !problem.system.line().points.empty() || !problem.system.line().wires.empty();
  if (attached && attach_in_steps(problem, shape)) return true;
  problem.tension_at_compression = 0.0;
  return solve_by_continuation(problem, shape);
}

namespace {

/// Name of the box whose roller is nearest to an element, if within a box length; otherwise empty.
std::string box_at(const EquilibriumProblem& problem, int element) {
  const std::vector<RollerContact>& contacts = problem.system.contacts();
  int nearest = -1, distance = 4;  // elements
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const int off = std::abs(contacts[i].closest.element - element);
    if (contacts[i].normal <= 0.0 || off >= distance) continue;
    distance = off;
    nearest = problem.model.supports.rollers[i].box;
  }
  return nearest < 0 ? "" : problem.model.supports.boxes[static_cast<std::size_t>(nearest)].name;
}

/// Describes where the equilibrium of linear steel exceeds the curvature of first yield most.
std::string max_bending_message(EquilibriumProblem& problem) {
  make_elastic(problem);
  problem.system.evaluate(problem.state, false);
  const LineMesh& mesh = problem.system.mesh();
  double ratio = 0.0;
  int worst = 0;
  for (int e = 0; e < mesh.elements(); ++e) {
    const auto i = static_cast<std::size_t>(e);
    const Section& section = problem.model.sections[static_cast<std::size_t>(mesh.section[i])];
    if (!section.bending) continue;
    const ElementVector q(Eigen::Map<const ElementVector>(problem.state.q.data() + 6 * i));
    const double first = 2.0 * section.yield_stress / (section.youngs_modulus * section.steel_diameter);
    for (const double xi : {0.0, 1.0}) {
      const double ratio_at_point = curvature_vector(centreline(q, xi, mesh.length[i])).norm() / first;
      if (ratio_at_point > ratio) {
        ratio = ratio_at_point;
        worst = e;
      }
    }
  }
  const std::string box = box_at(problem, worst);
  return fmt::format(
      "{} from the tensioner{} pipe of linear steel would bend to {:.1f} times the curvature of first yield",
      shown(mesh.total_length() - mesh.s[static_cast<std::size_t>(worst)], "m", 1),
      box.empty() ? "" : ", at box '" + box + "',", ratio);
}

}  // namespace

void make_elastic(EquilibriumProblem& problem) {
  change_continuation(problem, [](Continuation& c) { c.yielding = 0.0; });
}

bool activate_plasticity(EquilibriumProblem& problem) {
  change_continuation(problem, [](Continuation& c) { c.yielding = 1.0; });
  const LineState elastic = problem.state;
  if (!problem.system.line().yielding.any || solve_from_warm_start(problem, "yielding steel")) {
    return true;
  }
  problem.state = elastic;
  const bool solved =
      continue_in_steps(problem, "yielding in steps", Steps{.first = 0.25, .growth = 1.0, .min_step = 0.0025},
                        [](double reached, Continuation& c) { c.yielding = reached; });
  if (!solved) {
    problem.state = elastic;
    problem.yield_message = max_bending_message(problem);
  }
  return solved;
}

}  // namespace overbend
