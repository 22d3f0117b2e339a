#include "analysis/statics.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "analysis/newton.h"
#include "analysis/relaxation.h"
#include "analysis/static_start.h"
#include "analysis/touchdown.h"

namespace overbend {
namespace {

using Target = LineTargetValue;

constexpr int kMeshPasses = 6;          ///< Times the mesh may follow the touchdown found.
constexpr int kRememberingMore = 3;     ///< Times as many iterations where steel remembers: they converge linearly.
constexpr double kLeastYield = 0.0025;  ///< Step by which the plastic moments grow when larger ones fail.

/// One case on one mesh.
struct Case {
  const Model& model;
  LineSystem system;
  LineState state;
  Target target;
  SolveReport report;

  bool spatial() const {
    return !model.current.z.empty() ||
           std::any_of(model.supports.rollers.begin(), model.supports.rollers.end(),
                       [](const Roller& r) { return r.position != RollerPosition::bottom; });
  }
};

/// Roller stiffness that lets a pipe sink by decimetres: weight and curvature load of ten metres of pipe over 0.3 m.
double soft_roller(const Case& at, double tension) {
  return 40.0 * std::max(at.model.sections.front().weight_in_air, tension / 150.0);
}

bool run_newton(Case& at, NewtonSettings settings, const char* stage) {
  settings.remembers = at.system.remembers();
  settings.max_iterations = at.model.description.statics.max_iterations * (settings.remembers ? kRememberingMore : 1);
  const NewtonReport r = newton(at.system, at.state, at.target, settings);
  at.report.iterations += r.iterations;
  at.report.force_residual = r.residual;
  at.report.history.push_back(fmt::format("{}: {} iterations, residual {:.2e}{}", stage, r.iterations, r.residual,
                                          r.converged() ? "" : ", not converged"));
  return r.converged();
}

NewtonSettings loosely() {
  NewtonSettings settings;
  settings.tolerance = 1e-3;
  return settings;
}

NewtonSettings loosely(const Case& at) {
  NewtonSettings settings = loosely();
  settings.entering = 0.25 * at.model.sections.front().outer_diameter;
  return settings;
}

NewtonSettings finally(const Case& at) {
  NewtonSettings settings;
  settings.tolerance = at.model.description.statics.tolerance;
  settings.entering = 0.25 * at.model.sections.front().outer_diameter;
  return settings;
}

/// For one of several steps towards an end.
NewtonSettings nearly(const Case& at) {
  NewtonSettings settings = finally(at);
  settings.tolerance = std::max(settings.tolerance, 1e-6);
  return settings;
}

/// Soft rollers, then harder ones, in the vertical plane: no side rollers, no current.
bool settle_in_plane(Case& at) {
  const double soft = soft_roller(at, at.target.value);
  at.system.use_side_rollers(false);
  at.system.scale_current(0.0);
  at.system.limit_roller_stiffness(soft);
  NewtonSettings settings = loosely();
  settings.free_far_force = false;
  run_newton(at, settings, "soft rollers");
  at.system.limit_roller_stiffness(10.0 * soft);
  return run_newton(at, loosely(), "harder rollers");
}

/// Whether any roller carries the pipe; a line without supports needs none.
bool carried(const Case& at) {
  return !check_supports(at.model, at.system);
}

/// Rollers from soft to hard, first in the vertical plane, then with side rollers and current.
bool harden(Case& at) {
  if (!settle_in_plane(at)) {
    return false;
  }
  at.system.use_side_rollers(true);
  at.system.scale_current(1.0);
  at.system.limit_roller_stiffness(100.0 * soft_roller(at, at.target.value));
  run_newton(at, loosely(at), at.spatial() ? "side rollers and current" : "hard rollers");
  at.system.limit_roller_stiffness(1e300);
  return run_newton(at, finally(at), "full stiffness") && carried(at);
}

/// From a solution close by: all at once.
bool follow(Case& at, const char* stage) {
  at.system.use_side_rollers(true);
  at.system.scale_current(1.0);
  at.system.limit_roller_stiffness(1e300);
  return run_newton(at, finally(at), stage);
}

/// The current rises step by step on hard rollers, so that the pipe finds its side rollers gently.
bool ease_in_current(Case& at) {
  if (at.model.current.z.empty() || !settle_in_plane(at)) {
    return false;
  }
  at.system.use_side_rollers(true);
  at.system.limit_roller_stiffness(1e300);
  double scale = 0.02;
  while (scale < 1.0) {
    at.system.scale_current(scale);
    scale *= 1.5;
    if (!run_newton(at, finally(at), "rising current")) {
      return false;
    }
  }
  return follow(at, "full current") && carried(at);
}

/// From a much larger tension, where the line is nearly straight, down to the wanted one.
bool descend(Case& at) {
  const double wanted = at.target.value;
  const LayShape high = lay_shape(at.model, at.system.plane(), 3.0 * wanted);
  at.state = sample_shape(at.system, high);
  at.target.value = 3.0 * wanted;
  if (!harden(at)) {
    return false;
  }
  double ratio = 0.8;
  while (at.target.value > wanted) {
    const LineState before = at.state;
    const double tension_before = at.target.value;
    at.target.value = std::max(wanted, tension_before * ratio);
    if (!follow(at, "lower tension")) {
      at.state = before;
      at.target.value = tension_before;
      ratio = std::sqrt(ratio);
      if (ratio > 0.99) {
        at.target.value = wanted;
        return false;
      }
    }
  }
  return true;
}

bool relax_and_finish(Case& at) {
  at.system.use_side_rollers(true);
  at.system.scale_current(1.0);
  at.system.limit_roller_stiffness(100.0 * soft_roller(at, at.target.value));
  const RelaxationReport r = relax(at.system, at.state, RelaxationSettings{});
  at.report.relaxation_steps += r.steps;
  at.report.history.push_back(fmt::format("dynamic relaxation: {} steps, residual {:.2e}", r.steps, r.residual));
  if (!std::isfinite(r.residual)) {
    return false;
  }
  run_newton(at, loosely(at), "Newton after relaxation");
  return follow(at, "full stiffness");
}

/// Tries one way after another; names the one that worked.
bool solve_elastic(Case& at, const LayShape& shape) {
  const StaticMethod wanted = at.model.description.statics.method;
  at.state = sample_shape(at.system, shape);
  if (wanted == StaticMethod::newton) {
    at.report.method = "newton";
    if (harden(at)) {
      return true;
    }
    at.report.method = "newton, current raised in steps";
    at.state = sample_shape(at.system, shape);
    if (ease_in_current(at)) {
      return true;
    }
    at.report.method = "newton, tension lowered in steps";
    if (at.target.kind == Target::Kind::top_tension && descend(at)) {
      return true;
    }
    at.state = sample_shape(at.system, shape);
  }
  at.report.method = "dynamic relaxation, then newton";
  return relax_and_finish(at);
}

/// From the elastic shape to that of steel that yields: at once, or the plastic moments in steps.
bool let_yield(Case& at) {
  at.system.let_yield(1.0);
  const LineState elastic = at.state;
  if (!at.system.yielding().any || follow(at, "yielding steel")) {
    return true;
  }
  at.state = elastic;
  double reached = 0.0, step = 0.25;
  while (reached < 1.0 && step > kLeastYield) {
    const LineState before = at.state;
    at.system.let_yield(std::min(1.0, reached + step));
    if (run_newton(at, reached + step < 1.0 ? nearly(at) : finally(at), "yielding in steps")) {
      reached += step;
    } else {
      at.state = before;
      step *= 0.5;
    }
  }
  return reached >= 1.0;
}

bool solve_from_shape(Case& at, const LayShape& shape) {
  at.system.let_yield(0.0);
  return solve_elastic(at, shape) && let_yield(at);
}

/// Zones of the mesh as the solution has them.
MeshZones zones_of(const Case& at, const MeshZones& built) {
  MeshZones zones = built;
  const double total = at.system.mesh().total_length();
  if (const auto touchdown = find_touchdown(at.system, at.state)) {
    zones.touchdown = total - touchdown->s;
  }
  if (const auto waterline = find_waterline(at.system, at.state)) {
    zones.waterline = total - waterline->s;
  }
  zones.last_support = std::max(zones.last_support, support_end(at.system));
  zones.bottom_tension = at.state.far_force;
  return zones;
}

/// Whether the fine zone and the tail still stand where the pipe touches down.
bool mesh_serves(const Case& at, const MeshZones& built, const MeshZones& now) {
  const MeshSizes sizes = mesh_sizes(at.model, built);
  const double moved = now.touchdown - built.touchdown;
  const bool fine_zone = moved < 0.6 * sizes.touchdown_after && -moved < 0.4 * sizes.touchdown_before;
  const bool supports = now.last_support < built.last_support + 2.0 * sizes.overbend;
  const bool tail = at.model.description.pipe.length || now.total - now.touchdown > 1.5 * sizes.touchdown_after;
  return fine_zone && supports && tail;
}

StaticOutcome fail(StaticFailure failure) {
  return {std::nullopt, std::move(failure)};
}

/// Words on the first box, seen from the tensioner, that the pipe lay beside at the last try; empty where it lay on
/// all.
std::string left_at_last(const Case& at) {
  const std::vector<Roller>& rollers = at.model.supports.rollers;
  for (std::size_t i = 0; i < rollers.size(); ++i) {
    const ClosestPoint& closest = at.system.roller_states()[i].at;
    if (lies_beside(rollers[i].position, closest, at.model.section_over(rollers[i]).outer_radius())) {
      return fmt::format(". At the last try the pipe lay beside '{}', {:.2f} m off the end of its roller",
                         at.model.supports.boxes[static_cast<std::size_t>(rollers[i].box)].name, closest.off_end);
    }
  }
  return "";
}

StaticOutcome give_up(const Case& at, double least_tension) {
  const int node = at.system.singular_node();
  const std::string where = node < 0 ? "the whole line"
                                     : fmt::format("node {} at s = {:.1f} m from the anchor", node,
                                                   at.system.mesh().s[static_cast<std::size_t>(node)]);
  return fail({"no equilibrium found", where,
               fmt::format("neither Newton's method, nor raising the current or lowering the tension in steps, nor "
                           "dynamic relaxation settled (last residual {:.1e} of the line's weight). The tension is "
                           "{:.2f} times the weight that hangs from it; near 1 the pipe goes into compression at the "
                           "seabed. Otherwise look for a box far off the curve of its neighbours, or a current too "
                           "strong for so light a pipe{}",
                           at.report.force_residual, at.target.value / least_tension, left_at_last(at))});
}

}  // namespace

StaticOutcome solve_statics(const Model& model, const StaticSolution* start) {
  const auto begin = std::chrono::steady_clock::now();
  const LayPlane plane = lay_plane(model, model.mean_pose);
  StartingPoint from = starting_point(model, plane);
  if (from.failure) {
    return fail(*from.failure);
  }
  Case at{model,
          LineSystem(model, model.mean_pose, start != nullptr ? start->mesh : build_mesh(model, from.zones)),
          {},
          from.target,
          {}};
  bool solved = false;
  if (start != nullptr) {
    from.zones.total = start->mesh.total_length();
    at.state = start->state;
    at.report.method = "newton, from the last solution";
    solved = follow(at, "from the last solution");
    if (!solved) {
      return solve_statics(model, nullptr);
    }
  } else {
    solved = solve_from_shape(at, from.shape);
  }
  for (int pass = 0; solved && pass < kMeshPasses; ++pass) {
    const MeshZones now = zones_of(at, from.zones);
    const bool touches = find_touchdown(at.system, at.state).has_value();
    if (!touches && (model.description.pipe.length || pass == kMeshPasses - 1)) {
      return fail(never_touches(model, at.system.mesh().total_length()));
    }
    if (touches && mesh_serves(at, from.zones, now)) {
      break;
    }
    from.zones = now;
    from.zones.touchdown = touches ? now.touchdown : 1.2 * at.system.mesh().total_length();
    from.zones.total = model.description.pipe.length.value_or(from.zones.touchdown + from.tail);
    LineMesh mesh = build_mesh(model, from.zones);
    LineState moved = interpolate(at.system.mesh(), at.state, mesh, plane);
    at.system = LineSystem(model, model.mean_pose, std::move(mesh));
    at.state = std::move(moved);
    solved = follow(at, "mesh moved to the touchdown found");
  }
  if (!solved) {
    return give_up(at, hanging_weight(model, plane, plane.bed_at_tensioner));
  }
  if (auto failure = check_supports(model, at.system)) {
    return fail(*failure);
  }
  at.report.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return {StaticSolution{at.system.mesh(), at.state, at.report, at.system.bending_memory(at.state)}, std::nullopt};
}

}  // namespace overbend
