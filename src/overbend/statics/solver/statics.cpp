#include "statics/solver/statics.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "model/lay_stage.h"
#include "model/pipe_attachments.h"
#include "statics/equations/bed_contacts.h"
#include "statics/equations/touchdown.h"
#include "statics/solver/anchored_lay.h"
#include "statics/solver/continuation.h"
#include "statics/solver/dragged_line.h"
#include "statics/solver/starting_point.h"
#include "statics/solver/steady_laying.h"
#include "statics/solver/support_outlier.h"
#include "statics/solver/unsupported_statics.h"
#include "statics/solver/warm_start.h"

namespace overbend {
namespace {

constexpr int kMeshPasses = 6;     ///< Number of times the mesh may follow the touchdown point.
constexpr double kMaxMiss = 0.01;  ///< Relative to the target; ordinary lays are within 2e-4.

/// True if a line of given length has the length of the mesh.
bool length_fits(const Model& model, const LineMesh& mesh) {
  const std::optional<double>& length = model.description.pipe.length;
  return !length || std::abs(mesh.total_length() - *length) <= 1e-9 * *length;
}

/// True if a solution's mesh can be kept: it has the length of the line, the requested element lengths, and nodes at
/// the ends of the model's sections.
bool mesh_fits(const Model& model, const StaticSolution& start) {
  const LineMesh& mesh = start.mesh;
  if (!length_fits(model, mesh) || !(model.description.mesh == start.mesh_asked)) return false;
  for (std::size_t e = 0; e < mesh.section.size(); ++e) {
    const double middle = mesh.total_length() - 0.5 * (mesh.s[e] + mesh.s[e + 1]);
    if (mesh.section[e] != model.section_at(middle)) return false;
  }
  const auto node_there = [&](double from_top) {
    const double s = mesh.total_length() - from_top;
    const auto node = std::lower_bound(mesh.s.begin(), mesh.s.end(), s - 1e-6);
    return s < 0.5 || std::abs(*node - s) < 1e-6;
  };
  return ranges::all_of(model.spans, [&](const SectionSpan& span) { return node_there(span.to); }) &&
         ranges::all_of(pipe_attachments(model.description),
                        [&](const PipeAttachment& attached) { return node_there(attached.from_top); });
}

bool solve_from_shape(EquilibriumProblem& problem, const LayShape& shape) {
  make_elastic(problem);
  return solve_elastic(problem, shape) && activate_plasticity(problem);
}

/// Solves on another mesh than that of the state.
bool solve_on_new_mesh(EquilibriumProblem& problem, const LayShape& shape) {
  const LineState moved = problem.state;
  if (solve_from_warm_start(problem, "mesh moved to the touchdown found")) {
    return true;
  }
  problem.state = moved;
  make_elastic(problem);
  problem.tension_at_compression = 0.0;
  const bool solved = solve_with_penalty_continuation(problem) && activate_plasticity(problem);
  return solved || (problem.tension_at_compression == 0.0 && solve_from_shape(problem, shape));
}

/// Zones of the mesh according to the solution.
MeshZones solved_zones(const EquilibriumProblem& problem, const MeshZones& built,
                       const std::optional<ElementPlace>& touchdown) {
  MeshZones zones = built;
  const double total = problem.system.mesh().total_length();
  if (touchdown) {
    zones.touchdown = total - touchdown->s;
  }
  if (const auto waterline = find_waterline(problem.system, problem.state)) {
    zones.waterline = total - waterline->s;
  }
  zones.last_support = std::max(zones.last_support, support_end(problem.system));
  const bool dragged = is_dragged(problem.model.description);
  if (!dragged) zones.bottom_tension = problem.state.far_force;
  if (dragged || may_span(problem.model)) {
    zones.bed_edges = contact_edges(problem.system, bed_contacts(problem.system, problem.state));
  }
  return zones;
}

/// Solves from a neighbouring solution: on its mesh, or on one with other section limits.
bool solve_from(EquilibriumProblem& problem, const StaticSolution& start, const LayPlane& plane) {
  const bool same_line = problem.system.mesh().s == start.mesh.s;
  problem.state = same_line ? start.state : interpolate(start.mesh, start.state, problem.system.mesh(), plane);
  move_to_ends(problem.system, start.pose, start.zones ? start.zones->last_support : 0.0, problem.state);
  const LineState brought = problem.state;
  if (solve_from_warm_start(problem, "from the last solution")) return true;
  if (same_line) return false;
  problem.state = brought;
  return solve_with_penalty_continuation(problem) && activate_plasticity(problem);
}

/// True if every edge of contact on a shaped bed is well inside the short elements made for one.
bool edges_fit_mesh(const EquilibriumProblem& problem, const MeshZones& built, const MeshZones& current) {
  const double reach = 0.5 * soil_length(problem.model, problem.model.pipe_section().EI);
  return ranges::all_of(current.bed_edges, [&](const LineStretch& edge) {
    return ranges::any_of(built.bed_edges, [&](const LineStretch& zone) {
      return edge.from > zone.from - reach && edge.to < zone.to + reach;
    });
  });
}

/// True if the fine zone and the laid part still fit the touchdown point.
bool mesh_fits_solution(const EquilibriumProblem& problem, const MeshZones& built, const MeshZones& current) {
  const MeshSizes sizes = mesh_sizes(problem.model, built);
  const double moved = current.touchdown - built.touchdown;
  const bool fine_zone = moved < 0.6 * sizes.touchdown_after && -moved < 0.4 * sizes.touchdown_before;
  const bool supports = current.last_support < built.last_support + 2.0 * sizes.overbend;
  const bool tail = problem.model.description.pipe.length || is_dragged(problem.model.description) ||
                    current.total - current.touchdown > 1.5 * sizes.touchdown_after;
  return fine_zone && supports && tail && edges_fit_mesh(problem, built, current);
}

/// Finds the line on which the pipe is laid, at the offset `aside` on a curved route. Returns false, with the state
/// unchanged, if there is none.
bool find_laid_line(EquilibriumProblem& problem, double aside) {
  const LineState before = problem.state;
  const bool bends = problem.system.lays_steadily() && !problem.system.plane().route.straight();
  if (bends ? move_line(problem, aside) : solve_steady_laying(problem)) return true;
  problem.state = before;
  problem.report.history.emplace_back("steady laying: no laid line found");
  return false;
}

StaticOutcome fail(StaticFailure failure) {
  return {std::nullopt, std::move(failure)};
}

/// A short line on the pipe may carry the load instead of the tensioner, independently of its setting.
StaticFailure with_lines(const Model& model, StaticFailure failure) {
  if (model.description.lines.empty()) return failure;
  failure.why +=
      ". A line on the pipe that is too short carries the pipe instead of the tensioner, whose tension then cannot be "
      "set: check the lengths and positions of the lines";
  return failure;
}

/// `suspended_weight`: weight of the plain pipe between tensioner and seabed [N], without structures built into it; a
/// short buoyant piece would make it negative.
StaticOutcome make_failure(const EquilibriumProblem& problem, double suspended_weight) {
  const int node = problem.system.singular_node();
  const std::string where = node < 0
                                ? "the whole line"
                                : fmt::format("node {} at s = {} from the anchor", node,
                                              shown(problem.system.mesh().s[static_cast<std::size_t>(node)], "m", 1));
  if (problem.tension_at_compression > 0.0) {
    return fail(
        with_lines(problem.system.model(), compressed_at_seabed(problem.target.value, problem.tension_at_compression)));
  }
  if (!problem.yield_message.empty()) {
    return fail(
        {"no equilibrium found: the pipe yields", "overbend",
         fmt::format("with linear steel an equilibrium exists, with pipe.steel.material none was found: {}; the "
                     "yielding pipe folds there. A larger radius, a longer stinger or another tension bends it less",
                     problem.yield_message)});
  }
  const std::string what = problem.missed_box_message.empty() ? "no equilibrium found"
                                                              : "no equilibrium found: the pipe runs off its rollers";
  const std::optional<SupportOutlier> outlier = support_outlier(problem.system.model());
  return fail(with_lines(
      problem.system.model(),
      {what, where,
       (outlier ? outlier_message(*outlier) + ". N" : "n") +
           fmt::format("either Newton's method, nor hardening the rollers, raising the current or lowering the tension "
                       "in steps, nor dynamic relaxation converged{} (last residual {:.1e} of the line's weight). The "
                       "tension is {:.2f} times the suspended weight of plain pipe; near 1 the pipe goes into "
                       "compression at the seabed. Otherwise check for a box far off the curve of its neighbours, or a "
                       "current too strong for so light a pipe{}",
                       problem.is_exhausted() ? " within the limit of computational effort" : "",
                       problem.report.force_residual, problem.target.value / suspended_weight,
                       problem.missed_box_message)}));
}

/// Achieved value of the target. Tension is taken from the global force balance, not from strain.
double achieved_value(EquilibriumProblem& problem, const EquilibriumTarget& wanted) {
  if (wanted.kind == EquilibriumTarget::Kind::anchor_distance) {
    return wanted.value + problem.system.target_error(problem.state, wanted);
  }
  problem.system.evaluate(problem.state, false);
  const int last = problem.system.mesh().nodes() - 1;
  const Vec3 tangent = Eigen::Map<const Vec3>(problem.state.q.data() + 6 * last + 3);
  return problem.system.end_reaction(last).dot(tangent.normalized());
}

/// Checks the target independently: the continuation methods change it temporarily, and strains deviate from the forces
/// where the pipe bends more sharply than its elements can represent.
std::optional<StaticFailure> check_target(EquilibriumProblem& problem, const EquilibriumTarget& wanted) {
  const double value = achieved_value(problem, wanted);
  if (std::abs(value - wanted.value) <= kMaxMiss * std::abs(wanted.value)) {
    return std::nullopt;
  }
  const bool tension = wanted.kind == EquilibriumTarget::Kind::top_tension;
  const char* const unit = tension ? "N" : "m";
  return StaticFailure{tension ? "the set tension is not reached" : "the anchor is not reached", "at the tensioner",
                       fmt::format("{} is specified and {} found, although the forces balance: look for boxes far off "
                                   "the line of the pipe, over which it bends too sharply",
                                   shown(wanted.value, unit, 2), shown(value, unit, 2))};
}

/// True if the axial stiffness changes so near the tensioner that the strain of the node there does not follow from the
/// tension alone, as neighbouring elements share it.
bool has_stiffness_step_at_top(const EquilibriumProblem& problem) {
  constexpr std::size_t kReach = 20;  // elements; the effect of a step falls by a factor of about four per element
  const auto& stiffness = problem.system.line().elements.EA;
  const std::size_t last = problem.system.mesh().length.size() - 1;
  for (std::size_t e = last - std::min(last, kReach); e < last; ++e) {
    if (stiffness[e] != stiffness[last]) return true;
  }
  return false;
}

/// Near such a change, corrects the target of the strain until the global balance has the wanted tension.
bool correct_target_by_global_balance(EquilibriumProblem& problem, const EquilibriumTarget& wanted) {
  constexpr int kMaxIterations = 8;
  constexpr double kNear = 1e-5;
  if (wanted.kind != EquilibriumTarget::Kind::top_tension || !has_stiffness_step_at_top(problem)) return true;
  for (int i = 0; i < kMaxIterations; ++i) {
    const double value = achieved_value(problem, wanted);
    if (value <= 0.0 || std::abs(value - wanted.value) <= kNear * wanted.value) break;
    problem.target.value *= wanted.value / value;
    if (!solve_from_warm_start(problem, "tension by the balance of the line")) return false;
  }
  return true;
}

}  // namespace

StaticSystem system_with_history(const Model& model, LineMesh mesh, const LoadHistory& past) {
  StaticSystem system(model, model.mean_pose, std::move(mesh));
  if (past.across_rollers != 0.0) {
    Continuation continuation = system.continuation();
    continuation.roller_friction.across = past.across_rollers;
    system.set(continuation);
  }
  if (past.solution && system.line().yielding.any) {
    const StaticSolution& before = *past.solution;
    system.set_bending_history(moved_along({before.mesh, before.state.q, before.bending, before.pushes}, past.shift,
                                           system.line().yielding, system.mesh()));
  }
  return system;
}

namespace {

StaticOutcome solve_cold(const Model& model, const LoadHistory& past);

/// Retry without a warm start if that does not converge.
enum class ColdRetry { no, yes };

/// Solves without continuation in the curvature of the route.
StaticOutcome solve_at_once(const Model& model, const StaticSolution* start, const LoadHistory& past,
                            ColdRetry retry = ColdRetry::yes) {
  const auto begin = std::chrono::steady_clock::now();
  if (const auto unsupported = unsupported_in_statics(model.description)) {
    return fail(*unsupported);
  }
  const LayPlane plane = lay_plane(model, model.mean_pose);
  const bool same_line = start != nullptr && mesh_fits(model, *start);
  // on a pipe mesh a cable lay would lie deep in the bed: its own initial shape is closer than another stage
  if (!same_line && is_dragged(model.description)) start = nullptr;
  StartingPoint from = same_line ? starting_point_from_solution(model, plane, *start) : starting_point(model, plane);
  if (from.failure) {
    return fail(*from.failure);
  }
  if (auto failure = too_many_elements(model, from.zones)) {
    return fail(*failure);
  }
  if (same_line) from.zones.total = start->mesh.total_length();
  const auto retry_or = [&](StaticFailure failure) {
    return start != nullptr && retry == ColdRetry::yes ? solve_cold(model, past) : fail(std::move(failure));
  };
  EquilibriumProblem problem{model,
                             system_with_history(model, same_line ? start->mesh : build_mesh(model, from.zones), past),
                             {},
                             from.target,
                             {}};
  bool solved = false;
  if (start != nullptr) {
    problem.report.method = "newton, from the last solution";
    solved = solve_from(problem, *start, plane);
    if (!solved) return retry_or({"no equilibrium found from the last solution", "", ""});
  } else {
    solved = solve_from_shape(problem, from.shape);
  }
  const double aside = laid_offset_in_bend(model);
  for (int pass = 0; solved && pass < kMeshPasses; ++pass) {
    solved = correct_target_by_global_balance(problem, from.target) && fit_cable_to_winch(problem, past);
    if (!solved) break;
    if (!find_laid_line(problem, aside) && start != nullptr && pass == 0) {
      return retry_or({"no line of steady laying found from the last solution", "", ""});
    }
    const std::optional<ElementPlace> touchdown = landing(problem.system, problem.state);
    const MeshZones current = solved_zones(problem, from.zones, touchdown);
    const bool touches = touchdown.has_value();
    if (!touches && (model.description.pipe.length || pass == kMeshPasses - 1)) {
      return fail(with_lines(model, never_touches(model, problem.system.mesh().total_length())));
    }
    if (touches && mesh_fits_solution(problem, from.zones, current)) {
      break;
    }
    if (!from.shaped) {
      from = starting_point(model, plane);
      if (from.failure) return fail(*from.failure);
    }
    from.zones = solved_zones(problem, from.zones, touchdown);
    from.zones.touchdown = touches ? current.touchdown : 1.2 * problem.system.mesh().total_length();
    from.zones.total = is_dragged(model.description)
                           ? problem.system.mesh().total_length()
                           : model.description.pipe.length.value_or(from.zones.touchdown + from.tail);
    if (auto failure = too_many_elements(model, from.zones)) {
      return fail(*failure);
    }
    LineMesh mesh = build_mesh(model, from.zones);
    LineState moved = interpolate(problem.system.mesh(), problem.state, mesh, plane);
    problem.system = system_with_history(model, std::move(mesh), past);
    problem.state = std::move(moved);
    pin_far_end(problem.system, problem.state);
    solved = solve_on_new_mesh(problem, from.shape);
  }
  if (!solved) {
    if (auto failure = shape_failure(from.shape)) return fail(*failure);
    return make_failure(problem, suspended_pipe_weight(model, plane, model.pipe_section(), plane.bed(0.0)));
  }
  if (auto failure = check_supports(model, problem.system)) {
    return fail(*failure);
  }
  if (auto failure = check_target(problem, from.target)) {
    return fail(*failure);
  }
  if (auto failure = check_dragged(problem)) {
    return fail(*failure);
  }
  std::optional<StaticFailure> impossible = check_folds(problem.system.mesh(), problem.state.q);
  if (!impossible) impossible = check_above_rollers(model, problem.system, problem.state);
  if (impossible) return retry_or(*impossible);
  problem.report.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  StaticSolution solution;
  solution.mesh = problem.system.mesh();
  solution.state = problem.state;
  solution.report = problem.report;
  solution.bending = problem.system.bending_memory(problem.state);
  if (!solution.bending.empty()) solution.pushes = problem.system.roller_pushes(problem.state);
  solution.pose = model.mean_pose;
  solution.past = past;
  solution.zones = from.zones;
  solution.mesh_asked = model.description.mesh;
  return {std::move(solution), std::nullopt};
}

StaticOutcome solve_cold(const Model& model, const LoadHistory& past) {
  return is_anchored(model) ? solve_anchored(model, past) : solve_at_once(model, nullptr, past);
}

/// Continuation in route curvature, from the straight route: the arcs keep their lengths and their angles grow.
StaticOutcome continue_in_route_curvature(const Model& model, const LoadHistory& past) {
  constexpr int kSteps = 4;
  const RouteDescription& route = model.description.route;
  const double radius = route.corner_radius > 0.0 ? route.corner_radius : default_corner_radius(model);
  Model part = model;
  part.description.route = {};
  StaticOutcome outcome = solve_at_once(part, nullptr, past);
  for (int step = 1; step <= kSteps && outcome.solution; ++step) {
    part.description.route.points.clear();
    part.description.route.legs = route_legs(route, radius);
    for (RouteLeg& leg : part.description.route.legs) {
      leg.angle *= static_cast<double>(step) / kSteps;
      leg.radius *= static_cast<double>(kSteps) / step;
    }
    outcome = solve_at_once(step < kSteps ? part : model, &*outcome.solution, past);
  }
  return outcome;
}

}  // namespace

StaticOutcome solve_statics(const Model& model, const StaticSolution* start, const LoadHistory& past) {
  StaticOutcome outcome = start != nullptr ? solve_at_once(model, start, past) : solve_cold(model, past);
  if (outcome.solution || outcome.failure->input || !model.description.route.given()) return outcome;
  StaticOutcome bent = continue_in_route_curvature(model, past);
  return bent.solution ? std::move(bent) : std::move(outcome);
}

StaticOutcome continue_statics(const Model& model, const StaticSolution& start, const LoadHistory& past) {
  return solve_at_once(model, &start, past, ColdRetry::no);
}

StaticSolution::StaticSolution() = default;
StaticSolution::StaticSolution(const StaticSolution&) = default;
StaticSolution::StaticSolution(StaticSolution&&) noexcept = default;
StaticSolution& StaticSolution::operator=(const StaticSolution&) = default;
StaticSolution& StaticSolution::operator=(StaticSolution&&) noexcept = default;
StaticSolution::~StaticSolution() = default;

}  // namespace overbend
