#include "dynamics/setup/mooring_lines.h"

#include <algorithm>
#include <cmath>

#include "dynamics/machines/mooring_winch.h"
#include "mechanics/ground.h"
#include "mechanics/quadrature.h"
#include "mechanics/rod_element.h"
#include "model/vessel/station.h"
#include "statics/initial_shape/cable_start.h"
#include "statics/solver/rest_together.h"

namespace overbend {
namespace {

/// Segments and points from the anchor to the fairlead: the description counts from the fairlead.
CableParts from_the_anchor(const MooringsDescription& moorings, const MooringLineDescription& described,
                           const MooredLine& moored) {
  CableParts parts{described.segments, described.points};
  parts.segments.front().length = moored.line.first_segment();
  for (LineSegmentDescription& segment : parts.segments) {
    if (!segment.type.friction) {
      segment.type.friction = moorings.bed_friction;
    }
  }
  std::reverse(parts.segments.begin(), parts.segments.end());
  const double length = parts.length();
  for (LinePointDescription& point : parts.points) {
    point.at = length - point.at;
  }
  std::reverse(parts.points.begin(), parts.points.end());
  return parts;
}

Attachment anchor(int line, const Vec3& place_W, const AnchorDescription& described) {
  Attachment held;
  held.line = line;
  held.end = LineEnd::first;
  held.hold_place = true;
  held.place = place_W;
  if (described.slides && described.holding) {
    held.holding = *described.holding;
  }
  return held;
}

Attachment fairlead(int line, const Vec3& place_V, const MooringsDescription& moorings,
                    const MooringLineDescription& described) {
  Attachment held;
  held.line = line;
  held.end = LineEnd::last;
  held.hold_place = true;
  held.body = 0;
  held.place = place_V;
  held.winch = winch_of(moorings, described);
  if (described.fails_at) {
    held.parts_at = *described.fails_at;
  }
  return held;
}

/// A last element from which a winch can haul in what it has to, and to which it can add that, staying within half and
/// one and a half of its length [m].
double last_element(const Model& model, std::size_t line) {
  constexpr double kOverWay = 2.0;
  const MooringsDescription& moorings = *model.description.moorings;
  const OperationDescription& operation = model.description.operation;
  const std::optional<WinchLaw> winch = winch_of(moorings, moorings.lines[line]);
  double way = operation.type == OperationType::pull_ahead ? std::abs(operation.distance) * operation.moves : 0.0;
  for (const double length : winch ? winch->program.lengths : std::vector<double>{}) {
    way = std::max(way, std::abs(length));
  }
  return kOverWay * way;
}

/// How far under the bed's surface the axis of an element lies: the bed of a line is lowered by the radius of its
/// thickest part, on which thinner ones lie lower, and each sinks in by its weight [m].
double lies_under(const Line& line, std::size_t element) {
  const double weight = line.elements.weight[element] - line.elements.buoyancy[element];
  const LineEnvironment& env = line.environment;
  return env.bed_lowered - line.elements.radius[element] + std::max(weight, 0.0) / env.bed_stiffness;
}

/// The element by which a node lies: both nodes of a joint by the joint, which a step between them would stretch.
std::size_t lying_element(const LineMesh& mesh, std::size_t node) {
  return node == mesh.length.size() || (node > 0 && mesh.joint(node - 1)) ? node - 1 : node;
}

/// At a node. Where segments meet, or at a weight, stretch and direction are those of the longer of its elements: the
/// other is the joint between them.
CatenaryPlace place_of_node(const MooredLine& moored, const CatenarySolution& solution, const LineMesh& mesh,
                            std::size_t node) {
  constexpr double kBeside = 1e-6;  // [m]
  const std::size_t last = mesh.length.size() - 1;
  const bool ahead = node == 0 || (node <= last && mesh.length[node] > mesh.length[node - 1]);
  const double length = moored.line.length(), beside = mesh.s[node] + (ahead ? kBeside : -kBeside);
  return catenary_place(moored.line, solution, std::clamp(length - beside, 0.0, length));
}

/// The catenary of statics in the line's vertical plane; what lies has sunk into the bed, wherever that is: without
/// tension nothing but the bed holds it. Nodes count from the anchor.
std::vector<double> catenary_nodes(const MooringSpread& spread, const MooredLine& moored, const Vec3& fairlead_W,
                                   const CatenarySolution& solution, const Line& line) {
  const Vec3 towards = line_direction(moored, fairlead_W).direction_W;
  std::vector<double> q;
  for (std::size_t node = 0; node < line.mesh.s.size(); ++node) {
    const CatenaryPlace at = place_of_node(moored, solution, line.mesh, node);
    Vec3 r = Vec3(fairlead_W.x(), fairlead_W.y(), at.z) + at.x * towards;
    const double bed = spread.bed.height(r.x(), r.y());
    if (at.lies || r.z() < bed) r.z() = bed - (at.lies ? lies_under(line, lying_element(line.mesh, node)) : 0.0);
    const Vec3 t = -at.along * towards - at.upwards * Vec3::UnitZ();
    q.insert(q.end(), {r.x(), r.y(), r.z(), t.x(), t.y(), t.z()});
  }
  return q;
}

constexpr double kOfLastElement = 0.8;  ///< That a winch without a program may haul in or add.

/// Unstressed length from the anchor at which the line leaves the bed; none where nothing lies [m].
std::optional<double> touchdown_from_anchor(const MooredLine& moored, const CatenarySolution& solution) {
  if (solution.trace.on_bed <= 0.0) return std::nullopt;
  return moored.line.length() - solution.trace.touchdown_s;
}

/// The bed's friction on what lies of a line, by weight: elements have one, segments each their own.
std::optional<double> friction_of_what_lies(const MooredLine& moored, const CatenarySolution& solution) {
  if (solution.trace.on_bed <= 0.0) return std::nullopt;
  double rubs = 0.0, weight = 0.0, end = 0.0;
  for (const CatenaryPiece& piece : moored.line.pieces) {
    end += piece.length;
    const double lies = std::clamp(end - solution.trace.touchdown_s, 0.0, piece.length);
    const double carried = lies * std::max(piece.weight_submerged, 0.0);
    rubs += piece.friction * carried;
    weight += carried;
  }
  return weight > 0.0 ? std::optional(rubs / weight) : std::nullopt;
}

/// Far more than friction bears: a line with it slides, whichever small way it goes [m].
constexpr double kPulledFar = 1.0;

/// Stretches the bed's friction along a line of which all that bears tension has been pulled in over the bed: the
/// tension falls from touchdown towards the anchor by the friction, until none is left. Whether it reaches the anchor.
bool stretch_as_pulled_in(const Line& line, LineState& state) {
  const std::size_t padded = line.elements.padded();
  const LineEnvironment& env = line.environment;
  double tension = 0.0;
  for (int e = line.elements.count - 1; e >= 0; --e) {
    const std::size_t i = static_cast<std::size_t>(e);
    const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * e));
    const double length = line.mesh.length[i];
    for (int point = kGaussPoints - 1; point >= 0; --point) {
      const CentrelinePoint at = centreline(q, kGaussXi[point], length);
      if (ground_at(env, at.r).clearance > 2.0 * line.elements.radius[i]) {  // what lies lies on the bed's surface
        tension = line.elements.EA[i] * (at.a.norm() - 1.0);
        continue;
      }
      const double weight = std::max(0.0, line.elements.weight[i] - line.elements.buoyancy[i]);
      tension -= env.bed_friction_axial * weight * kGaussWeight[point] * length;
      const std::size_t slip = static_cast<std::size_t>(point * kBedDirections + 1) * padded + i;
      state.bed_slip[slip] = tension > 0.0 ? kPulledFar : 0.0;
    }
  }
  return tension > 0.0;
}

/// Whether the bed falls across what lies of a line: there its friction alone keeps it from sliding down into a bow
/// that pulls it taut.
bool lies_across_a_slope(const Line& line, const LineState& state) {
  constexpr double kLevel = 1e-3;  // of the weight
  for (std::size_t node = 0; node < line.mesh.s.size(); ++node) {
    const Vec3 r = Eigen::Map<const Vec3>(state.q.data() + 6 * node);
    const Vec3 t = Eigen::Map<const Vec3>(state.q.data() + 6 * node + 3);
    const GroundPoint at = ground_at(line.environment, r);
    if (at.clearance > 2.0 * line.elements.radius[lying_element(line.mesh, node)]) continue;
    const Vec3 across = Vec3(-t.y(), t.x(), 0.0).stableNormalized();
    if (std::abs(at.normal.dot(across)) > kLevel) return true;
  }
  return false;
}

/// The mooring lines of a system by themselves.
System moorings_alone(const System& system, const std::vector<std::size_t>& lines) {
  System alone = system;
  alone.lines.clear();
  alone.attachments.clear();
  for (const std::size_t line : lines) alone.lines.push_back(system.lines[line]);
  return alone;
}

/// The mooring lines of a state, on bodies that stay where they are.
RestReport rest_alone(const System& system, const std::vector<RigidMotion>& bodies, SystemState& state) {
  const std::vector<std::size_t> lines = find_lines(system, LineRole::mooring);
  System alone = moorings_alone(system, lines);
  alone.bodies.assign(bodies.size(), Body{});
  SystemState at;
  at.time = state.time;
  for (const std::size_t line : lines) at.lines.push_back(state.lines[line]);
  for (std::size_t i = 0; i < system.attachments.size(); ++i) {
    const auto found = std::ranges::find(lines, static_cast<std::size_t>(system.attachments[i].line));
    if (found == lines.end()) continue;
    alone.attachments.push_back(system.attachments[i]);
    alone.attachments.back().line = static_cast<int>(found - lines.begin());
    at.attachments.push_back(state.attachments[i]);
  }
  alone.surroundings = [&](double, Surroundings& now) {
    now.bodies = bodies;
    lead_attachments(alone.attachments, now);
  };
  Assembly assembly(alone);
  const RestReport report = rest_together(assembly, at);
  for (std::size_t i = 0; i < lines.size(); ++i) state.lines[lines[i]] = std::move(at.lines[i]);
  return report;
}

}  // namespace

LineShapes add_mooring_lines(const Model& model, const MooringSpread& spread, System& system) {
  LineShapes shapes;
  const MooringsDescription& moorings = moorings_of(model.description);
  const std::optional<LaidPipe> pipe = find_laid_pipe(system);
  const double pipe_scale = pipe ? system.lines[pipe->line].force_scale : 0.0;
  for (std::size_t i = 0; i < spread.lines.size(); ++i) {
    const MooredLine& moored = spread.lines[i];
    if (moored.parted) continue;
    const CableParts parts = from_the_anchor(moorings, moorings.lines[i], moored);
    const Vec3 fairlead_W = model.mean_pose.p_WV + model.mean_pose.R_WV * moored.fairlead_V;
    const CatenarySolution hangs = line_pull(spread, moored, fairlead_W, nullptr).solution;
    // A line that is slack lies in a bow, which a catenary does not know.
    const bool bow = hangs.slack || hangs.fault != CatenaryFault::none;
    const CableStart start = cable_start(model, parts, moored.anchor_W, fairlead_W);
    std::optional<double> touchdown = start.touchdown();
    if (!bow) touchdown = touchdown_from_anchor(moored, hangs);
    const int line = static_cast<int>(system.lines.size());
    system.lines.push_back(
        cable_line(model, parts, {touchdown, std::nullopt, last_element(model, i)}, moored.anchor_W, fairlead_W));
    system.lines.back().name = moored.name;
    system.lines.back().role = LineRole::mooring;
    if (const std::optional<double> friction = bow ? std::nullopt : friction_of_what_lies(moored, hangs)) {
      system.lines.back().environment.bed_friction_axial = *friction;
      system.lines.back().environment.bed_friction_lateral = *friction;
    }
    // What may be left unbalanced at a node of the pipe may be at one of a wire, which pulls as hard as the pipe.
    system.lines.back().force_scale = std::max(system.lines.back().force_scale, pipe_scale);
    system.attachments.push_back(anchor(line, moored.anchor_W, moorings.lines[i].anchor_holding));
    system.attachments.push_back(fairlead(line, moored.fairlead_V, moorings, moorings.lines[i]));
    if (std::optional<WinchLaw>& winch = system.attachments.back().winch) {
      winch->tension.limit = winch_range(system.lines.back());
    }
    const Line& made = system.lines.back();
    shapes.push_back(bow ? start.shape(made.mesh) : catenary_nodes(spread, moored, fairlead_W, hangs, made));
  }
  return shapes;
}

double winch_range(const Line& line) {
  return kOfLastElement * line.mesh.length.back();
}

System pulled_in(const System& system, SystemState& state) {
  System pulled = system;
  for (const std::size_t i : find_lines(system, LineRole::mooring)) {
    LineEnvironment& env = pulled.lines[i].environment;
    const bool reached = stretch_as_pulled_in(system.lines[i], state.lines[i]);
    if (reached && !lies_across_a_slope(system.lines[i], state.lines[i])) env.bed_friction_lateral = 0.0;
    env.current_rows = 0;
  }
  return pulled;
}

namespace {

/// By its number among the mooring lines.
std::string name_of_mooring(const System& system, int number) {
  return system.lines[find_lines(system, LineRole::mooring)[static_cast<std::size_t>(number)]].name;
}

}  // namespace

std::optional<StaticFailure> rest_mooring_lines(const System& system, const std::vector<RigidMotion>& bodies,
                                                SystemState& state) {
  const System pulled = pulled_in(system, state);
  for (const System* one : {&pulled, &system}) {
    const RestReport report = rest_alone(*one, bodies, state);
    if (report.converged) continue;
    return StaticFailure{"a mooring line does not come to rest",
                         "'" + name_of_mooring(system, report.worst_place.first) + "'",
                         "look at its length and at the place of its anchor"};
  }
  return std::nullopt;
}

std::vector<std::string> mooring_names(const MooringSpread& spread) {
  std::vector<std::string> names;
  for (const MooredLine& line : spread.lines) {
    if (!line.parted) names.push_back(line.name);
  }
  return names;
}

}  // namespace overbend
