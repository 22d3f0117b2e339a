#include "system/cable_line.h"

#include <algorithm>
#include <cmath>

#include "mechanics/element_constants.h"
#include "model/pipe/section.h"

namespace overbend {
namespace {

constexpr double kBedSink = 0.01;       ///< A cable sinks into the bed by this at most [m].
constexpr double kClosestNodes = 1e-3;  ///< Places that share a node, of the length.
constexpr double kJoint = 1e-5;         ///< Length of the element at a joint, of the whole length.
constexpr double kJointBends = 1e-3;    ///< Of a bending stiffness, left to a hinge: with less it flutters where slack.
constexpr double kLongestShare = 1.0 / 20.0, kShortestShare = 1.0 / 40.0, kFineShare = 1.0 / 10.0;

int segment_at(const CableParts& parts, double s) {
  double end = 0.0;
  for (std::size_t i = 0; i + 1 < parts.segments.size(); ++i) {
    end += parts.segments[i].length.value();
    if (s < end) return static_cast<int>(i);
  }
  return static_cast<int>(parts.segments.size()) - 1;
}

/// Of pipe: its bending takes up what happens at a node, and needs no joint there.
std::vector<double> fixed_places_of_pipe(const CableParts& parts) {
  constexpr double kClosest = 0.02;  // [m]
  std::vector<double> places = parts.attached;
  double at = 0.0;
  for (const LineSegmentDescription& segment : parts.segments) places.push_back(at += segment.length.value());
  for (const LinePointDescription& point : parts.points) places.push_back(point.at);
  std::sort(places.begin(), places.end());
  std::vector<double> fixed;
  for (const double place : places) {
    if (place > (fixed.empty() ? 0.0 : fixed.back()) + kClosest && place < at - kClosest) fixed.push_back(place);
  }
  fixed.push_back(at);
  return fixed;
}

/// Ends of segments and places of points, rising, the end of the line last. Neighbouring elements share the tangent of
/// their node. A tiny one beside each place takes up the angle that a weight makes there, and the step of the stretch
/// where the stiffness changes: on the softer side, which takes the stretch of the other with the smaller force.
std::vector<double> fixed_places(const CableParts& parts) {
  std::vector<double> places;
  double at = 0.0;
  for (const LineSegmentDescription& segment : parts.segments) places.push_back(at += segment.length.value());
  for (const LinePointDescription& point : parts.points) places.push_back(point.at);
  places.insert(places.end(), parts.attached.begin(), parts.attached.end());
  std::sort(places.begin(), places.end());
  const double end = at, closest = kClosestNodes * end, joint = kJoint * end;
  const auto stiffness = [&](double s) {
    return parts.segments[static_cast<std::size_t>(segment_at(parts, s))].type.axial_stiffness;
  };
  std::vector<double> fixed;
  for (const double place : places) {
    if (place <= (fixed.empty() ? 0.0 : fixed.back()) + closest || place >= end - closest) continue;
    if (stiffness(place - joint) < stiffness(place + joint)) {
      fixed.insert(fixed.end(), {place - joint, place});
    } else {
      fixed.insert(fixed.end(), {place, place + joint});
    }
  }
  fixed.push_back(end);
  return fixed;
}

int nearest_node(const LineMesh& mesh, double s) {
  const auto nearer = [s](double a, double b) { return std::abs(a - s) < std::abs(b - s); };
  return static_cast<int>(std::min_element(mesh.s.begin(), mesh.s.end(), nearer) - mesh.s.begin());
}

Vec3 horizontal_direction(const Vec3& from, const Vec3& to) {
  const Vec3 way(to.x() - from.x(), to.y() - from.y(), 0.0);
  return way.norm() > 1e-6 * (to - from).norm() && way.norm() > 0.0 ? Vec3(way.normalized()) : Vec3::UnitX();
}

void put(double (&out)[3], const Vec3& v) {
  for (int i = 0; i < 3; ++i) out[i] = v(i);
}

ElementConstants segment_constants(const Model& model, const LineSegmentDescription& segment) {
  if (!segment.section) return cable_constants(model, segment.type);
  const double water = model.description.environment.water_weight_density;
  return pipe_constants(model, derive_section(segment.name, *segment.section, water));
}

double longest_element(const CableParts& parts, const CableMesh& wanted) {
  return wanted.element.value_or(kLongestShare * parts.length());
}

}  // namespace

double CableParts::length() const {
  double sum = 0.0;
  for (const LineSegmentDescription& segment : segments) sum += segment.length.value();
  return sum;
}

bool CableParts::has_pipe() const {
  return std::ranges::any_of(segments, [](const auto& segment) { return segment.section.has_value(); });
}

int node_at(const LineMesh& mesh, double s) {
  return nearest_node(mesh, s);
}

double pipe_element(const Model& model, const CableParts& parts) {
  constexpr double kShare = 1.0 / 6.0, kMost = 3000.0;
  double shortest = kLongestShare * parts.length();
  for (const LineSegmentDescription& segment : parts.segments) {
    if (!segment.section) continue;
    const double EI = segment_constants(model, segment).EI;
    shortest = std::min(shortest, kShare * std::pow(4.0 * EI / std::max(model.seabed.stiffness, 1.0), 0.25));
  }
  return std::max(shortest, parts.length() / kMost);
}

FineStretch stretch_at_touchdown(const CableParts& parts, const CableMesh& wanted, double at) {
  const double length = parts.length(), reach = kFineShare * length;
  return {at - reach, at + reach, std::min(longest_element(parts, wanted), kShortestShare * length)};
}

LineMesh cable_mesh(const CableParts& parts, const CableMesh& wanted) {
  const double length = parts.length();
  MeshPlan plan;
  plan.longest = longest_element(parts, wanted);
  plan.fine = wanted.fine;
  if (wanted.touchdown) plan.fine.push_back(stretch_at_touchdown(parts, wanted, *wanted.touchdown));
  plan.fixed = parts.has_pipe() ? fixed_places_of_pipe(parts) : fixed_places(parts);
  LineMesh mesh;
  mesh.s = graded_nodes(plan);
  const double before_end = plan.fixed.size() > 1 ? plan.fixed[plan.fixed.size() - 2] : 0.0;
  while (mesh.s.size() > 2 && length - mesh.s[mesh.s.size() - 2] < wanted.last &&
         mesh.s[mesh.s.size() - 2] > before_end * (1.0 + 1e-9)) {
    mesh.s.erase(mesh.s.end() - 2);
  }
  for (std::size_t i = 0; i + 1 < mesh.s.size(); ++i) {
    mesh.length.push_back(mesh.s[i + 1] - mesh.s[i]);
    mesh.section.push_back(segment_at(parts, 0.5 * (mesh.s[i] + mesh.s[i + 1])));
  }
  return mesh;
}

/// Stiffness of the bed under a cable [N/m2]. Where there is a pipe the model's is the pipe's: soil yields by pressure,
/// so a cable of less width meets as much less of it.
double soil_under(const Model& model, double width) {
  const double of_model = model.seabed.stiffness;
  return model.description.has_pipe ? of_model * std::min(1.0, width / model.pipe_section().outer_diameter) : of_model;
}

LineEnvironment cable_environment(const Model& model, const CableParts& parts, const Vec3& from, const Vec3& to) {
  const Vec3 ahead = horizontal_direction(from, to), across = Vec3::UnitZ().cross(ahead);
  const BedSurface& bed = model.seabed.surface;
  const Vec3 normal = bed.plane_normal();
  double heaviest = 0.0, thickest = 0.0;
  std::optional<double> friction;
  for (const LineSegmentDescription& segment : parts.segments) {
    heaviest = std::max(heaviest, std::abs(segment.type.weight_submerged));
    thickest = std::max(thickest, segment_constants(model, segment).radius);
    if (segment.type.friction) friction = std::max(friction.value_or(0.0), *segment.type.friction);
  }
  LineEnvironment env;
  put(env.bed_normal, normal);
  put(env.route_normal, across);
  put(env.bed_along, bed.along(from, ahead));
  const double lowered = parts.has_pipe() ? 0.0 : thickest;
  env.bed_offset = bed.offset() - lowered;
  set_shape(env, bed);
  env.bed_lowered = lowered;
  env.route_offset = across.dot(from);
  const double soil = parts.has_pipe() ? model.seabed.stiffness : soil_under(model, 2.0 * thickest);
  env.bed_stiffness = parts.has_pipe() ? soil : std::max(soil, heaviest / kBedSink);
  env.bed_stick = soil > 0.0 ? soil : env.bed_stiffness;
  env.bed_friction_lateral = friction.value_or(model.seabed.friction_lateral);
  env.bed_friction_axial = friction.value_or(model.seabed.friction_axial);
  env.bed_damping = model.description.environment.seabed.damping;
  env.current_rows = static_cast<int>(model.current.z.size());
  env.current_z = model.current.z.data();
  env.current_vx = model.current.vx.data();
  env.current_vy = model.current.vy.data();
  return env;
}

/// Of a bend sharper than the elements beside can show a joint is a hinge: it bends over sqrt(EI/T) of them, with the
/// line's weight for T. One that they show goes on through the joint.
void let_joints_turn(Line& line) {
  const double tension = line.force_scale;
  for (std::size_t e = 0; e < line.mesh.length.size(); ++e) {
    if (!line.mesh.joint(e)) continue;
    const double beside = std::min(line.mesh.length[e - 1], line.mesh.length[e + 1]);
    double& EI = line.elements.EI[e];
    if (EI < tension * beside * beside) EI *= kJointBends;
  }
}

/// Where a joint is before a point the point stands at its beginning, so that each node of the joint has the force of
/// its own side.
int node_of_point(const LineMesh& mesh, double s) {
  const int node = nearest_node(mesh, s);
  return node > 0 && mesh.joint(static_cast<std::size_t>(node - 1)) ? node - 1 : node;
}

Line cable_line(const Model& model, const CableParts& parts, const CableMesh& mesh, const Vec3& from, const Vec3& to) {
  std::vector<ElementConstants> constants;
  for (const LineSegmentDescription& segment : parts.segments) {
    constants.push_back(segment_constants(model, segment));
  }
  Line line;
  line.mesh = cable_mesh(parts, mesh);
  line.elements = elements_of_kinds(line.mesh.length, line.mesh.section, constants);
  line.environment = cable_environment(model, parts, from, to);
  line.on_rollers = false;
  line.force_scale = weight_from(line.mesh, line.elements, 0.0);
  if (!parts.has_pipe()) let_joints_turn(line);
  for (const LinePointDescription& point : parts.points) {
    line.points.push_back(line_point(model, point, node_of_point(line.mesh, point.at)));
    line.force_scale += line.points.back().weight;
  }
  return line;
}

void set_length(Line& line, double length) {
  const double share = length / line.mesh.total_length();
  for (double& s : line.mesh.s) s *= share;
  for (double& element : line.mesh.length) element *= share;
  for (double& element : line.elements.length) element *= share;
}

}  // namespace overbend
