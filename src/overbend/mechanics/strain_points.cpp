#include "mechanics/strain_points.h"

#include "mechanics/axial_law.h"
#include "mechanics/rod_element.h"

namespace overbend {
namespace {

using Nodes = Eigen::Map<const Eigen::Matrix<double, 3, 4>>;

StrainPoint strain_point(const LineElements& elements, std::size_t e, const Nodes& q, const Nodes& v, int k) {
  const Eigen::Vector4d slope = hermite(0.5 * k, elements.length[e]).first;
  const Vec3 a = q * slope;
  const double stretch = a.norm(), strain = stretch - 1.0, rate = a.dot(v * slope) / stretch;
  const double ahead = strain + elements.damping[e] * rate, rest = 1.0 - elements.compression[e];
  const double force = kSlackWeight[k] * elements.length[e] * elements.EA[e] * rest *
                       (tension_only_law(ahead).force - tension_only_law(strain).force);
  return {strain, force, force * rate};
}

}  // namespace

void add_strain_points(const LineElements& elements, const double* q, const double* v,
                       std::vector<StrainPoint>& points) {
  for (std::size_t e = 0; e < static_cast<std::size_t>(elements.count); ++e) {
    if (elements.damping[e] == 0.0) continue;
    for (int k = 0; k < 3; ++k) points.push_back(strain_point(elements, e, Nodes(q + 6 * e), Nodes(v + 6 * e), k));
  }
}

}  // namespace overbend
