#include "statics/recovery/lines_recovery.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/shown_unit.h"
#include "mechanics/ground.h"
#include "system/cut_forces.h"

namespace overbend {
namespace {

using Vec3Map = Eigen::Map<const Vec3>;

double submerged_weight(const Line& line) {
  double sum = 0.0;
  for (std::size_t e = 0; e < line.mesh.length.size(); ++e) {
    sum += line.mesh.length[e] * (line.elements.weight[e] - line.elements.buoyancy[e]);
  }
  for (const LinePoint& point : line.points) sum += point.weight - point.buoyancy;
  return sum;
}

LineEndResult make_end_result(const LineAssembly& line, const std::vector<double>& q, LineEnd which) {
  const std::array<double, 6>& force = line.end_force(which);
  const Vec3 tangent = Vec3Map(q.data() + 6 * static_cast<std::size_t>(line.end_node(which)) + 3).normalized();
  LineEndResult end;
  end.force = Vec3(force[0], force[1], force[2]);
  end.tension = (which == LineEnd::last ? 1.0 : -1.0) * end.force.dot(tangent);  // as in the time-domain simulation
  end.declination = std::asin(std::clamp(which == LineEnd::last ? tangent.z() : -tangent.z(), -1.0, 1.0));
  return end;
}

/// If all elements at a node are in tension only, the tension is the magnitude of the force: a slack element next to a
/// kink leaves the direction of the node undefined, and no shear is carried there.
double tension_at(const LineElements& elements, std::size_t node, const Vec3& force, const Vec3& tangent) {
  const std::size_t last = static_cast<std::size_t>(elements.count) - 1;
  const bool pushed =
      elements.compression[std::min(node, last)] == 1.0 || elements.compression[node > 0 ? node - 1 : 0] == 1.0;
  return pushed ? force.dot(tangent) : force.norm();
}

std::vector<LineNodeResult> make_nodes(const LineAssembly& line, const std::vector<double>& q) {
  std::vector<LineNodeResult> nodes;
  for (std::size_t node = 0; node < line.line().mesh.s.size(); ++node) {
    const Vec3 tangent = Vec3Map(q.data() + 6 * node + 3).normalized();
    LineNodeResult result;
    result.s = line.line().mesh.s[node];
    result.place = Vec3Map(q.data() + 6 * node);
    const Vec3 force = cut_at_node(line.cuts(), q, node).force;
    result.tension = tension_at(line.line().elements, node, force, tangent);
    nodes.push_back(result);
  }
  return nodes;
}

std::optional<double> compute_utilisation(const FreeLineDescription& description, const LineResult& line,
                                          const LineMesh& mesh) {
  std::optional<double> max_utilisation;
  for (std::size_t e = 0; e < mesh.length.size(); ++e) {
    const auto& load = description.segments[static_cast<std::size_t>(mesh.section[e])].type.breaking_load;
    if (!load) continue;
    const double tension = std::max(line.nodes[e].tension, line.nodes[e + 1].tension);
    max_utilisation = std::max(max_utilisation.value_or(0.0), tension / *load);
  }
  return max_utilisation;
}

/// Returns the place of an element that is a loop, with an end reversed: an equilibrium of the elements that a real
/// line does not have. In bends that elements can represent, the direction at an end deviates less from its element.
std::optional<double> find_fold(const LineMesh& mesh, const std::vector<double>& q) {
  constexpr double kLooksBack = -0.5;  // cosine
  for (std::size_t e = 0; e < mesh.length.size(); ++e) {
    const Vec3 along = (Vec3Map(q.data() + 6 * e + 6) - Vec3Map(q.data() + 6 * e)).normalized();
    for (const std::size_t node : {e, e + 1}) {
      if (Vec3Map(q.data() + 6 * node + 3).normalized().dot(along) < kLooksBack) return mesh.s[node];
    }
  }
  return std::nullopt;
}

void warn_of_fold(const std::string& name, const LineMesh& mesh, const std::vector<double>& q, Findings& findings) {
  const std::optional<double> fold = find_fold(mesh, q);
  if (!fold) return;
  findings.push_back(
      Finding{FindingCode::element_folded,
              fmt::format("line \"{}\": an element is folded {} from its first end: tension and shape are not those of "
                          "a line; give its ends a direction, or shorter elements (lines[].element)",
                          name, shown(*fold, "m", 1))}
          .on("line " + name));
}

void warn(const FreeLineDescription& description, const LineResult& line, bool in_bow, Findings& findings) {
  if (line.utilisation && *line.utilisation > 1.0) {
    findings.push_back(Finding{
        FindingCode::breaking_load_exceeded,
        fmt::format("line \"{}\": its largest tension is {:.2f} times its breaking load", line.name, *line.utilisation)}
                           .on("line " + line.name)
                           .with("utilisation", *line.utilisation, "1"));
  }
  constexpr double kPushed = 0.1;  // relative to the weight: more than a curved line can carry in compression
  if (line.min_tension < -kPushed * std::abs(line.weight)) {
    findings.push_back(Finding{
        FindingCode::line_compressed,
        fmt::format("line \"{}\": slack, with a compression of up to {}: a line that bends sideways has other tensions",
                    line.name, shown_digits(-line.min_tension, "N", 3))}
                           .on("line " + line.name)
                           .with("tension", line.min_tension, "N"));
  }
  if (in_bow) {
    findings.push_back(
        Finding{FindingCode::line_in_bow,
                fmt::format("line \"{}\": slack, it lies in a bow on the bed at an arbitrary position", line.name)}
            .on("line " + line.name));
  }
  for (const auto& [end, result] : {std::pair{&description.first, &line.first}, {&description.second, &line.second}}) {
    if (end->kind == LineEndKind::bed && result->force.z() < -1e-3 * result->tension) {
      findings.push_back(Finding{
          FindingCode::seabed_end_lifted,
          fmt::format("line \"{}\": lifts its end on the bed with {}", line.name, shown(-result->force.z(), "N", 1))}
                             .on("line " + line.name)
                             .with("uplift", -result->force.z(), "N"));
    }
  }
}

}  // namespace

double length_on_bed(const Line& line, const std::vector<double>& q) {
  const std::vector<double>& length = line.mesh.length;
  const AlignedDoubles& radius = line.elements.radius;
  double sum = 0.0;
  for (std::size_t node = 0; node <= length.size(); ++node) {
    const double clearance = bed_clearance(line.environment, Vec3Map(q.data() + 6 * node));
    if (node > 0 && clearance < radius[node - 1]) sum += 0.5 * length[node - 1];
    if (node < length.size() && clearance < radius[node]) sum += 0.5 * length[node];
  }
  return sum;
}

Assumptions line_assumptions(const Model& model) {
  Assumptions assumptions = {
      {AssumptionRank::other,
       "Lines: no torsion; chains and ropes carry no compression and have a damping of 1 % of critical in their first "
       "axial mode, other lines none; pressure causes no tension; their axis lies at the height of the bed."}};
  const bool tethers =
      std::any_of(model.description.lines.begin(), model.description.lines.end(), [](const auto& line) {
        return std::any_of(line.points.begin(), line.points.end(),
                           [](const auto& point) { return point.tether > 0.0; });
      });
  if (tethers) {
    assumptions.push_back(
        {AssumptionRank::other,
         "Tethers are vertical above or below their line, regardless of the drag on their buoy or weight."});
  }
  return assumptions;
}

LineResult recover_line_result(const FreeLineDescription& description, const LineAssembly& solved,
                               const std::vector<double>& q) {
  LineResult line;
  line.name = description.name;
  line.length = solved.line().mesh.total_length();
  line.elements = solved.line().mesh.elements();
  line.weight = submerged_weight(solved.line());
  line.on_bed = length_on_bed(solved.line(), q);
  line.first = make_end_result(solved, q, LineEnd::first);
  line.second = make_end_result(solved, q, LineEnd::last);
  line.nodes = make_nodes(solved, q);
  const auto by_tension = [](const LineNodeResult& a, const LineNodeResult& b) { return a.tension < b.tension; };
  const auto [lowest, highest] = std::minmax_element(line.nodes.begin(), line.nodes.end(), by_tension);
  line.min_tension = lowest->tension;
  line.max_tension = highest->tension;
  line.utilisation = compute_utilisation(description, line, solved.line().mesh);
  return line;
}

std::vector<LineResult> recover_lines(const Model& model, const Assembly& assembly, const StaticLines& lines,
                                      Findings& findings) {
  const SystemState& state = lines.state;
  const LinesEquilibriumReport& rest = lines.rest;
  std::vector<LineResult> results;
  for (std::size_t i = 0; i < state.lines.size(); ++i) {
    const FreeLineDescription& description = model.description.lines[i];
    const LineAssembly& solved = assembly.line(i);
    const std::vector<double>& q = state.lines[i].q;
    LineResult line = recover_line_result(description, solved, q);
    line.residual = rest.lines[i].residual;
    line.iterations = rest.lines[i].iterations;
    warn(description, line, rest.lies_in_bow[i], findings);
    warn_of_fold(line.name, solved.line().mesh, q, findings);
    results.push_back(std::move(line));
  }
  return results;
}

}  // namespace overbend
