#include "statics/recovery/recovery_attachments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "model/pipe_attachments.h"

namespace overbend {
namespace {

using Vec3Map = Eigen::Map<const Vec3>;

AttachedPlace recover_place(const StaticSystem& system, const LineState& state, const std::vector<CutForces>& cuts,
                            int node) {
  const auto i = static_cast<std::size_t>(node);
  const Vec3 tangent = Vec3Map(state.q.data() + 6 * i + 3).normalized(), up = up_across(tangent);
  const Vec3 after = cuts[i].force, before = after - attached_force(system, state, node);
  AttachedPlace place;
  place.from_top = system.mesh().total_length() - system.mesh().s[i];
  place.p_W = Vec3Map(state.q.data() + 6 * i);
  const Vec3 shoe = point_from_ramp(system.model(), system.model().mean_pose, Vec3::Zero());
  place.astern = (place.p_W - shoe).dot(system.plane().astern_W);
  place.inclination = std::asin(std::clamp(tangent.z(), -1.0, 1.0));
  place.moment = cuts[i].moment.dot(tangent.cross(up));
  place.tension_before = before.dot(tangent);
  place.tension_after = after.dot(tangent);
  place.shear_before = -before.dot(up);
  place.shear_after = -after.dot(up);
  return place;
}

std::optional<double> breaking_load(const FreeLineDescription& line) {
  std::optional<double> min_load;
  for (const LineSegmentDescription& segment : line.segments) {
    const std::optional<double>& load = segment.type.breaking_load;
    if (load) min_load = std::min(min_load.value_or(*load), *load);
  }
  return min_load;
}

PipeWireResult recover_wire(const FreeLineDescription& line, const LineWire& wire, const WirePull& pull,
                            const Vec3& astern) {
  PipeWireResult out;
  out.name = line.name;
  out.length = wire.wire.length;
  const Vec3 along = pull.second - pull.first;
  const bool far_above = pull.first.z() >= pull.second.z();
  const Vec3 far = pull.tension > 0.0 ? pull.force : along, near = pull.tension > 0.0 ? pull.on_second : along;
  const auto from_vertical = [](const Vec3& direction) {
    return std::atan2(direction.head<2>().norm(), std::abs(direction.z()));
  };
  out.tension_upper = far_above ? pull.force.norm() : pull.on_second.norm();
  out.tension_lower = far_above ? pull.on_second.norm() : pull.force.norm();
  out.from_vertical_upper = from_vertical(far_above ? far : near);
  out.from_vertical_lower = from_vertical(far_above ? near : far);
  out.force = pull.on_second;
  out.force_astern = out.force.dot(astern);
  out.far_W = pull.first;
  if (const auto load = breaking_load(line)) out.utilisation = std::max(out.tension_upper, out.tension_lower) / *load;
  return out;
}

/// End results of a line; forces are those of the attachments on the line.
LineEndResult end_result(const Vec3& pull, const Vec3& outwards) {
  LineEndResult end;
  end.force = -pull;
  end.tension = pull.norm();
  end.declination = std::asin(std::clamp(outwards.z(), -1.0, 1.0));
  return end;
}

/// Results as a line between its ends, in the order of the model.
LineResult line_result(const PipeWireResult& wire, const WirePull& pull, bool reversed) {
  const Vec3 first = reversed ? pull.second : pull.first, second = reversed ? pull.first : pull.second;
  const Vec3 on_first = reversed ? pull.on_second : pull.force, on_second = reversed ? pull.force : pull.on_second;
  const Vec3 along = (second - first).normalized();
  LineResult line;
  line.name = wire.name;
  line.length = wire.length;
  line.elements = 1;
  line.utilisation = wire.utilisation;
  line.first = end_result(on_first, on_first.norm() > 0.0 ? Vec3(-on_first.normalized()) : Vec3(-along));
  line.second = end_result(on_second, on_second.norm() > 0.0 ? Vec3(-on_second.normalized()) : along);
  line.max_tension = std::max(line.first.tension, line.second.tension);
  line.min_tension = std::min(line.first.tension, line.second.tension);
  line.nodes = {{0.0, first, line.first.tension}, {wire.length, second, line.second.tension}};
  return line;
}

}  // namespace

Vec3 attached_force(const StaticSystem& system, const LineState& state, std::optional<int> node) {
  Vec3 sum = Vec3::Zero();
  for (const LinePoint& point : system.line().points) {
    if (!node || point.node == *node) sum += point_force(point, system.environment(), state.q.data());
  }
  for (std::size_t i = 0; i < system.line().wires.size(); ++i) {
    if (!node || system.line().wires[i].node == *node) sum += system.wire_pulls()[i].on_second;
  }
  return sum;
}

bool holds_something(const StaticSystem& system, int node) {
  return ranges::any_of(system.line().points, [node](const LinePoint& point) { return point.node == node; }) ||
         ranges::any_of(system.line().wires, [node](const LineWire& wire) { return wire.node == node; });
}

void recover_attachments(StaticResults& results, const StaticSystem& system, const LineState& state,
                         const std::vector<CutForces>& cuts) {
  const Line& line = system.line();
  for (const PipeAttachment& attached : pipe_attachments(system.model().description)) {
    if (attached.from_top >= line.mesh.total_length()) continue;
    if (attached.point != nullptr) {
      const LinePoint& point = line.points[results.points.size()];
      results.points.push_back({attached.point->name, recover_place(system, state, cuts, point.node),
                                point_force(point, system.environment(), state.q.data())});
    } else {
      const std::size_t i = results.wires.size();
      results.wires.push_back(
          recover_wire(*attached.line, line.wires[i], system.wire_pulls()[i], system.plane().astern_W));
      results.wires.back().location = recover_place(system, state, cuts, line.wires[i].node);
      results.lines.push_back(line_result(results.wires.back(), system.wire_pulls()[i], line.wires[i].reversed));
    }
  }
}

void warn_of_attachments(StaticResults& results) {
  for (const PipeWireResult& wire : results.wires) {
    if (wire.tension_upper <= 0.0) {
      results.findings.push_back(
          Finding{FindingCode::davit_slack, fmt::format("line \"{}\": slack, it does not hold the pipe", wire.name)}.on(
              "line " + wire.name));
    }
    if (wire.utilisation.value_or(0.0) <= 1.0) continue;
    results.findings.push_back(Finding{FindingCode::breaking_load_exceeded,
                                       fmt::format("line \"{}\": its tension, {}, is {:.2f} times its "
                                                   "breaking load",
                                                   wire.name, shown(wire.tension_upper, "N", 1), *wire.utilisation)}
                                   .on("line " + wire.name)
                                   .with("tension", wire.tension_upper, "N"));
  }
}

}  // namespace overbend
