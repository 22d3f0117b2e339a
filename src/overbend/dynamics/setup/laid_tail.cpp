#include "dynamics/setup/laid_tail.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/quadrature.h"

namespace overbend {
namespace {

constexpr double kGrowth = 1.25;          ///< Length ratio of neighbouring elements.
constexpr double kMaxTailElement = 40.0;  ///< [m]

/// Lengths of the added elements, outwards from the old end.
std::vector<double> added_lengths(double first, double total) {
  std::vector<double> lengths;
  double sum = 0.0, h = first;
  while (sum < total) {
    h = std::min(kGrowth * h, kMaxTailElement);
    lengths.push_back(h);
    sum += h;
  }
  return lengths;
}

/// Increase of the strain of a pipe at rest per metre along a seabed of slope `rise` [1/m]: the pressures of water and
/// contents decrease upwards, and the tension changes by the part of the weight that is not held by seabed friction.
double strain_gradient(const Model& model, int section, double rise) {
  const Section& pipe = model.sections[static_cast<std::size_t>(section)];
  const double pressed =
      model.water_weight_density * pipe.pressure_area - pipe.contents_weight_density * pipe.internal_area;
  const double pull = pipe.weight_submerged * rise;
  const double limit =
      model.seabed.friction_axial * pipe.weight_submerged * std::cos(model.description.environment.seabed.slope);
  const double slides = pull - std::clamp(pull, -limit, limit);
  return ((1.0 - 2.0 * pipe.poissons_ratio) * pressed * rise + slides) / pipe.EA;
}

template <class Value>
void prepend(std::vector<Value>& values, const std::vector<Value>& before) {
  values.insert(values.begin(), before.begin(), before.end());
}

}  // namespace

double friction_anchorage_length(const Model& model, double top_tension) {
  const double hold = model.seabed.friction_axial * model.pipe_section().weight_submerged;  // section at the anchor end
  return hold > 0.0 ? top_tension / hold : std::numeric_limits<double>::infinity();
}

StaticSolution with_laid_tail(const Model& model, const StaticSolution& solution, double top_tension, double reach) {
  if (!model.description.has_pipe) return solution;
  const double wanted = friction_anchorage_length(model, top_tension);
  const bool shaped = model.seabed.surface.shape() != nullptr;  // the pipe's shape beyond is unknown
  if (shaped || model.description.pipe.length || !std::isfinite(wanted)) {
    return solution;
  }
  Vec3 place(Eigen::Map<const Vec3>(solution.state.q.data()));
  const Vec3 end(Eigen::Map<const Vec3>(solution.state.q.data() + 3)), away = -end.normalized();
  const double dry = -model.pipe_section().outer_radius();
  LineMesh before;
  std::vector<double> q;
  double s = 0.0, stretched = end.norm();
  for (const double h : added_lengths(solution.mesh.length.front(), reach * std::min(wanted, kMaxTailLength))) {
    if (away.z() > 0.0 && place.z() + h * stretched * away.z() > dry) break;  // the seabed rises out of the water
    s -= h;
    const int section = model.section_at(solution.mesh.total_length() - (s + 0.5 * h));
    const double last = stretched;
    stretched += h * strain_gradient(model, section, away.z());
    place += 0.5 * h * (last + stretched) * away;
    const Vec3 t = -stretched * away;
    before.s.insert(before.s.begin(), s);
    before.length.insert(before.length.begin(), h);
    before.section.insert(before.section.begin(), section);
    q.insert(q.begin(), {place.x(), place.y(), place.z(), t.x(), t.y(), t.z()});
  }
  StaticSolution longer = solution;
  prepend(longer.mesh.s, before.s);
  prepend(longer.mesh.length, before.length);
  prepend(longer.mesh.section, before.section);
  prepend(longer.state.q, q);
  if (!longer.state.low.empty()) prepend(longer.state.low, std::vector<double>(q.size(), 0.0));
  if (!longer.bending.empty()) {
    prepend(longer.bending, std::vector<BendingMemory>(kGaussPoints * before.s.size(), solution.bending.front()));
  }
  return longer;
}

}  // namespace overbend
