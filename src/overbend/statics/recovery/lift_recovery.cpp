#include "statics/recovery/lift_recovery.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "mechanics/ground.h"
#include "mechanics/rod_element.h"
#include "model/pipe/section.h"
#include "statics/recovery/lines_recovery.h"
#include "system/cut_forces.h"

namespace overbend {
namespace {

using Vec3Map = Eigen::Map<const Vec3>;

std::size_t to_size(int i) {
  return static_cast<std::size_t>(i);
}

double inclination_of(const Vec3& tangent) {
  return std::asin(std::clamp(-tangent.z(), -1.0, 1.0));
}

/// A line as it is solved.
struct Solved {
  const LineAssembly& assembly;
  const std::vector<double>& q;

  const Line& line() const { return assembly.line(); }
  Vec3 place(std::size_t node) const { return Vec3Map(q.data() + 6 * node); }
  Vec3 tangent(std::size_t node) const { return Vec3Map(q.data() + 6 * node + 3).normalized(); }
  LinePlace at_node(std::size_t node) const {
    return {line().mesh.s[node], place(node), inclination_of(tangent(node))};
  }
  CentrelinePoint at(std::size_t e, double share) const {
    const ElementVector of(Eigen::Map<const ElementVector>(q.data() + 6 * e));
    return centreline(of, share, line().mesh.length[e]);
  }
  LinePlace at_share(std::size_t e, double share) const {
    const CentrelinePoint point = at(e, share);
    return {line().mesh.s[e] + share * line().mesh.length[e], point.r, inclination_of(point.a.normalized())};
  }
  LinePlace at_arc(double s) const {
    const std::vector<double>& nodes = line().mesh.s;
    const auto above = std::upper_bound(nodes.begin(), nodes.end() - 1, s);
    const auto e = static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - nodes.begin() - 1, 0));
    return at_share(e, (s - nodes[e]) / line().mesh.length[e]);
  }
};

/// Of a place on an element, whose number comes first.
using PlaceValue = std::function<double(std::size_t, const Vec3&)>;

/// Share of an element at which a value changes its sign.
double crossing(const Solved& line, std::size_t e, const PlaceValue& value) {
  double low = 0.0, high = 1.0;
  const bool rises = value(e, line.at(e, 0.0).r) < 0.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    ((value(e, line.at(e, middle).r) < 0.0) == rises ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Arc lengths at which a value changes its sign, within an element or where it jumps between two.
std::vector<double> crossings(const Solved& line, const PlaceValue& value) {
  std::vector<double> found;
  const std::vector<double>& s = line.line().mesh.s;
  bool below = value(0, line.place(0)) < 0.0;
  for (std::size_t e = 0; e + 1 < s.size(); ++e) {
    const bool first = value(e, line.place(e)) < 0.0, second = value(e, line.place(e + 1)) < 0.0;
    if (first != below) found.push_back(s[e]);
    if (second != first) found.push_back(s[e] + crossing(line, e, value) * line.line().mesh.length[e]);
    below = second;
  }
  return found;
}

LiftedNode node_of(const Solved& line, std::size_t node) {
  const CutForces cut = cut_at_node(line.assembly.cuts(), line.q, node);
  const Vec3 tangent = line.tangent(node), up = up_across(tangent);
  LiftedNode out;
  out.at = line.at_node(node);
  out.tension = cut.force.dot(tangent);
  out.shear = cut.force.dot(up);
  out.sagging = cut.moment.dot(tangent.cross(up));
  out.sideways = cut.moment.dot(up);
  return out;
}

/// The largest of a value along a line; between nodes by a parabola, where no other line makes a kink.
MomentPlace largest(const Solved& line, const std::vector<LiftedNode>& nodes, const std::vector<bool>& kinks,
                    const std::function<double(const LiftedNode&)>& value) {
  std::size_t most = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (value(nodes[i]) > value(nodes[most])) most = i;
  }
  MomentPlace out{value(nodes[most]), nodes[most].at};
  if (most == 0 || most + 1 == nodes.size() || kinks[most]) return out;
  const double h1 = nodes[most].at.arc_length - nodes[most - 1].at.arc_length;
  const double h2 = nodes[most + 1].at.arc_length - nodes[most].at.arc_length;
  const double a = (value(nodes[most]) - value(nodes[most - 1])) / h1;
  const double b = (value(nodes[most + 1]) - value(nodes[most])) / h2;
  const double bend = (b - a) / (h1 + h2);
  if (!(bend < 0.0)) return out;
  const double slope = (a * h2 + b * h1) / (h1 + h2);
  const double step = std::clamp(-0.5 * slope / bend, -h1, h2);
  out.value += step * (slope + bend * step);
  out.at = line.at_arc(nodes[most].at.arc_length + step);
  return out;
}

double bending_of(const LiftedNode& node) {
  return std::hypot(node.sagging, node.sideways);
}

/// Stresses of the pipe at the nodes of a line: on either side of a change of section the larger use of the steel.
void find_stresses(const Model& model, const FreeLineDescription& description, const LineMesh& mesh,
                   std::vector<LiftedNode>& nodes) {
  const double water = model.description.environment.water_weight_density;
  for (std::size_t i = 0; i < description.segments.size(); ++i) {
    const LineSegmentDescription& segment = description.segments[i];
    if (!segment.section) continue;
    const Section pipe = derive_section(segment.name, *segment.section, water);
    for (std::size_t e = 0; e < mesh.length.size(); ++e) {
      if (to_size(mesh.section[e]) != i) continue;
      for (const std::size_t node : {e, e + 1}) {
        const double stress = bending_of(nodes[node]) * 0.5 * pipe.steel_diameter / pipe.second_moment;
        const bool used = nodes[node].yield_stress > 0.0;
        if (used && stress / pipe.yield_stress < nodes[node].stress / nodes[node].yield_stress) continue;
        nodes[node].stress = stress;
        nodes[node].yield_stress = pipe.yield_stress;
        nodes[node].wall_area = pipe.steel_area;
      }
    }
  }
}

/// Whether anything holds an end; a weld holds one that was free.
bool is_held(const System& system, std::size_t line, LineEnd which) {
  const std::optional<std::size_t> held = find_attachment(system, line, which);
  return held && system.attachments[*held].hold_place;
}

LiftedEnd end_of(const Solved& line, bool held, LineEnd which) {
  const std::size_t node = to_size(line.assembly.end_node(which));
  const Vec3 force = Vec3Map(line.assembly.end_force(which).data());
  const double outwards = which == LineEnd::last ? 1.0 : -1.0;
  LiftedEnd out;
  out.free = !held;
  out.at = line.at_node(node);
  if (out.free) return out;
  const Vec3 tangent = line.tangent(node);
  out.tension = outwards * force.dot(tangent);
  out.horizontal_force = outwards * force.head<2>().dot(tangent.head<2>().normalized());
  out.vertical_force = force.z();
  return out;
}

void find_bed(const Solved& line, LiftedLine& out) {
  const LineEnvironment& around = line.line().environment;
  const auto above = [&](std::size_t e, const Vec3& r) {
    return bed_clearance(around, r) - line.line().elements.radius[e];
  };
  std::vector<double> ends = crossings(line, above);
  const double length = line.line().mesh.total_length();
  if (above(0, line.place(0)) < 0.0) ends.insert(ends.begin(), 0.0);
  if (ends.size() % 2 == 1) ends.push_back(length);
  double lies = 0.0;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
    out.on_bed.push_back({ends[i], ends[i + 1]});
    lies += ends[i + 1] - ends[i];
  }
  out.suspended_length = length - lies;
  if (out.on_bed.empty()) return;
  const bool from_second = out.second.free && !out.first.free;
  out.lift_off = line.at_arc(from_second ? out.on_bed.back().to : out.on_bed.front().from);
}

/// Nodes at which others are attached.
std::vector<bool> kinks_of(const System& system, int line, std::size_t nodes) {
  std::vector<bool> kinks(nodes, false);
  for (const Attachment& held : system.attachments) {
    if (held.line == line && held.end == LineEnd::inner) kinks[to_size(held.node)] = true;
  }
  return kinks;
}

LiftedLine recover_line(const Model& model, const LinkedLines& lines, std::size_t i) {
  const FreeLineDescription& description = model.description.lines[i];
  const int index = lines.setup().lines[i];
  const Solved line{lines.assembly().line(to_size(index)), lines.state().lines[to_size(index)].q};
  LiftedLine out;
  out.name = description.name;
  const System& system = lines.setup().system;
  out.first = end_of(line, is_held(system, to_size(index), LineEnd::first), LineEnd::first);
  out.second = end_of(line, is_held(system, to_size(index), LineEnd::last), LineEnd::last);
  for (std::size_t node = 0; node < line.line().mesh.s.size(); ++node) out.nodes.push_back(node_of(line, node));
  const std::vector<bool> kinks = kinks_of(lines.setup().system, index, out.nodes.size());
  out.sagging = largest(line, out.nodes, kinks, [](const LiftedNode& node) { return node.sagging; });
  out.hogging = largest(line, out.nodes, kinks, [](const LiftedNode& node) { return -node.sagging; });
  out.bending = largest(line, out.nodes, kinks, bending_of);
  const auto by_tension = [](const LiftedNode& a, const LiftedNode& b) { return a.tension < b.tension; };
  const auto [least, most] = std::ranges::minmax_element(out.nodes, by_tension);
  out.least_tension = least->tension;
  out.largest_tension = most->tension;
  find_stresses(model, description, line.line().mesh, out.nodes);
  const MomentPlace stress = largest(line, out.nodes, kinks, [](const LiftedNode& node) { return node.stress; });
  out.bending_stress = stress.value;
  find_bed(line, out);
  out.water_crossings = crossings(line, [](std::size_t, const Vec3& r) { return r.z(); });
  return out;
}

double from_vertical(const Vec3& direction) {
  return std::atan2(direction.head<2>().norm(), std::abs(direction.z()));
}

/// What a wire, or a line with weight, pulls its ends by.
struct Pull {
  double first_tension = 0.0, second_tension = 0.0;
  Vec3 first = Vec3::Zero(), second = Vec3::Zero();  ///< On what holds its ends [N].
  Vec3 first_direction = Vec3::UnitZ(), second_direction = Vec3::UnitZ();
  double first_height = 0.0, second_height = 0.0;
};

Pull pull_of(const LinkedLines& lines, std::size_t i) {
  if (lines.setup().wires[i] >= 0) {
    const WirePull& wire = lines.assembly().wires()[to_size(lines.setup().wires[i])];
    const Vec3 along = wire.second - wire.first;
    return {wire.tension, wire.tension, wire.force, -wire.force, along, along, wire.first.z(), wire.second.z()};
  }
  const std::size_t index = to_size(lines.setup().lines[i]);
  const Solved line{lines.assembly().line(index), lines.state().lines[index].q};
  const std::size_t last = line.line().mesh.s.size() - 1;
  const Vec3 first = -Vec3Map(line.assembly.end_force(LineEnd::first).data());
  const Vec3 second = -Vec3Map(line.assembly.end_force(LineEnd::last).data());
  return {first.norm(), second.norm(), first, second, first, second, line.place(0).z(), line.place(last).z()};
}

Solved solved_line(const Model& model, const LinkedLines& lines, const std::string& name) {
  const auto& all = model.description.lines;
  const auto found = std::ranges::find(all, name, &FreeLineDescription::name);
  const std::size_t index = to_size(lines.setup().lines[static_cast<std::size_t>(found - all.begin())]);
  return {lines.assembly().line(index), lines.state().lines[index].q};
}

/// Of the line that it is on, whatever its length is now.
int attached_node(const Model& model, const Solved& line, const LineEndDescription& end) {
  const auto& all = model.description.lines;
  const auto on = std::ranges::find(all, end.line, &FreeLineDescription::name);
  const double drawn = CableParts{on->segments, on->points}.length();
  return node_at(line.line().mesh, end.arc_length * line.line().mesh.total_length() / drawn);
}

LiftedWire recover_wire(const Model& model, const LinkedLines& lines, std::size_t i) {
  const FreeLineDescription& description = model.description.lines[i];
  const Pull pull = pull_of(lines, i);
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
  const Solved line = solved_line(model, lines, end.line);
  const int node = attached_node(model, line, end);
  const Vec3 tangent = line.tangent(to_size(node)), up = up_across(tangent);
  const Vec3 before = cut_at_node(line.assembly.cuts(), line.q, to_size(node)).force;
  const Vec3 behind = before - Vec3Map(line.assembly.held_force(node).data());
  const LiftedNode there = node_of(line, to_size(node));
  out.at = there.at;
  out.moment = there.sagging;
  out.tension_before = before.dot(tangent);
  out.tension_after = behind.dot(tangent);
  out.shear_before = before.dot(up);
  out.shear_after = behind.dot(up);
  return out;
}

WeldGap gap_of(const Model& model, const LinkedLines& lines, const JoinDescription& join) {
  const Solved first = solved_line(model, lines, join.first), second = solved_line(model, lines, join.second);
  const Vec3 apart = second.place(0) - first.place(0);
  const Vec3 along = -first.tangent(0), on = second.tangent(0);
  const double turn = std::acos(std::clamp(along.dot(on), -1.0, 1.0));
  return {apart.x(), apart.y(), apart.z(), std::copysign(turn, on.dot(up_across(along)))};
}

Weld weld_of(const Model& model, const LinkedLines& lines, const JoinDescription& join) {
  const Solved first = solved_line(model, lines, join.first);
  const Vec3 along = -first.tangent(0);
  const Vec3 force = Vec3Map(first.assembly.held_force(0).data());
  Weld weld;
  weld.at = first.at_node(0);
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

/// A straight wire by its two ends.
LineResult result_of_wire(const Model& model, const LinkedLines& lines, std::size_t i) {
  const Pull pull = pull_of(lines, i);
  const WirePull& wire = lines.assembly().wires()[to_size(lines.setup().wires[i])];
  const Vec3 along = (wire.second - wire.first).normalized();
  LineResult line;
  line.name = model.description.lines[i].name;
  line.length = lines.position().lengths[i];
  line.elements = 1;
  line.largest_tension = line.least_tension = pull.first_tension;
  line.first = end_result(-pull.first, pull.first_tension, -along);
  line.second = end_result(-pull.second, pull.second_tension, along);
  line.nodes = {{0.0, wire.first, pull.first_tension}, {line.length, wire.second, pull.second_tension}};
  return line;
}

}  // namespace

std::vector<LineResult> recover_linked_lines(const Model& model, const LinkedLines& lines) {
  std::vector<LineResult> results;
  for (std::size_t i = 0; i < model.description.lines.size(); ++i) {
    const int index = lines.setup().lines[i];
    results.push_back(index < 0 ? result_of_wire(model, lines, i)
                                : recover_line_result(model.description.lines[i], lines.assembly().line(to_size(index)),
                                                      lines.state().lines[to_size(index)].q));
    LineResult& line = results.back();
    line.residual = lines.residual();
    line.iterations = lines.iterations();
    for (const auto& [which, result] : {std::pair{LineEnd::first, &line.first}, {LineEnd::last, &line.second}}) {
      if (index < 0 || is_held(lines.setup().system, to_size(index), which)) continue;
      result->tension = result->force.setZero().norm();
    }
    for (const LineSegmentDescription& segment : model.description.lines[i].segments) {
      if (index >= 0 || !segment.type.breaking_load) continue;
      line.utilisation = std::max(line.utilisation.value_or(0.0), line.largest_tension / *segment.type.breaking_load);
    }
  }
  return results;
}

LiftResults recover_lift(const Model& model, const LinkedLines& lines, const JoinDescription* next) {
  LiftResults results;
  for (std::size_t i = 0; i < model.description.lines.size(); ++i) {
    const FreeLineDescription& line = model.description.lines[i];
    if (has_pipe_section(line)) results.lines.push_back(recover_line(model, lines, i));
    const bool on_another = line.first.kind == LineEndKind::line || line.second.kind == LineEndKind::line;
    if (on_another && !has_pipe_section(line)) results.davits.push_back(recover_wire(model, lines, i));
  }
  for (const LiftedWire& wire : results.davits) {  // the tension of a node is that of one of its sides
    for (LiftedLine& line : results.lines) {
      if (line.name != wire.on) continue;
      line.largest_tension = std::max({line.largest_tension, wire.tension_before, wire.tension_after});
      line.least_tension = std::min({line.least_tension, wire.tension_before, wire.tension_after});
    }
  }
  if (next != nullptr) results.gap = gap_of(model, lines, *next);
  if (!lines.position().joins.empty()) results.join = weld_of(model, lines, lines.position().joins.back());
  results.residual = lines.residual();
  results.iterations = lines.iterations();
  return results;
}

}  // namespace overbend
