#include "statics/recovery/recovery_supports.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/constants.h"
#include "base/ranges.h"
#include "base/shown_unit.h"
#include "mechanics/contact_damage.h"
#include "model/box_dip.h"
#include "model/vessel/fitted_circle.h"

namespace overbend {
namespace {

struct Axes {
  Vec3 along, port;  ///< Axes of a box in W: along it astern, and across to port.
};

/// Intersection of the centreline with the plane through a row perpendicular to the box axis.
struct Crossing {
  int element = 0;
  double xi = 0.0;
  Vec3 p_W = Vec3::Zero();
};

/// Intersection nearest to the row; there is only one unless the pipe turns back.
std::optional<Crossing> cross_plane(const StaticSystem& system, const LineState& state, const Vec3& point_W,
                                    const Vec3& normal_W) {
  const LineMesh& mesh = system.mesh();
  std::optional<Crossing> nearest;
  const auto height = [&](int node) {
    return normal_W.dot(Eigen::Map<const Vec3>(state.q.data() + 6 * node) - point_W);
  };
  double before = height(0);
  for (int e = 0; e < mesh.elements(); ++e) {
    const double after = height(e + 1);
    if (before > 0.0 && after <= 0.0) {  // the line runs towards the vessel, the box axis astern
      const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * e));
      const double h = mesh.length[static_cast<std::size_t>(e)];
      double low = 0.0, high = 1.0;
      for (int i = 0; i < 55; ++i) {
        const double middle = 0.5 * (low + high);
        (normal_W.dot(centreline(q, middle, h).r - point_W) > 0.0 ? low : high) = middle;
      }
      const Crossing crossing{e, high, centreline(q, high, h).r};
      if (!nearest || (crossing.p_W - point_W).norm() < (nearest->p_W - point_W).norm()) {
        nearest = crossing;
      }
    }
    before = after;
  }
  return nearest;
}

RollerResult recover_roller(const Roller& roller, const Section& pipe, const PlacedRoller& placed,
                            const RollerContact& state, const ClosestPoint& point, const Axes& axes) {
  RollerResult result;
  result.position = roller.position;
  result.reaction = state.normal;
  const Vec3 force = state.force();
  result.vertical = force.z();
  result.longitudinal = force.dot(axes.along);
  result.lateral = force.dot(axes.port);
  result.off_end = point.beyond_face ? point.off_end : 0.0;
  result.p_W = placed.center + placed.radius * placed.normal;
  result.normal_W = placed.normal;
  result.axis_W = placed.axis;
  result.radius = roller.radius;
  result.face = roller.face;
  result.line_load = line_load(state.normal, contact_length(roller.face, pipe.outer_diameter, pipe.steel_diameter));
  return result;
}

/// Point of the pipe nearest to a roller.
struct Nearest {
  Vec3 p_W = Vec3::Zero();  ///< Point of the centreline.
  double gap = 0.0;         ///< Clearance, negative for penetration [m].
};

/// Nearest end of a pipe that does not pass the roller.
Nearest nearest_end(const StaticSystem& system, const LineState& state, const PlacedRoller& placed) {
  Nearest nearest;
  nearest.gap = kInfinity;
  for (const int node : {0, system.mesh().elements()}) {
    const Vec3 end = Eigen::Map<const Vec3>(state.q.data() + 6 * node);
    const Vec3 from = end - placed.center;
    const double along = std::clamp(from.dot(placed.axis), -placed.half_face, placed.half_face);
    const std::size_t e = static_cast<std::size_t>(std::min(node, system.mesh().elements() - 1));
    const double gap = (from - along * placed.axis).norm() - placed.radius - system.elements().radius[e];
    if (gap < nearest.gap) nearest = {end, gap};
  }
  return nearest;
}

/// Nearest point in the closest direction between centreline and roller, as in the contact: the gap of a loaded roller
/// is its penetration.
Nearest nearest_to(const StaticSystem& system, const LineState& state, const PlacedRoller& placed,
                   const ClosestPoint& point) {
  if (!point.found) return nearest_end(system, state, placed);
  const std::size_t e = static_cast<std::size_t>(point.element);
  const double distance = roller_distance(placed, point).value;
  return {point.place, distance - placed.radius - system.elements().radius[e]};
}

struct RowTotals {
  Vec3 force = Vec3::Zero();
  bool contact = false;
  double last_s = kInfinity;  ///< Arc length of the contact nearest to the seabed.
  /// Distance of the pipe beyond the end of a bottom roller that it has left, negative to starboard [m].
  std::optional<double> distance_off_end = {};
  double clearance = 0.0;  ///< Clearance over the first roller, see StaticResults::stinger_tip_clearance [m].
};

RowTotals recover_row(RowResult& result, const SupportRow& row, const StaticSystem& system, const LineState& state,
                      const Axes& axes) {
  const Model& model = system.model();
  RowTotals totals;
  result.p_W = point_from_ramp(model, model.mean_pose, row.point_S);
  const std::optional<Crossing> crossing = cross_plane(system, state, result.p_W, axes.along);
  const LineMesh& mesh = system.mesh();
  result.s = -1.0;
  double pipe_radius = model.sections[static_cast<std::size_t>(model.section_at(row.from_top))].outer_radius();
  if (crossing) {
    const std::size_t e = static_cast<std::size_t>(crossing->element);
    result.s = mesh.s[e] + crossing->xi * mesh.length[e];
    pipe_radius = system.elements().radius[e];
  }
  for (int i = row.first_roller; i < row.first_roller + row.roller_count; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    const RollerContact& contact = system.contacts()[k];
    const PlacedRoller& placed = system.rollers().placed(i);
    const ClosestPoint point = closest_to_roller(system, state, i);
    RollerResult roller = recover_roller(model.supports.rollers[k], model.section_over(model.supports.rollers[k]),
                                         placed, contact, point, axes);
    const Nearest nearest = nearest_to(system, state, placed, point);
    roller.separation = nearest.gap;
    const bool left = has_left_box_sideways(roller.position, placed, point, pipe_radius);
    if (i == row.first_roller) {
      totals.clearance = left && point.found ? height_above_roller(placed, point, pipe_radius) : roller.separation;
    }
    if (left) {
      totals.distance_off_end = std::copysign(roller.off_end, (nearest.p_W - roller.p_W).dot(axes.port));
    }
    if (contact.normal > 0.0) {
      const std::size_t e = static_cast<std::size_t>(contact.closest.element);
      totals.force += contact.force();
      totals.contact = true;
      totals.last_s = std::min(totals.last_s, mesh.s[e] + contact.closest.xi * mesh.length[e]);
    }
    result.rollers.push_back(roller);
  }
  result.reaction = totals.force.norm();
  return totals;
}

/// Sets the maximum pipe loads over the box's length, including its ends and middle, interpolated between stations.
/// Does nothing if the pipe does not pass the box.
void set_pipe_loads(SupportResult& box, const std::vector<Station>& stations) {
  if (box.s < 0.0) return;
  const auto take = [&](double Station::*load, double SupportResult::*maximum) {
    const auto at_place = [&](double s) {
      const auto after = ranges::lower_bound(stations, s, {}, &Station::s);
      if (after == stations.begin() || after == stations.end()) return 0.0;
      const Station &above = *after, &below = *(after - 1);
      return below.*load + (s - below.s) / (above.s - below.s) * (above.*load - below.*load);
    };
    const double reach = 0.5 * box.length + 0.3;
    for (const double s : {box.s - reach, box.s, box.s + reach}) box.*maximum = std::max(box.*maximum, at_place(s));
    for (const Station& station : stations) {
      if (std::abs(station.s - box.s) <= reach) box.*maximum = std::max(box.*maximum, station.*load);
    }
  };
  take(&Station::effective_tension, &SupportResult::effective_tension);
  take(&Station::bending_moment, &SupportResult::bending_moment);
  take(&Station::bending_stress, &SupportResult::bending_stress);
  take(&Station::von_mises, &SupportResult::von_mises);
  take(&Station::strain, &SupportResult::strain);
}

void find_min_separations(SupportResult& box) {
  double bottom = kInfinity, side = kInfinity;
  for (const RowResult& row : box.rows) {
    for (const RollerResult& roller : row.rollers) {
      double& min_separation = roller.position == RollerPosition::bottom ? bottom : side;
      min_separation = std::min(min_separation, roller.separation);
    }
  }
  box.has_sides = side < kInfinity;
  box.separation = bottom;
  box.separation_lateral = box.has_sides ? side : 0.0;
}

void warn_of_runoff(StaticResults& results, const SupportResult& box) {
  for (const RowResult& row : box.rows) {
    for (const RollerResult& roller : row.rollers) {
      if (roller.off_end > 0.0 && roller.reaction > 0.0) {
        results.findings.push_back(
            Finding{FindingCode::pipe_at_roller_end, "the pipe runs off the end of a roller: " + box.name + ", " +
                                                         word(roller.position) + " roller, by " +
                                                         shown(roller.off_end, section_length(), 0)}
                .on(box.name)
                .with("distance", roller.off_end, "m"));
      }
    }
  }
}

/// Boxes that the pipe misses on one side.
struct MissedBoxes {
  const char* side;
  std::string first = {};         ///< Name of the first one from the tensioner.
  int more = 0;                   ///< Number of others.
  double distance_off_end = 0.0;  ///< Maximum distance [m].

  void add(const std::string& box, double distance) {
    more += first.empty() ? 0 : 1;
    first = first.empty() ? box : first;
    distance_off_end = std::max(distance_off_end, distance);
  }
  void note(StaticResults& results) const {
    if (first.empty()) return;
    results.findings.push_back(Finding{
        FindingCode::pipe_off_rollers,
        fmt::format("the pipe has left '{}'{} over the side to {}: it lies up to {} beyond the ends of the bottom "
                    "rollers, which no longer hold it{}",
                    first, more > 0 ? fmt::format(" and {} more box{}", more, more > 1 ? "es" : "") : "", side,
                    shown(distance_off_end, "m", 2),
                    2 * (more + 1) > static_cast<int>(results.supports.size())
                        ? ". No equilibrium was found on most of its rollers: this is probably not the intended lay, "
                          "and a simulation may depart from it; check tension, current and the positions of the boxes"
                        : "")}
                                   .on(first)
                                   .with("distance", distance_off_end, "m")
                                   .with("boxes", more + 1, "1"));
  }
};

void note_extremes(StaticResults& results, const StaticSystem& system) {
  results.min_bottom_separation = results.supports.empty() ? 0.0 : kInfinity;
  for (const SupportResult& box : results.supports) {
    results.min_bottom_separation = std::min(results.min_bottom_separation, box.separation);
    for (const RowResult& row : box.rows) {
      for (const RollerResult& roller : row.rollers) {
        if (roller.reaction > results.max_reaction) {
          results.max_reaction = roller.reaction;
          results.max_reaction_support = box.name;
        }
      }
    }
  }
  for (int i = 0; i < system.rollers().count(); ++i) {
    results.roller_stiffness = std::max(results.roller_stiffness, system.rollers().roller(i).law.stiffness);
  }
  for (const RollerContact& contact : system.contacts()) {
    results.max_penetration = std::max(results.max_penetration, contact.penetration);
  }
}

}  // namespace

Departure recover_supports(StaticResults& results, const StaticSystem& system, const LineState& state) {
  const Model& model = system.model();
  Departure departure;
  departure.s = kInfinity;
  MissedBoxes to_port{"port"}, to_starboard{"starboard"};
  for (const SupportBox& box : model.supports.boxes) {
    const Axes axes{direction_from_ramp(model.mean_pose, box.direction_S),
                    direction_from_ramp(model.mean_pose, Vec3(0.0, -1.0, 0.0))};
    SupportResult result;
    result.name = box.name;
    result.stinger = box.structure == Structure::stinger;
    result.p_W = point_from_ramp(model, model.mean_pose, box.point_S);
    result.astern = box.point_S.x();
    result.inclination = box_dip(model.mean_pose, box);
    result.length = box.length;
    Vec3 force = Vec3::Zero();
    std::optional<double> off_end;
    double clearance = 0.0;
    for (int r = box.first_row; r < box.first_row + box.row_count; ++r) {
      RowResult row;
      const RowTotals totals = recover_row(row, model.supports.rows[static_cast<std::size_t>(r)], system, state, axes);
      force += totals.force;
      if (totals.distance_off_end && std::abs(*totals.distance_off_end) >= std::abs(off_end.value_or(0.0))) {
        off_end = totals.distance_off_end;
      }
      clearance = totals.clearance;
      if (totals.contact && totals.last_s < departure.s) {
        departure = {true, totals.last_s, box.name};
      }
      result.rows.push_back(row);
    }
    result.s = result.rows[result.rows.size() / 2].s;
    result.reaction = force.norm();
    result.vertical = force.z();
    result.longitudinal = force.dot(axes.along);
    result.lateral = force.dot(axes.port);
    find_min_separations(result);
    set_pipe_loads(result, results.stations);
    warn_of_runoff(results, result);
    if (off_end) (std::signbit(*off_end) ? to_starboard : to_port).add(box.name, std::abs(*off_end));
    if (result.stinger) results.stinger_tip_clearance = clearance;
    results.supports.push_back(std::move(result));
  }
  to_port.note(results);
  to_starboard.note(results);
  results.ramp_fitted_radius = fitted_radius(model.supports, Structure::ramp);
  results.stinger_fitted_radius = fitted_radius(model.supports, Structure::stinger);
  note_extremes(results, system);
  return departure;
}

}  // namespace overbend
