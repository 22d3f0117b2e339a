#include "statics/recovery/lifted_line.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/ranges.h"
#include "mechanics/ground.h"
#include "mechanics/rod_element.h"
#include "mechanics/stress.h"
#include "model/pipe/section.h"
#include "system/cut_forces.h"
#include "system/line_points.h"

namespace overbend {
namespace {

using Vec3Map = Eigen::Map<const Vec3>;

std::size_t to_size(int i) {
  return static_cast<std::size_t>(i);
}

double inclination(const Vec3& tangent) {
  return std::asin(std::clamp(-tangent.z(), -1.0, 1.0));
}

CentrelinePoint point_on(const SolvedLine& line, std::size_t e, double share) {
  const ElementVector unknowns(Eigen::Map<const ElementVector>(line.q.data() + 6 * e));
  return centreline(unknowns, share, line.line().mesh.length[e]);
}

/// Value at a point of an element, with the element's index.
using PlaceValue = std::function<double(std::size_t, const Vec3&)>;

/// Share of an element at which a value changes its sign.
double crossing(const SolvedLine& line, std::size_t e, const PlaceValue& value) {
  double low = 0.0, high = 1.0;
  const bool rises = value(e, point_on(line, e, 0.0).r) < 0.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    ((value(e, point_on(line, e, middle).r) < 0.0) == rises ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Arc lengths at which a value changes its sign, within an element or by a jump between two.
std::vector<double> crossings(const SolvedLine& line, const PlaceValue& value) {
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

/// Forces of attachments, clumps and buoys on the nodes between the ends [N].
std::vector<Vec3> outer_forces(const SolvedLine& line, const System& system, int index) {
  std::vector<double> residual(line.q.size(), 0.0);
  add_point_forces(line.line().points, line.assembly.environment(), line.q.data(), {}, residual.data(), nullptr);
  std::vector<Vec3> forces;
  for (std::size_t node = 0; node < line.line().mesh.s.size(); ++node) {
    forces.emplace_back(-Vec3Map(residual.data() + 6 * node));
  }
  for (const Attachment& held : system.attachments) {
    if (held.line != index || held.end != LineEnd::inner) continue;
    forces[to_size(held.node)] += Vec3Map(line.assembly.held_force(held.node).data());
  }
  return forces;
}

/// Nodes of a line; both sides if values jump.
struct NodeList {
  std::vector<LiftedNode> nodes;
  std::vector<bool> two_sided;

  void add(LiftedNode node, int segment, bool of_two) {
    node.segment = segment;
    nodes.push_back(node);
    two_sided.push_back(of_two);
  }
};

NodeList list_nodes(const SolvedLine& line, const std::vector<Vec3>& outer) {
  NodeList list;
  const std::vector<int>& segment = line.line().mesh.section;
  const std::size_t last = segment.size();
  for (std::size_t node = 0; node <= last; ++node) {
    const Vec3 force = cut_at_node(line.assembly.cuts(), line.q, node).force;
    const int before = segment[node > 0 ? node - 1 : 0], behind = segment[std::min(node, last - 1)];
    const bool inner = node > 0 && node < last;
    const bool jumps = inner && (before != behind || !outer[node].isZero(0.0));
    list.add(lifted_node(line, node, force), before, jumps);
    if (jumps) list.add(lifted_node(line, node, force - outer[node]), behind, true);
  }
  return list;
}

/// Maximum of a value along a line; interpolated between nodes by a parabola if nothing jumps.
MomentPlace find_maximum(const SolvedLine& line, const NodeList& list,
                         const std::function<double(const LiftedNode&)>& value) {
  const std::vector<LiftedNode>& nodes = list.nodes;
  std::size_t max_index = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (value(nodes[i]) > value(nodes[max_index])) max_index = i;
  }
  MomentPlace out{value(nodes[max_index]), nodes[max_index].location};
  if (max_index == 0 || max_index + 1 == nodes.size() || list.two_sided[max_index]) return out;
  const double h1 = nodes[max_index].location.arc_length - nodes[max_index - 1].location.arc_length;
  const double h2 = nodes[max_index + 1].location.arc_length - nodes[max_index].location.arc_length;
  const double a = (value(nodes[max_index]) - value(nodes[max_index - 1])) / h1;
  const double b = (value(nodes[max_index + 1]) - value(nodes[max_index])) / h2;
  const double bend = (b - a) / (h1 + h2);
  if (!(bend < 0.0)) return out;
  const double slope = (a * h2 + b * h1) / (h1 + h2);
  const double step = std::clamp(-0.5 * slope / bend, -h1, h2);
  out.value += step * (slope + bend * step);
  out.location = line.at_arc(nodes[max_index].location.arc_length + step);
  return out;
}

double bending_moment(const LiftedNode& node) {
  return std::hypot(node.sagging, node.sideways);
}

void set_stress(const Section& pipe, double water_weight_density, LiftedNode& node) {
  SectionLoads loads;
  loads.effective_tension = node.tension;
  loads.bending_moment = bending_moment(node);
  loads.curvature = loads.bending_moment / pipe.EI;
  loads.z = node.location.place.z();
  loads.external_pressure = water_weight_density * std::max(-loads.z, 0.0);
  loads.internal_pressure = pressure_on_bore(pipe, loads.z);
  const SectionStress stress = section_stress(pipe, loads);
  node.stress = stress.bending;
  node.yield_stress = pipe.yield_stress;
  node.von_mises = stress.von_mises;
  node.strain = stress.strain;
}

/// Stresses of the pipe at the nodes of a line, by the section of each side. Lines are linear elastic.
void find_stresses(const Model& model, const FreeLineDescription& description, std::vector<LiftedNode>& nodes) {
  const double water = model.description.environment.water_weight_density;
  std::vector<std::optional<Section>> sections;
  for (const LineSegmentDescription& segment : description.segments) {
    std::optional<Section>& pipe = sections.emplace_back();
    if (!segment.section) continue;
    pipe = derive_section(segment.name, *segment.section, water);
    pipe->bending.reset();
  }
  for (LiftedNode& node : nodes) {
    if (const std::optional<Section>& pipe = sections[to_size(node.segment)]) set_stress(*pipe, water, node);
  }
}

LiftedEnd recover_end(const SolvedLine& line, bool held, LineEnd which) {
  const std::size_t node = to_size(line.assembly.end_node(which));
  const Vec3 force = Vec3Map(line.assembly.end_force(which).data());
  const double outwards = which == LineEnd::last ? 1.0 : -1.0;
  LiftedEnd out;
  out.free = !held;
  out.location = line.at_node(node);
  if (out.free) return out;
  const Vec3 tangent = line.tangent(node);
  out.tension = outwards * force.dot(tangent);
  out.horizontal_force = outwards * force.head<2>().dot(tangent.head<2>().normalized());
  out.vertical_force = force.z();
  return out;
}

void find_bed(const SolvedLine& line, LiftedLine& out) {
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

void find_extremes(const SolvedLine& line, NodeList& list, LiftedLine& out) {
  out.sagging = find_maximum(line, list, [](const LiftedNode& node) { return node.sagging; });
  out.hogging = find_maximum(line, list, [](const LiftedNode& node) { return -node.sagging; });
  out.bending = find_maximum(line, list, bending_moment);
  out.bending_stress = find_maximum(line, list, [](const LiftedNode& node) { return node.stress; }).value;
  out.von_mises = find_maximum(line, list, [](const LiftedNode& node) { return node.von_mises; }).value;
  const auto [lowest, highest] = ranges::minmax_element(list.nodes, {}, &LiftedNode::tension);
  out.min_tension = lowest->tension;
  out.max_tension = highest->tension;
}

LiftedLine recover_line(const SolvedLines& lines, std::size_t number) {
  const FreeLineDescription& description = lines.model.description.lines[number];
  const SolvedLine line = lines.line(number);
  LiftedLine out;
  out.name = description.name;
  const int index = lines.setup.lines[number];
  out.first = recover_end(line, is_held(lines.setup.system, index, LineEnd::first), LineEnd::first);
  out.second = recover_end(line, is_held(lines.setup.system, index, LineEnd::last), LineEnd::last);
  NodeList list = list_nodes(line, outer_forces(line, lines.setup.system, lines.setup.lines[number]));
  find_stresses(lines.model, description, list.nodes);
  find_extremes(line, list, out);
  find_bed(line, out);
  out.water_crossings = crossings(line, [](std::size_t, const Vec3& r) { return r.z(); });
  out.nodes = std::move(list.nodes);
  return out;
}

}  // namespace

Vec3 SolvedLine::place(std::size_t node) const {
  return Vec3Map(q.data() + 6 * node);
}

Vec3 SolvedLine::tangent(std::size_t node) const {
  return Vec3Map(q.data() + 6 * node + 3).normalized();
}

LinePlace SolvedLine::at_node(std::size_t node) const {
  return {line().mesh.s[node], place(node), inclination(tangent(node))};
}

LinePlace SolvedLine::at_arc(double s) const {
  const std::vector<double>& nodes = line().mesh.s;
  const auto above = std::upper_bound(nodes.begin(), nodes.end() - 1, s);
  const auto e = static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - nodes.begin() - 1, 0));
  const double share = (s - nodes[e]) / line().mesh.length[e];
  const CentrelinePoint point = point_on(*this, e, share);
  return {nodes[e] + share * line().mesh.length[e], point.r, inclination(point.a.normalized())};
}

SolvedLine SolvedLines::line(std::size_t number) const {
  const std::size_t index = to_size(setup.lines[number]);
  return {assembly.line(index), state.lines[index].q};
}

bool is_held(const System& system, int line, LineEnd which) {
  const std::optional<std::size_t> held = find_attachment(system, to_size(line), which);
  return held && system.attachments[*held].hold_place;
}

LiftedNode lifted_node(const SolvedLine& line, std::size_t node, const Vec3& force) {
  const Vec3 moment = cut_at_node(line.assembly.cuts(), line.q, node).moment;
  const Vec3 tangent = line.tangent(node), up = up_across(tangent);
  LiftedNode out;
  out.location = line.at_node(node);
  out.tension = force.dot(tangent);
  out.shear = force.dot(up);
  out.sagging = moment.dot(tangent.cross(up));
  out.sideways = moment.dot(up);
  return out;
}

std::vector<LiftedLine> recover_pipe_lines(const SolvedLines& lines) {
  std::vector<LiftedLine> pipe;
  for (std::size_t i = 0; i < lines.model.description.lines.size(); ++i) {
    if (has_pipe_section(lines.model.description.lines[i])) pipe.push_back(recover_line(lines, i));
  }
  return pipe;
}

}  // namespace overbend
