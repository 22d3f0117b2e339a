#include "statics/recovery/lift_recovery.h"

#include <algorithm>
#include <cmath>

#include "base/ranges.h"
#include "statics/recovery/lifted_line.h"
#include "statics/recovery/lines_recovery.h"
#include "system/cut_forces.h"

namespace overbend {
namespace {

using Vec3Map = Eigen::Map<const Vec3>;

std::size_t to_size(int i) {
  return static_cast<std::size_t>(i);
}

SolvedLines solved_lines(const Model& model, const LinkedLines& lines) {
  return {model, lines.setup(), lines.assembly(), lines.state()};
}

double from_vertical(const Vec3& direction) {
  return std::atan2(direction.head<2>().norm(), std::abs(direction.z()));
}

/// Forces of a wire, or a line with weight, on its ends.
struct Pull {
  double first_tension = 0.0, second_tension = 0.0;
  Vec3 first = Vec3::Zero(), second = Vec3::Zero();  ///< Force on the attachments of its ends [N].
  Vec3 first_direction = Vec3::UnitZ(), second_direction = Vec3::UnitZ();
  double first_height = 0.0, second_height = 0.0;
};

Pull compute_pull(const LinkedLines& lines, std::size_t i) {
  if (lines.setup().wires[i] >= 0) {
    const WirePull& wire = lines.assembly().wires()[to_size(lines.setup().wires[i])];
    const Vec3 along = wire.second - wire.first;
    return {wire.tension, wire.tension, wire.force, -wire.force, along, along, wire.first.z(), wire.second.z()};
  }
  const std::size_t index = to_size(lines.setup().lines[i]);
  const SolvedLine line{lines.assembly().line(index), lines.state().lines[index].q};
  const std::size_t last = line.line().mesh.s.size() - 1;
  const Vec3 first = -Vec3Map(line.assembly.end_force(LineEnd::first).data());
  const Vec3 second = -Vec3Map(line.assembly.end_force(LineEnd::last).data());
  return {first.norm(), second.norm(), first, second, first, second, line.place(0).z(), line.place(last).z()};
}

SolvedLine solved_line(const Model& model, const LinkedLines& lines, const std::string& name) {
  const auto& all = model.description.lines;
  const auto found = ranges::find(all, name, &FreeLineDescription::name);
  return solved_lines(model, lines).line(static_cast<std::size_t>(found - all.begin()));
}

/// Node of an attachment on the line that carries it, at any present length of that line.
int attached_node(const Model& model, const SolvedLine& line, const LineEndDescription& end) {
  const auto& all = model.description.lines;
  const auto on = ranges::find(all, end.line, &FreeLineDescription::name);
  const double drawn = CableParts{on->segments, on->points}.length();
  return node_at(line.line().mesh, end.arc_length * line.line().mesh.total_length() / drawn);
}

LiftedWire recover_wire(const Model& model, const LinkedLines& lines, std::size_t i) {
  const FreeLineDescription& description = model.description.lines[i];
  const Pull pull = compute_pull(lines, i);
  const bool first_upper = pull.first_height >= pull.second_height;
  const bool second_on = description.second.kind == LineEndKind::line;
  const LineEndDescription& end = second_on ? description.second : description.first;
  LiftedWire out;
  out.name = description.name;
  out.on = end.line;
  out.length = lines.position().lengths[i];
  out.tension_upper = first_upper ? pull.first_tension : pull.second_tension;
  out.tension_lower = first_upper ? pull.second_tension : pull.first_tension;
  out.from_vertical_upper = from_vertical(first_upper ? pull.first_direction : pull.second_direction);
  out.from_vertical_lower = from_vertical(first_upper ? pull.second_direction : pull.first_direction);
  out.force = second_on ? pull.second : pull.first;
  for (const LineSegmentDescription& segment : description.segments) {
    if (!segment.type.breaking_load) continue;
    out.utilisation = std::max(out.utilisation.value_or(0.0), out.tension_upper / *segment.type.breaking_load);
  }
  const SolvedLine line = solved_line(model, lines, end.line);
  const int node = attached_node(model, line, end);
  const Vec3 tangent = line.tangent(to_size(node)), up = up_across(tangent);
  const Vec3 before = cut_at_node(line.assembly.cuts(), line.q, to_size(node)).force;
  const Vec3 behind = before - Vec3Map(line.assembly.held_force(node).data());
  const LiftedNode lifted = lifted_node(line, to_size(node), before);
  out.location = lifted.location;
  out.moment = lifted.sagging;
  out.tension_before = before.dot(tangent);
  out.tension_after = behind.dot(tangent);
  out.shear_before = before.dot(up);
  out.shear_after = behind.dot(up);
  return out;
}

WeldGap compute_gap(const Model& model, const LinkedLines& lines, const JoinDescription& join) {
  const SolvedLine first = solved_line(model, lines, join.first), second = solved_line(model, lines, join.second);
  const Vec3 apart = second.place(0) - first.place(0);
  const Vec3 along = -first.tangent(0), on = second.tangent(0);
  const double turn = std::acos(std::clamp(along.dot(on), -1.0, 1.0));
  return {apart.x(), apart.y(), apart.z(), std::copysign(turn, on.dot(up_across(along)))};
}

Weld compute_weld(const Model& model, const LinkedLines& lines, const JoinDescription& join) {
  const SolvedLine first = solved_line(model, lines, join.first);
  const Vec3 along = -first.tangent(0);
  const Vec3 force = Vec3Map(first.assembly.held_force(0).data());
  Weld weld;
  weld.location = first.at_node(0);
  weld.tension = force.dot(along);
  weld.shear = force.dot(up_across(along));
  const Vec3 turned = first.tangent(0).cross(Vec3Map(first.assembly.held_force(0).data() + 3));
  weld.moment = -turned.dot(first.tangent(0).cross(up_across(first.tangent(0))));
  return weld;
}

LineEndResult end_result(const Vec3& force, double tension, const Vec3& outwards) {
  LineEndResult end;
  end.force = force;
  end.tension = tension;
  end.declination = std::asin(std::clamp(outwards.z(), -1.0, 1.0));
  return end;
}

/// Results of a straight wire from its two ends.
LineResult make_wire_result(const Model& model, const LinkedLines& lines, std::size_t i) {
  const Pull pull = compute_pull(lines, i);
  const WirePull& wire = lines.assembly().wires()[to_size(lines.setup().wires[i])];
  const Vec3 along = (wire.second - wire.first).normalized();
  LineResult line;
  line.name = model.description.lines[i].name;
  line.length = lines.position().lengths[i];
  line.elements = 1;
  line.max_tension = line.min_tension = pull.first_tension;
  line.first = end_result(-pull.first, pull.first_tension, -along);
  line.second = end_result(-pull.second, pull.second_tension, along);
  line.nodes = {{0.0, wire.first, pull.first_tension}, {line.length, wire.second, pull.second_tension}};
  return line;
}

}  // namespace

std::vector<LineResult> recover_linked_lines(const Model& model, const LinkedLines& lines) {
  std::vector<LineResult> results;
  const std::vector<LiftedLine> pipe = recover_pipe_lines(solved_lines(model, lines));
  for (std::size_t i = 0; i < model.description.lines.size(); ++i) {
    const int index = lines.setup().lines[i];
    results.push_back(index < 0 ? make_wire_result(model, lines, i)
                                : recover_line_result(model.description.lines[i], lines.assembly().line(to_size(index)),
                                                      lines.state().lines[to_size(index)].q));
    LineResult& line = results.back();
    for (const LiftedLine& bent : pipe) {  // on both sides of its attachments
      if (bent.name != line.name) continue;
      line.max_tension = bent.max_tension;
      line.min_tension = bent.min_tension;
    }
    line.residual = lines.residual();
    line.iterations = lines.iterations();
    for (const auto& [which, result] : {std::pair{LineEnd::first, &line.first}, {LineEnd::last, &line.second}}) {
      if (index < 0 || is_held(lines.setup().system, index, which)) continue;
      result->tension = result->force.setZero().norm();
    }
    for (const LineSegmentDescription& segment : model.description.lines[i].segments) {
      if (index >= 0 || !segment.type.breaking_load) continue;
      line.utilisation = std::max(line.utilisation.value_or(0.0), line.max_tension / *segment.type.breaking_load);
    }
  }
  return results;
}

LiftResults recover_lift(const Model& model, const LinkedLines& lines, const JoinDescription* next) {
  LiftResults results;
  results.lines = recover_pipe_lines(solved_lines(model, lines));
  for (std::size_t i = 0; i < model.description.lines.size(); ++i) {
    const FreeLineDescription& line = model.description.lines[i];
    const bool on_another = line.first.kind == LineEndKind::line || line.second.kind == LineEndKind::line;
    if (on_another && !has_pipe_section(line)) results.davits.push_back(recover_wire(model, lines, i));
  }
  if (next != nullptr) results.gap = compute_gap(model, lines, *next);
  if (!lines.position().joins.empty()) results.join = compute_weld(model, lines, lines.position().joins.back());
  results.residual = lines.residual();
  results.iterations = lines.iterations();
  return results;
}

}  // namespace overbend
