#include "model/pipe/moment_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace overbend {
namespace {

struct RadialPoint {
  double xi, weight;  ///< Position on [0, 1] and weight.
};

/// Two Gauss points integrate area and second moment of the wall exactly; more are used for comparison.
std::vector<RadialPoint> radial_points(int rings) {
  if (rings == 2) {
    const double offset = 0.5 / std::numbers::sqrt3;
    return {{0.5 - offset, 0.5}, {0.5 + offset, 0.5}};
  }
  std::vector<RadialPoint> points;
  for (int i = 0; i < rings; ++i) points.push_back({(i + 0.5) / rings, 1.0 / rings});
  return points;
}

}  // namespace

double second_moment(double outside_diameter, double wall_thickness) {
  return std::numbers::pi / 64.0 *
         (std::pow(outside_diameter, 4) - std::pow(outside_diameter - 2.0 * wall_thickness, 4));
}

WallIntegral::WallIntegral(const SteelDescription& steel, const WallLoads& loads, double max_curvature, int angles,
                           int rings)
    : wall_tension_(loads.wall_tension),
      curve_(steel, plastic_strain(steel), loads.hoop_stress, 1.5 * max_curvature * 0.5 * steel.outside_diameter) {
  const double outer = 0.5 * steel.outside_diameter, wall = steel.wall_thickness;
  for (const RadialPoint& ring : radial_points(rings)) {
    const double r = outer - wall * (1.0 - ring.xi);
    const double area = 2.0 * ring.weight * wall * r * std::numbers::pi / angles;
    for (int i = 0; i < angles; ++i) fibres_.push_back({r * std::cos(std::numbers::pi * (i + 0.5) / angles), area});
  }
}

MomentPoint WallIntegral::at(double curvature, double guess) const {
  MomentPoint point;
  point.mid_strain = guess;
  for (int i = 0; i < 50; ++i) {
    double force = 0.0, slope = 0.0;
    point.moment = 0.0;
    for (const Fibre& fibre : fibres_) {
      const FibreCurve::Value value = curve_.at(point.mid_strain + curvature * fibre.y);
      force += value.stress * fibre.area;
      slope += value.modulus * fibre.area;
      point.moment += value.stress * fibre.area * fibre.y;
    }
    const double step = (wall_tension_ - force) / slope;
    if (std::abs(step) < 1e-10) break;
    point.mid_strain += step;
  }
  return point;
}

FirstYield first_yield(const SteelDescription& steel) {
  const double curvature = 2.0 * steel.yield_stress / (steel.youngs_modulus * steel.outside_diameter);
  return {curvature * steel.youngs_modulus * second_moment(steel.outside_diameter, steel.wall_thickness), curvature};
}

double relative_moment(const MomentRambergOsgood& law, double relative_curvature) {
  double m = std::min(relative_curvature, std::pow(relative_curvature / law.coefficient, 1.0 / law.exponent));
  for (int i = 0; i < 60; ++i) {  // convex: Newton from above decreases monotonically towards the root
    const double power = law.coefficient * std::pow(m, law.exponent);
    const double step = (m + power - relative_curvature) / (1.0 + law.exponent * power / m);
    m -= step;
    if (std::abs(step) < 1e-14 * m) break;
  }
  return m;
}

MomentRambergOsgood fit_moment_law(const SteelDescription& steel) {
  constexpr int kPoints = 25;
  constexpr double kRange = 4.0;
  const FirstYield yield = first_yield(steel);
  const WallIntegral wall(steel, {}, kRange * yield.curvature);
  std::array<double, kPoints> k{}, m{};
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    k[j] = 1.0 + (kRange - 1.0) * i / (kPoints - 1);
    m[j] = wall.at(k[j] * yield.curvature).moment / yield.moment;
    const double x = std::log(m[j]), y = std::log(std::max(k[j] - m[j], 1e-12));
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  MomentRambergOsgood law;
  law.exponent = (kPoints * sxy - sx * sy) / (kPoints * sxx - sx * sx);
  law.coefficient = std::exp((sy - law.exponent * sx) / kPoints);
  for (std::size_t j = 0; j < kPoints; ++j) {
    law.max_error = std::max(law.max_error, std::abs(relative_moment(law, k[j]) / m[j] - 1.0));
  }
  return law;
}

}  // namespace overbend
