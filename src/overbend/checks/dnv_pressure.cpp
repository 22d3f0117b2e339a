#include "checks/dnv_pressure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace overbend {

double elastic_collapse_pressure(const Wall& wall) {
  const double ratio = wall.thickness / wall.diameter;
  return 2.0 * wall.youngs_modulus * ratio * ratio * ratio / (1.0 - wall.poissons_ratio * wall.poissons_ratio);
}

double plastic_collapse_pressure(const Wall& wall, double fy, double alpha_fab) {
  return fy * alpha_fab * 2.0 * wall.thickness / wall.diameter;
}

double collapse_pressure(const Wall& wall, double fy, double alpha_fab, double ovality) {
  const double elastic = elastic_collapse_pressure(wall), plastic = plastic_collapse_pressure(wall, fy, alpha_fab);
  const double b = -elastic;
  const double c = -(plastic * plastic + plastic * elastic * ovality * wall.slenderness());
  const double d = elastic * plastic * plastic;
  const double u = (c - b * b / 3.0) / 3.0;  // < 0: three real roots, p_c the middle one
  const double v = (2.0 * b * b * b / 27.0 - b * c / 3.0 + d) / 2.0;
  const double cosine = std::clamp(-v / std::sqrt(-u * u * u), -1.0, 1.0);
  const double y = -2.0 * std::sqrt(-u) * std::cos(std::acos(cosine) / 3.0 + std::numbers::pi / 3.0);
  return y - b / 3.0;
}

double propagation_pressure(const Wall& wall, double fy, double alpha_fab) {
  return 35.0 * fy * alpha_fab * std::pow(wall.thickness / wall.diameter, 2.5);
}

double crossover_pressure(const Wall& wall, double propagation, double resistance, double length) {
  const double share = 1.0 - std::exp(-20.0 * wall.thickness * length / (wall.diameter * wall.diameter));
  return propagation + (resistance - propagation) * share;
}

double burst_pressure(const Wall& wall, double fcb) {
  return 2.0 * wall.thickness / (wall.diameter - wall.thickness) * fcb * 2.0 / std::numbers::sqrt3;
}

}  // namespace overbend
