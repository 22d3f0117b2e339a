#include "system/cable_line.h"

#include <algorithm>
#include <cmath>

#include "base/ranges.h"
#include "mechanics/element_constants.h"
#include "model/pipe/section.h"

namespace overbend {
namespace {

constexpr double kBedSink = 0.01;          ///< Maximum penetration of a cable into the seabed [m].
constexpr double kMinNodeDistance = 1e-3;  ///< Minimum distance of fixed positions, relative to the length.
constexpr double kJoint = 1e-5;            ///< Length of the element at a joint, relative to the line length.
/// Share of the bending stiffness at a joint: with less it flutters when slack.
constexpr double kJointStiffness = 1e-3;
constexpr double kMaxElementShare = 1.0 / 20.0, kMinElementShare = 1.0 / 40.0, kFineShare = 1.0 / 10.0;

int segment_at(const CableParts& parts, double s) {
  double end = 0.0;
  for (std::size_t i = 0; i + 1 < parts.segments.size(); ++i) {
    end += parts.segments[i].length.value();
    if (s < end) return static_cast<int>(i);
  }
  return static_cast<int>(parts.segments.size()) - 1;
}

/// For lines with pipe: bending of the pipe needs no joints.
std::vector<double> find_fixed_pipe_nodes(const CableParts& parts) {
  constexpr double kClosest = 0.02;  // [m]
  std::vector<double> places = parts.attached;
  double arc_length = 0.0;
  for (const LineSegmentDescription& segment : parts.segments) places.push_back(arc_length += segment.length.value());
  for (const LinePointDescription& point : parts.points) places.push_back(point.at);
  std::sort(places.begin(), places.end());
  std::vector<double> fixed;
  for (const double place : places) {
    if (place > (fixed.empty() ? 0.0 : fixed.back()) + kClosest && place < arc_length - kClosest) {
      fixed.push_back(place);
    }
  }
  fixed.push_back(arc_length);
  return fixed;
}

/// Ends of segments and positions of points, ascending, the end of the line last. Neighbouring elements share the
/// tangent of their node. A tiny joint element next to each position takes the kink at a weight and the jump of the
/// strain at a change of stiffness: on the softer side, which takes the strain of the other side with the smaller
/// force.
std::vector<double> fixed_places(const CableParts& parts) {
  std::vector<double> places;
  double arc_length = 0.0;
  for (const LineSegmentDescription& segment : parts.segments) places.push_back(arc_length += segment.length.value());
  for (const LinePointDescription& point : parts.points) places.push_back(point.at);
  places.insert(places.end(), parts.attached.begin(), parts.attached.end());
  std::sort(places.begin(), places.end());
  const double end = arc_length, closest = kMinNodeDistance * end, joint = kJoint * end;
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
  const Vec3 horizontal(to.x() - from.x(), to.y() - from.y(), 0.0);
  return horizontal.norm() > 1e-6 * (to - from).norm() && horizontal.norm() > 0.0 ? Vec3(horizontal.normalized())
                                                                                  : Vec3::UnitX();
}

void put(double (&out)[3], const Vec3& v) {
  for (int i = 0; i < 3; ++i) out[i] = v(i);
}

ElementConstants segment_constants(const Model& model, const LineSegmentDescription& segment) {
  if (!segment.section) return cable_constants(model, segment.type);
  const double water = model.description.environment.water_weight_density;
  return pipe_constants(model, derive_section(segment.name, *segment.section, water));
}

double max_element_length(const CableParts& parts, const CableMesh& wanted) {
  return wanted.element.value_or(kMaxElementShare * parts.length());
}

}  // namespace

double CableParts::length() const {
  double sum = 0.0;
  for (const LineSegmentDescription& segment : segments) sum += segment.length.value();
  return sum;
}

bool CableParts::has_pipe() const {
  return ranges::any_of(segments, [](const auto& segment) { return segment.section.has_value(); });
}

int node_at(const LineMesh& mesh, double s) {
  return nearest_node(mesh, s);
}

double pipe_element(const Model& model, const CableParts& parts) {
  constexpr double kShare = 1.0 / 6.0, kMaxElementCount = 3000.0;
  double element_size = kMaxElementShare * parts.length();
  for (const LineSegmentDescription& segment : parts.segments) {
    if (!segment.section) continue;
    const double EI = segment_constants(model, segment).EI;
    element_size = std::min(element_size, kShare * std::pow(4.0 * EI / std::max(model.seabed.stiffness, 1.0), 0.25));
  }
  return std::max(element_size, parts.length() / kMaxElementCount);
}

FineStretch make_touchdown_stretch(const CableParts& parts, const CableMesh& wanted, double touchdown) {
  const double length = parts.length(), reach = kFineShare * length;
  return {touchdown - reach, touchdown + reach, std::min(max_element_length(parts, wanted), kMinElementShare * length)};
}

LineMesh cable_mesh(const CableParts& parts, const CableMesh& wanted) {
  const double length = parts.length();
  MeshPlan plan;
  plan.max_length = max_element_length(parts, wanted);
  plan.fine = wanted.fine;
  if (wanted.touchdown) plan.fine.push_back(make_touchdown_stretch(parts, wanted, *wanted.touchdown));
  plan.fixed = parts.has_pipe() ? find_fixed_pipe_nodes(parts) : fixed_places(parts);
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

/// Seabed stiffness under a cable [N/m2]. With a pipe the model's value is the pipe's: soil resists by pressure, so the
/// stiffness under a narrower cable is lower in proportion.
double cable_soil_stiffness(const Model& model, double width) {
  const double of_model = model.seabed.stiffness;
  return model.description.has_pipe ? of_model * std::min(1.0, width / model.pipe_section().outer_diameter) : of_model;
}

LineEnvironment cable_environment(const Model& model, const CableParts& parts, const Vec3& from, const Vec3& to) {
  const Vec3 ahead = horizontal_direction(from, to), across = Vec3::UnitZ().cross(ahead);
  const SeabedSurface& bed = model.seabed.surface;
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
  const double soil = parts.has_pipe() ? model.seabed.stiffness : cable_soil_stiffness(model, 2.0 * thickest);
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

/// A bend too sharp for the neighbouring elements makes a joint a hinge: the bending length is sqrt(EI/T), with the
/// line's weight for T. A bend that they resolve continues through the joint.
void soften_joints(Line& line) {
  const double tension = line.force_scale;
  for (std::size_t e = 0; e < line.mesh.length.size(); ++e) {
    if (!line.mesh.joint(e)) continue;
    const double neighbour_length = std::min(line.mesh.length[e - 1], line.mesh.length[e + 1]);
    double& EI = line.elements.EI[e];
    if (EI < tension * neighbour_length * neighbour_length) EI *= kJointStiffness;
  }
}

/// Node of a point. Where a joint precedes a point, the point is at the beginning of the joint, so that each node of
/// the joint has the force of its own side.
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
  line.elements = make_elements_by_kind(line.mesh.length, line.mesh.section, constants);
  line.environment = cable_environment(model, parts, from, to);
  line.on_rollers = false;
  line.force_scale = weight_from(line.mesh, line.elements, 0.0);
  if (!parts.has_pipe()) soften_joints(line);
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
