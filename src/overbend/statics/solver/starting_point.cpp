#include "statics/solver/starting_point.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "model/site/seabed_shape.h"

#include "model/lay_stage.h"
#include "model/pipe_attachments.h"
#include "model/site/seabed_shape.h"
#include "statics/equations/touchdown.h"
#include "statics/initial_shape/stage_shape.h"
#include "statics/solver/support_line.h"
#include "statics/solver/warm_start.h"

namespace overbend {
namespace {

StaticFailure floats(const Section& pipe) {
  return {"the pipe floats", "the whole line",
          fmt::format("its submerged weight is {}; a pipe is laid on the seabed only if that is positive: add "
                      "weight coating",
                      shown_digits(pipe.weight_submerged, line_weight_unit(), 4))};
}

StaticFailure too_little_tension(double tension, double min_tension) {
  return {"the tension is too low to carry the pipe",
          "at the tensioner",
          fmt::format("tension {} is below the suspended weight between tensioner and seabed, {} (weight in air above "
                      "the water, submerged weight below); at a lower tension the pipe is in compression at the seabed",
                      shown(tension, "N", 1), shown(min_tension, "N", 1)),
          false,
          {},
          FailureKind::tension_too_low};
}

StaticFailure no_curve(const std::string& problem) {
  return {"the pipe does not reach the seabed", "sagbend", problem};
}

/// Key of analysis.mesh whose omission gives the fewest elements; empty if no key is given.
std::string finest_key(const Model& model, const MeshZones& zones) {
  std::string finest;
  long fewest = std::numeric_limits<long>::max();
  const auto try_without = [&](const char* key, std::optional<double> MeshDescription::*value) {
    if (!(model.description.mesh.*value)) return;
    Model without = model;
    (without.description.mesh.*value).reset();
    const long count = count_elements(without, zones);
    if (count >= fewest) return;
    fewest = count;
    finest = std::string("analysis.mesh.") + key;
  };
  try_without("overbend_element", &MeshDescription::overbend_element);
  try_without("touchdown_element", &MeshDescription::touchdown_element);
  try_without("longest_element", &MeshDescription::max_element_length);
  return finest;
}

std::size_t touchdown_index(const LayShape& shape) {
  return static_cast<std::size_t>(std::lower_bound(shape.length.begin(), shape.length.end(), shape.touchdown) -
                                  shape.length.begin());
}

/// Tension between two bounds at which `reach` is the wanted distance, by bisection.
template <class Reach>
double tension_that_reaches(const Reach& reach, double low, double high, double distance) {
  for (int i = 0; i < 60; ++i) {
    const double middle = std::sqrt(low * high);
    (reach(middle) < distance ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

/// Height of the line's axis on the highest point of the bed that it may meet; of a plane, below the tensioner.
double highest_bed(const LayPlane& plane) {
  const SeabedShape* shape = plane.surface.shape();
  return shape == nullptr ? plane.bed(0.0) : std::min(shape->highest + plane.radius, 0.9 * plane.tensioner_W.z());
}

/// Starting point of a line with a cable in it, with its sections in place.
StartingPoint stage_start(const Model& model, const LayPlane& plane, StartingPoint start) {
  const Description& d = model.description;
  start.target = {EquilibriumTarget::Kind::top_tension, d.tensioner.tension.value_or(0.0)};
  double tension = start.target.value;
  if (!d.tensioner.tension) {
    const double distance = *d.pipe.anchor - d.tensioner.x;
    start.target = {EquilibriumTarget::Kind::anchor_distance, distance};
    const auto reach = [&](double pull) {
      const LayShape shape = stage_shape(model, plane, pull);
      return shape.problem.empty() ? shape.distance.back() : 0.0;
    };
    const double min_tension = min_stage_top_tension(model, plane);
    tension = tension_that_reaches(reach, 0.5 * min_tension, 50.0 * min_tension, distance);
  }
  start.shape = stage_shape(model, plane, tension);
  if (!start.shape.problem.empty()) {
    start.failure =
        shape_failure(start.shape)
            .value_or(StaticFailure{"the tension is too low to carry the line", "at the top", start.shape.problem});
    return start;
  }
  start.tail = start.shape.total - start.shape.touchdown;
  start.zones = {start.shape.total,
                 start.shape.last_support,
                 start.shape.touchdown,
                 start.shape.waterline,
                 tension,
                 start.shape.bottom_tension,
                 {}};
  for (const double edge : start.shape.edges) start.zones.bed_edges.push_back({edge, edge});
  start.failure = too_many_elements(model, start.zones);
  return start;
}

}  // namespace

std::optional<StaticFailure> shape_failure(const LayShape& shape) {
  if (!shape.error) return std::nullopt;
  return StaticFailure{shape.error->what,           shape.error->where, shape.error->why, false, {},
                       FailureKind::tension_too_low};
}

std::optional<StaticFailure> too_many_elements(const Model& model, const MeshZones& zones) {
  const long count = count_elements(model, zones);
  if (count <= kMaxElements) return std::nullopt;
  const std::string key = finest_key(model, zones);
  const std::string remedy = key.empty()
                                 ? "the line is too long for its supports and touchdown: check for a length or a "
                                   "position of a box in the wrong unit"
                                 : "use longer elements, or omit the key";
  return StaticFailure{"the mesh is too fine", key,
                       fmt::format("a line of {} would have {} elements, the maximum is {}; {}",
                                   shown(zones.total, "m", 0), count, kMaxElements, remedy),
                       true};
}

double shape_distance(const LayShape& shape, double length) {
  if (!shape.problem.empty()) return 0.0;
  return shape.distance[touchdown_index(shape)] + length - shape.touchdown;  // the rest lies on the bed
}

double tension_for_anchor(const Model& model, const LayPlane& plane) {
  const Description& d = model.description;
  const double suspended_weight =
      std::max(1.0, suspended_pipe_weight(model, plane, model.pipe_section(), highest_bed(plane)));
  const auto reach = [&](double tension) { return shape_distance(lay_shape(model, plane, tension), *d.pipe.length); };
  return tension_that_reaches(reach, 1.001 * suspended_weight, 50.0 * suspended_weight, find_target(d).value);
}

EquilibriumTarget find_target(const Description& description) {
  if (description.tensioner.tension || !description.pipe.length || !description.pipe.anchor) {
    return {EquilibriumTarget::Kind::top_tension, description.tensioner.tension.value_or(0.0)};
  }
  return {EquilibriumTarget::Kind::anchor_distance, *description.pipe.anchor - description.tensioner.x};
}

namespace {

/// Minimum tension at which the plain pipe can be suspended; structures fixed to it may carry it at a lower tension,
/// which the equilibrium decides [N].
double min_suspension_tension(const Model& model, const LayPlane& plane, double bed_z) {
  return pipe_attachments(model.description).empty() ? suspended_pipe_weight(model, plane, bed_z) : 0.0;
}

/// Returns a failure if the tension alone yields the pipe: the laws of yielding steel cover bending, axially the rod is
/// elastic.
std::optional<StaticFailure> pulled_beyond_yield(const Model& model) {
  const Section& section = model.sections[static_cast<std::size_t>(model.section_at(0.0))];
  if (!section.bending || !model.description.tensioner.tension) return std::nullopt;
  const double tension = *model.description.tensioner.tension,
               wall = tension + section.internal_pressure * section.internal_area;
  const double yield_load = section.yield_stress * section.steel_area;
  if (wall < yield_load) return std::nullopt;
  return StaticFailure{"the tension exceeds the yield load of the pipe", "at the tensioner",
                       fmt::format("{} (tensioner.tension{}) is {:.2f} times the yield load of section '{}', {} (yield "
                                   "stress times steel area); the steel law covers bending of a pipe that tension "
                                   "alone does not yield: check the tension and its unit",
                                   shown_digits(wall, "N", 6), wall > tension ? " with the internal pressure" : "",
                                   wall / yield_load, section.name, shown_digits(yield_load, "N", 6))};
}

/// Checks that need no shape.
std::optional<StaticFailure> find_basic_failure(const Model& model, const LayPlane& plane) {
  const Section& pipe = model.pipe_section();
  if (pipe.weight_submerged <= 0.0) return floats(pipe);
  const SeabedDescription& bed = model.description.environment.seabed;
  if (bed.soil == SoilModel::hyperbolic && pipe.weight_submerged >= bed.bearing_force.value_or(0.0)) {
    return StaticFailure{"the seabed does not carry the pipe", "the laid pipe",
                         fmt::format("its submerged weight of {} is not below the bearing force of the soil, "
                                     "{} (environment.seabed.soil)",
                                     shown_digits(pipe.weight_submerged, line_weight_unit(), 4),
                                     shown_digits(bed.bearing_force.value_or(0.0), line_weight_unit(), 4))};
  }
  if (plane.tensioner_W.z() <= plane.bed(0.0)) {
    return StaticFailure{"the tensioner is below the seabed", "at the tensioner", "check water depth and tensioner.z"};
  }
  if (auto failure = pulled_beyond_yield(model)) return failure;
  return misplaced_box(model, plane);
}

}  // namespace

StartingPoint starting_point(const Model& model, const LayPlane& plane) {
  const Description& d = model.description;
  StartingPoint start;
  start.failure = find_basic_failure(model, plane);
  if (start.failure) return start;
  if (has_cable(d)) return stage_start(model, plane, std::move(start));
  const double min_tension = min_suspension_tension(model, plane, highest_bed(plane));
  start.target = find_target(d);
  const bool anchored = start.target.kind == EquilibriumTarget::Kind::anchor_distance;
  const double tension = anchored ? tension_for_anchor(model, plane) : start.target.value;
  if (tension <= min_tension) {
    start.failure = too_little_tension(tension, min_tension);
    return start;
  }
  start.shape = lay_shape(model, plane, tension);
  if (!start.shape.problem.empty()) {
    start.failure = no_curve(start.shape.problem);
    return start;
  }
  // on a slope the depth at the landing decides
  const double landing_z = start.shape.z[touchdown_index(start.shape)];
  if (const double needed = min_suspension_tension(model, plane, landing_z); !anchored && tension <= needed) {
    start.failure = too_little_tension(tension, needed);
    return start;
  }
  if (d.pipe.length) {  // the equilibrium, not the initial shape, decides whether a line of that length reaches the bed
    constexpr double kMaxSuspended = 0.95;
    start.shape.total = *d.pipe.length;
    start.shape.touchdown = std::min(start.shape.touchdown, kMaxSuspended * start.shape.total);
  }
  start.tail = start.shape.total - start.shape.touchdown;
  start.zones = {start.shape.total,
                 start.shape.last_support,
                 start.shape.touchdown,
                 start.shape.waterline,
                 tension,
                 start.shape.bottom_tension,
                 {}};
  start.failure = too_many_elements(model, start.zones);
  return start;
}

StartingPoint starting_point_from_solution(const Model& model, const LayPlane& plane, const StaticSolution& solution) {
  const Description& d = model.description;
  const bool level = plane.surface.shape() == nullptr && d.environment.seabed.slope == 0.0;
  // the search for a stinger's angles turns it below successive lays, on the mesh of each initial shape
  const bool turns = !d.supports.sections.empty();
  if (!solution.zones || !level || turns || !plane.route.straight() || has_cable(d)) {
    return starting_point(model, plane);
  }
  StartingPoint start;
  start.shaped = false;
  start.failure = find_basic_failure(model, plane);
  if (start.failure) return start;
  start.target = find_target(d);
  if (start.target.kind == EquilibriumTarget::Kind::top_tension) {
    const double min_tension = min_suspension_tension(model, plane, highest_bed(plane));
    if (start.target.value <= min_tension) {
      start.failure = too_little_tension(start.target.value, min_tension);
      return start;
    }
  }
  start.zones = *solution.zones;
  return start;
}

LineState sample_shape(const StaticSystem& system, const LayShape& shape) {
  const LayPlane& plane = system.plane();
  const LineMesh& mesh = system.mesh();
  LineState state;
  state.far_force = shape.far_force.value_or(shape.bottom_tension);
  state.q.resize(6 * mesh.s.size());
  for (std::size_t node = 0; node < mesh.s.size(); ++node) {
    const double u = mesh.total_length() - mesh.s[node];
    const auto after = std::lower_bound(shape.length.begin() + 1, shape.length.end() - 1, u);
    const std::size_t i = static_cast<std::size_t>(after - shape.length.begin());
    const double f = (u - shape.length[i - 1]) / (shape.length[i] - shape.length[i - 1]);
    const auto mix = [&](const std::vector<double>& v) { return (1.0 - f) * v[i - 1] + f * v[i]; };
    const double dip = u > shape.length.back() ? shape.dip.back() : mix(shape.dip);
    Eigen::Map<Vec3> r(state.q.data() + 6 * node), t(state.q.data() + 6 * node + 3);
    const double distance = mix(shape.distance);
    r = plane.tensioner_W + distance * plane.astern_W;
    Vec3 astern = plane.astern_W;
    if (!plane.route.straight()) {
      const double along = plane.route.distance(plane.tensioner_W) + distance;
      r = plane.route.place(along);
      astern = plane.route.direction(along);
    }
    r.z() = mix(shape.z);
    t = -std::cos(dip) * astern + std::sin(dip) * Vec3::UnitZ();
  }
  if (system.held_direction()) {  // a vessel off the course does not guide the pipe along the route
    Eigen::Map<Vec3>(state.q.data() + state.q.size() - 3) = *system.held_direction();
  }
  pin_far_end(system, state);
  return state;
}

double support_end(const StaticSystem& system) {
  double end = 0.0;
  for (const RollerContact& roller : system.contacts()) {
    if (roller.closest.found && roller.penetration > 0.0) {
      const std::size_t e = static_cast<std::size_t>(roller.closest.element);
      const double s = system.mesh().s[e] + roller.closest.xi * system.mesh().length[e];
      end = std::max(end, system.mesh().total_length() - s);
    }
  }
  return end;
}

namespace {

bool misses_roller(const Model& model, const StaticSystem& system, std::size_t roller) {
  const Roller& bottom = model.supports.rollers[roller];
  const ClosestPoint& closest = system.contacts()[roller].closest;
  const PlacedRoller& placed = system.rollers().placed(static_cast<int>(roller));
  return has_left_box_sideways(bottom.position, placed, closest, model.section_over(bottom).outer_radius()) &&
         closest.off_end > 0.0;  // otherwise below the roller, in a failed attempt
}

}  // namespace

int count_missed_boxes(const Model& model, const StaticSystem& system) {
  std::set<int> boxes;
  for (std::size_t i = 0; i < model.supports.rollers.size(); ++i) {
    if (misses_roller(model, system, i)) boxes.insert(model.supports.rollers[i].box);
  }
  return static_cast<int>(boxes.size());
}

std::optional<MissedBox> find_missed_box(const Model& model, const StaticSystem& system) {
  const std::vector<Roller>& rollers = model.supports.rollers;
  for (std::size_t i = 0; i < rollers.size(); ++i) {
    if (!misses_roller(model, system, i)) continue;
    const ClosestPoint& closest = system.contacts()[i].closest;
    if (closest.off_end > system.mesh().total_length()) return std::nullopt;
    const bool sided = ranges::any_of(rollers, [&](const Roller& roller) {
      return roller.box == rollers[i].box && roller.position != RollerPosition::bottom;
    });
    return MissedBox{model.supports.boxes[static_cast<std::size_t>(rollers[i].box)].name, closest.off_end, sided};
  }
  return std::nullopt;
}

std::optional<std::string> box_above_pipe(const Model& model, const StaticSystem& system, const LineState& state) {
  const std::vector<Roller>& rollers = model.supports.rollers;
  for (std::size_t i = 0; i < rollers.size(); ++i) {
    if (rollers[i].position != RollerPosition::bottom) continue;
    const PlacedRoller& placed = system.rollers().placed(static_cast<int>(i));
    const ClosestPoint closest = closest_to_roller(system, state, static_cast<int>(i));
    const bool below = closest.found && (closest.place - closest.reference).dot(placed.normal) < 0.0;
    if (below && closest.off_end <= 0.0) return model.supports.boxes[static_cast<std::size_t>(rollers[i].box)].name;
  }
  return std::nullopt;
}

std::string off_end_message(const MissedBox& left) {
  return fmt::format("{} off the end of its roller{}", shown(left.off_end, "m", 2),
                     left.sided ? "" : "; that box has no side rollers to hold it");
}

std::optional<StaticFailure> check_supports(const Model& model, const StaticSystem& system) {
  const auto& states = system.contacts();
  const bool carried = std::any_of(states.begin(), states.end(), [](const RollerContact& r) { return r.normal > 0.0; });
  if (model.supports.boxes.empty() || carried) {
    return std::nullopt;
  }
  if (const std::optional<MissedBox> left = find_missed_box(model, system)) {
    return StaticFailure{"the pipe runs off its rollers", left->name,
                         fmt::format("no roller carries it: it is in equilibrium next to its supports, at '{}' {}",
                                     left->name, off_end_message(*left))};
  }
  return StaticFailure{"the pipe lifts off every support", "ramp and stinger",
                       "it hangs clear of all rollers from the tensioner to the seabed: the tension is too high for "
                       "this depth, or the supports are too low"};
}

std::optional<StaticFailure> check_folds(const LineMesh& mesh, const std::vector<double>& q) {
  for (int node = 1; node < mesh.nodes(); ++node) {
    const double* before = q.data() + 6 * (node - 1);
    const double* current = q.data() + 6 * node;
    if (Eigen::Map<const Vec3>(before + 3).dot(Eigen::Map<const Vec3>(current + 3)) >= 0.0) continue;
    return StaticFailure{"no equilibrium found: the line is folded", "in the span",
                         fmt::format("{} from the tensioner it turns by more than a right angle within one element; "
                                     "try another tension, or shorter elements (analysis.mesh)",
                                     shown(mesh.total_length() - mesh.s[static_cast<std::size_t>(node)], "m", 1))};
  }
  return std::nullopt;
}

std::optional<StaticFailure> check_above_rollers(const Model& model, const StaticSystem& system,
                                                 const LineState& state) {
  const std::optional<std::string> box = box_above_pipe(model, system, state);
  if (!box) return std::nullopt;
  return StaticFailure{"no equilibrium found on the rollers", fmt::format("box '{}'", *box),
                       "the only equilibrium found has the pipe below this box, through whose rollers it cannot pass: "
                       "check for a box far off the curve of its neighbours, or try another tension"};
}

StaticFailure compressed_at_seabed(double tension, double min_tension) {
  return {"the tension is too low to carry the pipe",
          "sagbend",
          fmt::format("tension {} is below the {} needed with zero bottom tension, for the suspended weight, the slope "
                      "of the seabed and the current; at a lower tension the pipe is in compression at the seabed",
                      shown_digits(tension, "N", 6), shown_digits(min_tension, "N", 6)),
          false,
          {},
          FailureKind::tension_too_low};
}

StaticFailure never_touches(const Model& model, double length) {
  const std::string length_name = model.description.pipe.length ? "pipe.length" : "the trial length";
  return {"the pipe does not reach the seabed",
          "sagbend",
          fmt::format("{} of {} ends before touchdown: give more length, or less tension", length_name,
                      shown(length, "m", 0)),
          false,
          {},
          FailureKind::no_touchdown};
}

}  // namespace overbend
