#include "dynamics/setup/mooring_lines.h"

#include <algorithm>
#include <cmath>

#include "base/ranges.h"
#include "dynamics/machines/mooring_winch.h"
#include "mechanics/ground.h"
#include "mechanics/quadrature.h"
#include "mechanics/rod_element.h"
#include "model/vessel/mooring_queries.h"
#include "statics/initial_shape/cable_shape.h"
#include "statics/solver/coupled_equilibrium.h"

namespace overbend {
namespace {

/// Segments and points from the anchor to the fairlead; the description counts from the fairlead.
CableParts make_parts_from_anchor(const MooringsDescription& moorings, const MooringLineDescription& described,
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
  held.winch = find_winch_law(moorings, described);
  if (described.fails_at) {
    held.parts_at = *described.fails_at;
  }
  return held;
}

/// Length of the last element, from which a winch can haul in and to which it can add the required lengths within half
/// and one and a half of it [m].
double last_element(const Model& model, std::size_t line) {
  constexpr double kWinchRangeFactor = 2.0;
  const MooringsDescription& moorings = *model.description.moorings;
  const OperationDescription& operation = model.description.operation;
  const std::optional<WinchLaw> winch = find_winch_law(moorings, moorings.lines[line]);
  double distance = operation.type == OperationType::pull_ahead ? std::abs(operation.distance) * operation.moves : 0.0;
  for (const double length : winch ? winch->program.lengths : std::vector<double>{}) {
    distance = std::max(distance, std::abs(length));
  }
  return kWinchRangeFactor * distance;
}

/// Depth of an element's axis under the modelled seabed [m]: the seabed of a line is lowered by the radius of its
/// thickest part; thinner parts lie lower, and each sinks in by its weight.
double depth_under_seabed(const Line& line, std::size_t element) {
  const double weight = line.elements.weight[element] - line.elements.buoyancy[element];
  const LineEnvironment& env = line.environment;
  return env.bed_lowered - line.elements.radius[element] + std::max(weight, 0.0) / env.bed_stiffness;
}

/// Element that determines the depth of a node: for both nodes of a joint the joint, which a step between them would
/// stretch.
std::size_t grounding_element(const LineMesh& mesh, std::size_t node) {
  return node == mesh.length.size() || (node > 0 && mesh.joint(node - 1)) ? node - 1 : node;
}

/// Catenary point of a node. Where segments meet, or at a weight, strain and direction are those of the longer of its
/// elements: the other is the joint between them.
CatenaryPlace catenary_point_at_node(const MooredLine& moored, const CatenarySolution& solution, const LineMesh& mesh,
                                     std::size_t node) {
  constexpr double kOffset = 1e-6;  // [m]
  const std::size_t last = mesh.length.size() - 1;
  const bool ahead = node == 0 || (node <= last && mesh.length[node] > mesh.length[node - 1]);
  const double length = moored.line.length(), arc_length = mesh.s[node] + (ahead ? kOffset : -kOffset);
  return catenary_place(moored.line, solution, std::clamp(length - arc_length, 0.0, length));
}

/// Static catenary in the line's vertical plane. Grounded parts have sunk into the seabed at any position: without
/// tension only the seabed supports them. Nodes count from the anchor.
std::vector<double> catenary_nodes(const MooringSpread& spread, const MooredLine& moored, const Vec3& fairlead_W,
                                   const CatenarySolution& solution, const Line& line) {
  const Vec3 towards = line_direction(moored, fairlead_W).direction_W;
  std::vector<double> q;
  for (std::size_t node = 0; node < line.mesh.s.size(); ++node) {
    const CatenaryPlace place = catenary_point_at_node(moored, solution, line.mesh, node);
    Vec3 r = Vec3(fairlead_W.x(), fairlead_W.y(), place.z) + place.x * towards;
    const double bed = spread.bed.height(r.x(), r.y());
    if (place.lies || r.z() < bed) {
      r.z() = bed - (place.lies ? depth_under_seabed(line, grounding_element(line.mesh, node)) : 0.0);
    }
    const Vec3 t = -place.along * towards - place.upwards * Vec3::UnitZ();
    q.insert(q.end(), {r.x(), r.y(), r.z(), t.x(), t.y(), t.z()});
  }
  return q;
}

/// Share of the last element that a winch without a program may haul in or add.
constexpr double kUsableLastElement = 0.8;

/// Unstressed length from the anchor to the touchdown; empty if nothing lies on the seabed [m].
std::optional<double> touchdown_from_anchor(const MooredLine& moored, const CatenarySolution& solution) {
  if (solution.trace.on_bed <= 0.0) return std::nullopt;
  return moored.line.length() - solution.trace.touchdown_s;
}

/// Mean seabed friction coefficient of the grounded part, weighted by weight: the elements have one, the segments each
/// their own.
std::optional<double> grounded_friction(const MooredLine& moored, const CatenarySolution& solution) {
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

/// Initial slip well beyond the Coulomb limit [m].
constexpr double kMobilisedSlip = 1.0;

/// Sets the seabed friction of a line whose tensioned part has been pulled in along the seabed: the tension decreases
/// from touchdown towards the anchor by the friction until it vanishes. Returns true if it reaches the anchor.
bool mobilise_seabed_friction(const Line& line, LineState& state) {
  const std::size_t padded = line.elements.padded();
  const LineEnvironment& env = line.environment;
  double tension = 0.0;
  for (int e = line.elements.count - 1; e >= 0; --e) {
    const std::size_t i = static_cast<std::size_t>(e);
    const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * e));
    const double length = line.mesh.length[i];
    for (int point = kGaussPoints - 1; point >= 0; --point) {
      const CentrelinePoint centre = centreline(q, kGaussXi[point], length);
      // grounded parts lie at the seabed surface
      if (ground_at(env, centre.r).clearance > 2.0 * line.elements.radius[i]) {
        tension = line.elements.EA[i] * (centre.a.norm() - 1.0);
        continue;
      }
      const double weight = std::max(0.0, line.elements.weight[i] - line.elements.buoyancy[i]);
      tension -= env.bed_friction_axial * weight * kGaussWeight[point] * length;
      const std::size_t slip = static_cast<std::size_t>(point * kBedDirections + 1) * padded + i;
      state.bed_slip[slip] = tension > 0.0 ? kMobilisedSlip : 0.0;
    }
  }
  return tension > 0.0;
}

/// True if the seabed slopes across the grounded part of a line: there only friction prevents it from sliding down into
/// a bow that pulls it taut.
bool rests_across_slope(const Line& line, const LineState& state) {
  constexpr double kLevel = 1e-3;  // relative to the weight
  for (std::size_t node = 0; node < line.mesh.s.size(); ++node) {
    const Vec3 r = Eigen::Map<const Vec3>(state.q.data() + 6 * node);
    const Vec3 t = Eigen::Map<const Vec3>(state.q.data() + 6 * node + 3);
    const GroundPoint ground = ground_at(line.environment, r);
    if (ground.clearance > 2.0 * line.elements.radius[grounding_element(line.mesh, node)]) continue;
    const Vec3 across = Vec3(-t.y(), t.x(), 0.0).stableNormalized();
    if (std::abs(ground.normal.dot(across)) > kLevel) return true;
  }
  return false;
}

/// A system of the mooring lines only.
System make_mooring_system(const System& system, const std::vector<std::size_t>& lines) {
  System alone = system;
  alone.lines.clear();
  alone.attachments.clear();
  for (const std::size_t line : lines) alone.lines.push_back(system.lines[line]);
  return alone;
}

/// Solves the equilibrium of the mooring lines of a state on fixed bodies.
CoupledSolveReport solve_moorings_on_fixed_bodies(const System& system, const std::vector<RigidMotion>& bodies,
                                                  SystemState& state) {
  const std::vector<std::size_t> lines = find_lines(system, LineRole::mooring);
  System alone = make_mooring_system(system, lines);
  alone.bodies.assign(bodies.size(), Body{});
  SystemState lines_state;
  lines_state.time = state.time;
  for (const std::size_t line : lines) lines_state.lines.push_back(state.lines[line]);
  for (std::size_t i = 0; i < system.attachments.size(); ++i) {
    const auto found = ranges::find(lines, static_cast<std::size_t>(system.attachments[i].line));
    if (found == lines.end()) continue;
    alone.attachments.push_back(system.attachments[i]);
    alone.attachments.back().line = static_cast<int>(found - lines.begin());
    lines_state.attachments.push_back(state.attachments[i]);
  }
  alone.surroundings = [&](double, Surroundings& surroundings) {
    surroundings.bodies = bodies;
    set_attachment_motions(alone.attachments, surroundings);
  };
  Assembly assembly(alone);
  const CoupledSolveReport report = solve_coupled_equilibrium(assembly, lines_state);
  for (std::size_t i = 0; i < lines.size(); ++i) state.lines[lines[i]] = std::move(lines_state.lines[i]);
  return report;
}

}  // namespace

LineShapes add_mooring_lines(const Model& model, const MooringSpread& spread, System& system) {
  LineShapes shapes;
  const MooringsDescription& moorings = find_moorings(model.description);
  const std::optional<LaidPipe> pipe = find_laid_pipe(system);
  const double pipe_scale = pipe ? system.lines[pipe->line].force_scale : 0.0;
  for (std::size_t i = 0; i < spread.lines.size(); ++i) {
    const MooredLine& moored = spread.lines[i];
    if (moored.parted) continue;
    const CableParts parts = make_parts_from_anchor(moorings, moorings.lines[i], moored);
    const Vec3 fairlead_W = model.mean_pose.p_WV + model.mean_pose.R_WV * moored.fairlead_V;
    const CatenarySolution catenary = line_pull(spread, moored, fairlead_W, nullptr).solution;
    // A slack line forms a bow that no catenary describes.
    const bool bow = catenary.slack || catenary.error != CatenaryError::none;
    const CableShape start = make_cable_shape(model, parts, moored.anchor_W, fairlead_W);
    std::optional<double> touchdown = start.touchdown();
    if (!bow) touchdown = touchdown_from_anchor(moored, catenary);
    const int line = static_cast<int>(system.lines.size());
    system.lines.push_back(
        cable_line(model, parts, {touchdown, std::nullopt, last_element(model, i)}, moored.anchor_W, fairlead_W));
    system.lines.back().name = moored.name;
    system.lines.back().role = LineRole::mooring;
    if (const std::optional<double> friction = bow ? std::nullopt : grounded_friction(moored, catenary)) {
      system.lines.back().environment.bed_friction_axial = *friction;
      system.lines.back().environment.bed_friction_lateral = *friction;
    }
    // The permitted residual of a pipe node is also permitted for a wire with a similar tension.
    system.lines.back().force_scale = std::max(system.lines.back().force_scale, pipe_scale);
    system.attachments.push_back(anchor(line, moored.anchor_W, moorings.lines[i].anchor_holding));
    system.attachments.push_back(fairlead(line, moored.fairlead_V, moorings, moorings.lines[i]));
    if (std::optional<WinchLaw>& winch = system.attachments.back().winch) {
      winch->tension.limit = winch_range(system.lines.back());
    }
    const Line& made = system.lines.back();
    shapes.push_back(bow ? start.shape(made.mesh) : catenary_nodes(spread, moored, fairlead_W, catenary, made));
  }
  return shapes;
}

double winch_range(const Line& line) {
  return kUsableLastElement * line.mesh.length.back();
}

System with_mobilised_friction(const System& system, SystemState& state) {
  System pulled = system;
  for (const std::size_t i : find_lines(system, LineRole::mooring)) {
    LineEnvironment& env = pulled.lines[i].environment;
    const bool reached = mobilise_seabed_friction(system.lines[i], state.lines[i]);
    if (reached && !rests_across_slope(system.lines[i], state.lines[i])) env.bed_friction_lateral = 0.0;
    env.current_rows = 0;
  }
  return pulled;
}

namespace {

/// Name by the number among the mooring lines.
std::string mooring_line_name(const System& system, int number) {
  return system.lines[find_lines(system, LineRole::mooring)[static_cast<std::size_t>(number)]].name;
}

}  // namespace

std::optional<StaticFailure> solve_mooring_lines(const System& system, const std::vector<RigidMotion>& bodies,
                                                 SystemState& state) {
  const System pulled = with_mobilised_friction(system, state);
  for (const System* candidate : {&pulled, &system}) {
    const CoupledSolveReport report = solve_moorings_on_fixed_bodies(*candidate, bodies, state);
    if (report.converged) continue;
    return StaticFailure{"no equilibrium of a mooring line was found",
                         "'" + mooring_line_name(system, report.worst_place.first) + "'",
                         "check its length and the position of its anchor"};
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
