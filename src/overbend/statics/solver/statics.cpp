#include "statics/solver/statics.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/shown_unit.h"
#include "model/lay_stage.h"
#include "model/pipe_attachments.h"
#include "statics/equations/bed_contacts.h"
#include "statics/equations/touchdown.h"
#include "statics/solver/anchored_lay.h"
#include "statics/solver/carried_start.h"
#include "statics/solver/dragged_line.h"
#include "statics/solver/static_obstacle.h"
#include "statics/solver/static_start.h"
#include "statics/solver/static_ways.h"
#include "statics/solver/steady_laying.h"
#include "statics/solver/support_outlier.h"

namespace overbend {
namespace {

constexpr int kMeshPasses = 6;         ///< Times the mesh may follow the touchdown found.
constexpr double kLargestMiss = 0.01;  ///< Of what is wanted; ordinary lays miss it by 2e-4 at most.

/// Whether a line of given length is as long in the model as a mesh is.
bool length_fits(const Model& model, const LineMesh& mesh) {
  const std::optional<double>& length = model.description.pipe.length;
  return !length || std::abs(mesh.total_length() - *length) <= 1e-9 * *length;
}

/// Whether a solution's mesh can stay: it is as long as the line, has the elements that are asked for, and its nodes
/// lie where the sections of the model end.
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
  return std::ranges::all_of(model.spans, [&](const SectionSpan& span) { return node_there(span.to); }) &&
         std::ranges::all_of(pipe_attachments(model.description),
                             [&](const PipeAttachment& attached) { return node_there(attached.from_top); });
}

bool solve_from_shape(StaticCase& at, const LayShape& shape) {
  make_elastic(at);
  return solve_elastic(at, shape) && let_yield(at);
}

/// On another mesh than the one the state was solved on.
bool solve_on_new_mesh(StaticCase& at, const LayShape& shape) {
  const LineState moved = at.state;
  if (follow(at, "mesh moved to the touchdown found")) {
    return true;
  }
  at.state = moved;
  make_elastic(at);
  at.least_found = 0.0;
  const bool solved = follow_softly(at) && let_yield(at);
  return solved || (at.least_found == 0.0 && solve_from_shape(at, shape));
}

/// Zones of the mesh as the solution has them.
MeshZones zones_of(const StaticCase& at, const MeshZones& built, const std::optional<ElementPlace>& touchdown) {
  MeshZones zones = built;
  const double total = at.system.mesh().total_length();
  if (touchdown) {
    zones.touchdown = total - touchdown->s;
  }
  if (const auto waterline = find_waterline(at.system, at.state)) {
    zones.waterline = total - waterline->s;
  }
  zones.last_support = std::max(zones.last_support, support_end(at.system));
  const bool dragged = is_dragged(at.model.description);
  if (!dragged) zones.bottom_tension = at.state.far_force;
  if (dragged || may_span(at.model)) {
    zones.bed_edges = contact_edges(at.system, bed_contacts(at.system, at.state));
  }
  return zones;
}

/// From a solution close by: on its mesh, or on one whose sections lie elsewhere.
bool solve_from(StaticCase& at, const StaticSolution& start, const LayPlane& plane) {
  const bool same_line = at.system.mesh().s == start.mesh.s;
  at.state = same_line ? start.state : interpolate(start.mesh, start.state, at.system.mesh(), plane);
  bring_to_ends(at.system, start.pose, start.zones ? start.zones->last_support : 0.0, at.state);
  const LineState brought = at.state;
  if (follow(at, "from the last solution")) return true;
  if (same_line) return false;
  at.state = brought;
  return follow_softly(at) && let_yield(at);
}

/// Whether every edge of contact on a shaped bed lies well inside the short elements made for one.
bool edges_serve(const StaticCase& at, const MeshZones& built, const MeshZones& now) {
  const double reach = 0.5 * soil_length(at.model, at.model.pipe_section().EI);
  return std::ranges::all_of(now.bed_edges, [&](const LineStretch& edge) {
    return std::ranges::any_of(built.bed_edges, [&](const LineStretch& zone) {
      return edge.from > zone.from - reach && edge.to < zone.to + reach;
    });
  });
}

/// Whether the fine zone and the tail still stand where the pipe touches down.
bool mesh_serves(const StaticCase& at, const MeshZones& built, const MeshZones& now) {
  const MeshSizes sizes = mesh_sizes(at.model, built);
  const double moved = now.touchdown - built.touchdown;
  const bool fine_zone = moved < 0.6 * sizes.touchdown_after && -moved < 0.4 * sizes.touchdown_before;
  const bool supports = now.last_support < built.last_support + 2.0 * sizes.overbend;
  const bool tail = at.model.description.pipe.length || is_dragged(at.model.description) ||
                    now.total - now.touchdown > 1.5 * sizes.touchdown_after;
  return fine_zone && supports && tail && edges_serve(at, built, now);
}

/// Finds the line on which the pipe is laid, `aside` on a route that bends; where there is none, the state stays as it
/// was. Whether it was found.
bool settled_or_kept(StaticCase& at, double aside) {
  const LineState before = at.state;
  const bool bends = at.system.lays_steadily() && !at.system.plane().route.straight();
  if (bends ? move_line(at, aside) : settle_steadily(at)) return true;
  at.state = before;
  at.report.history.emplace_back("steady laying: no line found on which the pipe comes to rest");
  return false;
}

StaticOutcome fail(StaticFailure failure) {
  return {std::nullopt, std::move(failure)};
}

/// A short line on the pipe takes the place of the tensioner, however that is set.
StaticFailure with_lines(const Model& model, StaticFailure failure) {
  if (model.description.lines.empty()) return failure;
  failure.why +=
      ". A line on the pipe that is too short for where the pipe hangs holds it instead of the tensioner, whose "
      "tension "
      "cannot be set then: look for a length or a place of a line that does not fit";
  return failure;
}

/// `hanging`: what the pipe weighs between tensioner and seabed, without what is built into it; a short piece that
/// floats would make it negative.
StaticOutcome give_up(const StaticCase& at, double hanging) {
  const int node = at.system.singular_node();
  const std::string where = node < 0 ? "the whole line"
                                     : fmt::format("node {} at s = {} from the anchor", node,
                                                   shown(at.system.mesh().s[static_cast<std::size_t>(node)], "m", 1));
  if (at.least_found > 0.0) {
    return fail(with_lines(at.system.model(), compressed_at_seabed(at.target.value, at.least_found)));
  }
  if (!at.yielded.empty()) {
    return fail(
        {"no equilibrium found: the pipe yields", "overbend",
         fmt::format("with linear steel there is one, with pipe.steel.material none was found: {}; the yielding pipe "
                     "folds there. A larger radius, a longer stinger or another tension bends it less",
                     at.yielded)});
  }
  const std::string what =
      at.left.empty() ? "no equilibrium found" : "no equilibrium found: the pipe runs off its rollers";
  const std::optional<SupportOutlier> outlier = support_outlier(at.system.model());
  return fail(with_lines(
      at.system.model(),
      {what, where,
       (outlier ? outlier_words(*outlier) + ". N" : "n") +
           fmt::format("either Newton's method, nor hardening the rollers, raising the current or lowering the "
                       "tension in steps, nor dynamic relaxation converged{} (last residual {:.1e} of the "
                       "line's weight). The tension is {:.2f} times the suspended weight of plain pipe; near 1 "
                       "the pipe goes into compression at the seabed. Otherwise look for a box far off the "
                       "curve of its neighbours, or a current too strong for so light a pipe{}",
                       at.spent() ? " within the limit of computational effort" : "", at.report.force_residual,
                       at.target.value / hanging, at.left)}));
}

/// What the state has of what is wanted: of a tension by the balance of the whole line, which says nothing of strains.
double found(StaticCase& at, const EquilibriumTarget& wanted) {
  if (wanted.kind == EquilibriumTarget::Kind::anchor_distance) {
    return wanted.value + at.system.target_error(at.state, wanted);
  }
  at.system.evaluate(at.state, false);
  const int last = at.system.mesh().nodes() - 1;
  const Vec3 tangent = Eigen::Map<const Vec3>(at.state.q.data() + 6 * last + 3);
  return at.system.end_reaction(last).dot(tangent.normalized());
}

/// What was asked for, looked at once more by itself: the ways change the target while they follow a solution, and
/// strains miss the forces where the pipe bends more sharply than its elements can.
std::optional<StaticFailure> missed(StaticCase& at, const EquilibriumTarget& wanted) {
  const double value = found(at, wanted);
  if (std::abs(value - wanted.value) <= kLargestMiss * std::abs(wanted.value)) {
    return std::nullopt;
  }
  const bool tension = wanted.kind == EquilibriumTarget::Kind::top_tension;
  const char* const unit = tension ? "N" : "m";
  return StaticFailure{tension ? "the set tension is not reached" : "the anchor is not reached", "at the tensioner",
                       fmt::format("{} is specified and {} found, although the forces balance: look for boxes far off "
                                   "the line of the pipe, over which it bends too sharply",
                                   shown(wanted.value, unit, 2), shown(value, unit, 2))};
}

/// Whether the axial stiffness steps so near the tensioner that the stretch of the node there is not that of the
/// tension alone: neighbouring elements share it.
bool shares_stretch(const StaticCase& at) {
  constexpr std::size_t kReach = 20;  // elements; a step dies away by about four from each to the next
  const auto& stiffness = at.system.line().elements.EA;
  const std::size_t last = at.system.mesh().length.size() - 1;
  for (std::size_t e = last - std::min(last, kReach); e < last; ++e) {
    if (stiffness[e] != stiffness[last]) return true;
  }
  return false;
}

/// Beside such a step what is asked of the stretch is changed until the balance of the whole line has what is wanted.
bool meet_by_balance(StaticCase& at, const EquilibriumTarget& wanted) {
  constexpr int kMost = 8;
  constexpr double kNear = 1e-5;
  if (wanted.kind != EquilibriumTarget::Kind::top_tension || !shares_stretch(at)) return true;
  for (int i = 0; i < kMost; ++i) {
    const double value = found(at, wanted);
    if (value <= 0.0 || std::abs(value - wanted.value) <= kNear * wanted.value) break;
    at.target.value *= wanted.value / value;
    if (!follow(at, "tension by the balance of the line")) return false;
  }
  return true;
}

}  // namespace

StaticSystem system_with_past(const Model& model, LineMesh mesh, const LinePast& past) {
  StaticSystem system(model, model.mean_pose, std::move(mesh));
  if (past.across_rollers != 0.0) {
    Continuation continuation = system.continuation();
    continuation.roller_friction.across = past.across_rollers;
    system.set(continuation);
  }
  if (past.solution && system.line().yielding.any) {
    const StaticSolution& before = *past.solution;
    system.begin_with(moved_along({before.mesh, before.state.q, before.bending, before.pushes}, past.shift,
                                  system.line().yielding, system.mesh()));
  }
  return system;
}

namespace {

StaticOutcome solve_from_nothing(const Model& model, const LinePast& past);

/// Where a start does not lead to the equilibrium.
enum class ColdRetry { no, yes };

/// Without a way round a bend of the route.
StaticOutcome solve_at_once(const Model& model, const StaticSolution* start, const LinePast& past,
                            ColdRetry retry = ColdRetry::yes) {
  const auto begin = std::chrono::steady_clock::now();
  if (const auto obstacle = static_obstacle(model.description)) {
    return fail(*obstacle);
  }
  const LayPlane plane = lay_plane(model, model.mean_pose);
  const bool same_line = start != nullptr && mesh_fits(model, *start);
  // pipe where a cable lay would stand deep in the bed: a guess of its own is nearer than another stage
  if (!same_line && is_dragged(model.description)) start = nullptr;
  StartingPoint from = same_line ? point_beside(model, plane, *start) : starting_point(model, plane);
  if (from.failure) {
    return fail(*from.failure);
  }
  if (auto failure = too_many_elements(model, from.zones)) {
    return fail(*failure);
  }
  if (same_line) from.zones.total = start->mesh.total_length();
  const auto retry_or = [&](StaticFailure failure) {
    return start != nullptr && retry == ColdRetry::yes ? solve_from_nothing(model, past) : fail(std::move(failure));
  };
  StaticCase at{model,
                system_with_past(model, same_line ? start->mesh : build_mesh(model, from.zones), past),
                {},
                from.target,
                {}};
  bool solved = false;
  if (start != nullptr) {
    at.report.method = "newton, from the last solution";
    solved = solve_from(at, *start, plane);
    if (!solved) return retry_or({"no equilibrium found from the last solution", "", ""});
  } else {
    solved = solve_from_shape(at, from.shape);
  }
  const double aside = laid_beside(model);
  for (int pass = 0; solved && pass < kMeshPasses; ++pass) {
    solved = meet_by_balance(at, from.target) && reach_winch(at, past);
    if (!solved) break;
    if (!settled_or_kept(at, aside) && start != nullptr && pass == 0) {
      return retry_or({"no line of steady laying found from the last solution", "", ""});
    }
    const std::optional<ElementPlace> touchdown = landing(at.system, at.state);
    const MeshZones now = zones_of(at, from.zones, touchdown);
    const bool touches = touchdown.has_value();
    if (!touches && (model.description.pipe.length || pass == kMeshPasses - 1)) {
      return fail(with_lines(model, never_touches(model, at.system.mesh().total_length())));
    }
    if (touches && mesh_serves(at, from.zones, now)) {
      break;
    }
    if (!from.shaped) {
      from = starting_point(model, plane);
      if (from.failure) return fail(*from.failure);
    }
    from.zones = zones_of(at, from.zones, touchdown);
    from.zones.touchdown = touches ? now.touchdown : 1.2 * at.system.mesh().total_length();
    from.zones.total = is_dragged(model.description)
                           ? at.system.mesh().total_length()
                           : model.description.pipe.length.value_or(from.zones.touchdown + from.tail);
    if (auto failure = too_many_elements(model, from.zones)) {
      return fail(*failure);
    }
    LineMesh mesh = build_mesh(model, from.zones);
    LineState moved = interpolate(at.system.mesh(), at.state, mesh, plane);
    at.system = system_with_past(model, std::move(mesh), past);
    at.state = std::move(moved);
    pin_far_end(at.system, at.state);
    solved = solve_on_new_mesh(at, from.shape);
  }
  if (!solved) {
    if (auto failure = shape_failure(from.shape)) return fail(*failure);
    return give_up(at, hanging_weight(model, plane, model.pipe_section(), plane.bed(0.0)));
  }
  if (auto failure = check_supports(model, at.system)) {
    return fail(*failure);
  }
  if (auto failure = missed(at, from.target)) {
    return fail(*failure);
  }
  if (auto failure = check_dragged(at)) {
    return fail(*failure);
  }
  std::optional<StaticFailure> impossible = check_folds(at.system.mesh(), at.state.q);
  if (!impossible) impossible = check_above_rollers(model, at.system, at.state);
  if (impossible) return retry_or(*impossible);
  at.report.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  StaticSolution solution;
  solution.mesh = at.system.mesh();
  solution.state = at.state;
  solution.report = at.report;
  solution.bending = at.system.bending_memory(at.state);
  if (!solution.bending.empty()) solution.pushes = at.system.roller_pushes(at.state);
  solution.pose = model.mean_pose;
  solution.past = past;
  solution.zones = from.zones;
  solution.mesh_asked = model.description.mesh;
  return {std::move(solution), std::nullopt};
}

StaticOutcome solve_from_nothing(const Model& model, const LinePast& past) {
  return is_anchored(model) ? solve_anchored(model, past) : solve_at_once(model, nullptr, past);
}

/// A route that bends, from the straight one on: its arcs keep their lengths and turn more and more.
StaticOutcome bend_in_steps(const Model& model, const LinePast& past) {
  constexpr int kSteps = 4;
  const RouteDescription& route = model.description.route;
  const double radius = route.corner_radius > 0.0 ? route.corner_radius : default_corner_radius(model);
  Model part = model;
  part.description.route = {};
  StaticOutcome found = solve_at_once(part, nullptr, past);
  for (int step = 1; step <= kSteps && found.solution; ++step) {
    part.description.route.points.clear();
    part.description.route.legs = route_legs(route, radius);
    for (RouteLeg& leg : part.description.route.legs) {
      leg.angle *= static_cast<double>(step) / kSteps;
      leg.radius *= static_cast<double>(kSteps) / step;
    }
    found = solve_at_once(step < kSteps ? part : model, &*found.solution, past);
  }
  return found;
}

}  // namespace

StaticOutcome solve_statics(const Model& model, const StaticSolution* start, const LinePast& past) {
  StaticOutcome outcome = start != nullptr ? solve_at_once(model, start, past) : solve_from_nothing(model, past);
  if (outcome.solution || outcome.failure->input || !model.description.route.given()) return outcome;
  StaticOutcome bent = bend_in_steps(model, past);
  return bent.solution ? std::move(bent) : std::move(outcome);
}

StaticOutcome continue_statics(const Model& model, const StaticSolution& start, const LinePast& past) {
  return solve_at_once(model, &start, past, ColdRetry::no);
}

StaticSolution::StaticSolution() = default;
StaticSolution::StaticSolution(const StaticSolution&) = default;
StaticSolution::StaticSolution(StaticSolution&&) noexcept = default;
StaticSolution& StaticSolution::operator=(const StaticSolution&) = default;
StaticSolution& StaticSolution::operator=(StaticSolution&&) noexcept = default;
StaticSolution::~StaticSolution() = default;

}  // namespace overbend
