#include "dynamics/laid_tail.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/quadrature.h"

namespace overbend {
namespace {

constexpr double kGrowth = 1.25;          ///< Of an element from its neighbour.
constexpr double kLongestElement = 40.0;  ///< [m]

/// Lengths of the elements added, from the old end outwards.
std::vector<double> added_lengths(double first, double total) {
  std::vector<double> lengths;
  double sum = 0.0, h = first;
  while (sum < total) {
    h = std::min(kGrowth * h, kLongestElement);
    lengths.push_back(h);
    sum += h;
  }
  return lengths;
}

template <class Value>
void prepend(std::vector<Value>& values, const std::vector<Value>& before) {
  values.insert(values.begin(), before.begin(), before.end());
}

}  // namespace

double tail_to_hold(const Model& model, double top_tension) {
  const double hold = model.seabed.friction_axial * model.sections.front().weight_submerged;  // the far pipe's
  return hold > 0.0 ? top_tension / hold : std::numeric_limits<double>::infinity();
}

StaticSolution with_laid_tail(const Model& model, const StaticSolution& solution, double top_tension, double reach) {
  const double wanted = tail_to_hold(model, top_tension);
  const bool shaped = model.seabed.surface.shape() != nullptr;  // where the pipe would lie beyond is not known
  if (shaped || model.description.pipe.length || !std::isfinite(wanted)) {
    return solution;
  }
  const std::vector<double> added = added_lengths(solution.mesh.length.front(), reach * std::min(wanted, kLongestTail));
  const Vec3 r(Eigen::Map<const Vec3>(solution.state.q.data()));
  const Vec3 t(Eigen::Map<const Vec3>(solution.state.q.data() + 3));
  LineMesh before;
  std::vector<double> q;
  double s = 0.0;
  for (const double h : added) {
    s -= h;
    const Vec3 place = r + s * t;
    before.s.insert(before.s.begin(), s);
    before.length.insert(before.length.begin(), h);
    before.section.insert(before.section.begin(), model.section_at(solution.mesh.total_length() - (s + 0.5 * h)));
    q.insert(q.begin(), {place.x(), place.y(), place.z(), t.x(), t.y(), t.z()});
  }
  StaticSolution longer = solution;
  prepend(longer.mesh.s, before.s);
  prepend(longer.mesh.length, before.length);
  prepend(longer.mesh.section, before.section);
  prepend(longer.state.q, q);
  if (!longer.state.low.empty()) prepend(longer.state.low, std::vector<double>(q.size(), 0.0));
  if (!longer.bending.empty()) {
    prepend(longer.bending, std::vector<BendingMemory>(kGaussPoints * added.size(), solution.bending.front()));
  }
  return longer;
}

}  // namespace overbend
