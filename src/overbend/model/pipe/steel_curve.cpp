#include "model/pipe/steel_curve.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

constexpr int kTable = 240;                 ///< Intervals of the fibre table on each side.
constexpr double kMinSlopeFraction = 1e-5;  ///< Fraction of Young's modulus, used for perfect plasticity.

PlasticStrain from_points(const std::vector<CurvePoint>& curve, double modulus) {
  PlasticStrain plastic;
  for (const CurvePoint& point : curve) {
    plastic.points.push_back({std::max(0.0, point.x - point.y / modulus), point.y});
  }
  plastic.points.front().x = 0.0;  // the first point ends the straight part
  const double min_slope = kMinSlopeFraction * modulus;
  for (std::size_t i = 1; i < plastic.points.size(); ++i) {
    CurvePoint& point = plastic.points[i];
    point.y = std::max(point.y, plastic.points[i - 1].y + min_slope * (point.x - plastic.points[i - 1].x));
  }
  const std::size_t last = plastic.points.size() - 1;
  plastic.beyond = last == 0 ? 1.0 / min_slope
                             : (plastic.points[last].x - plastic.points[last - 1].x) /
                                   (plastic.points[last].y - plastic.points[last - 1].y);
  return plastic;
}

PlasticStrain bilinear(const SteelDescription& steel) {
  const double slope = std::max(steel.material.hardening_modulus, kMinSlopeFraction * steel.youngs_modulus);
  PlasticStrain plastic;
  plastic.points = {{0.0, steel.yield_stress}};
  plastic.beyond = 1.0 / slope - 1.0 / steel.youngs_modulus;
  return plastic;
}

/// Returns the axial strain and its slope with respect to the axial stress.
PlasticStrain::Value axial_strain(const SteelDescription& steel, const PlasticStrain& plastic, double hoop, double s) {
  const double equivalent = std::sqrt(std::max(s * s - s * hoop + hoop * hoop, 0.0));
  const double elastic = (s - steel.poissons_ratio * hoop) / steel.youngs_modulus;
  if (equivalent <= 0.0) {
    return {elastic, 1.0 / steel.youngs_modulus};
  }
  const PlasticStrain::Value p = plastic.at(equivalent);
  const double share = (s - 0.5 * hoop) / equivalent, by_stress = p.value / equivalent;
  return {elastic + p.value * share, 1.0 / steel.youngs_modulus + (p.slope - by_stress) * share * share + by_stress};
}

/// Returns the stress at a strain beyond that of `s` in the direction `sign`: bracketed Newton iteration.
double stress_at(const SteelDescription& steel, const PlasticStrain& plastic, double hoop, double strain, double s,
                 double sign) {
  double low = s, high = s + sign * 2e-2 * steel.youngs_modulus;
  for (int i = 0; i < 80; ++i) {
    const PlasticStrain::Value value = axial_strain(steel, plastic, hoop, s);
    const double lack = sign * (strain - value.value);
    (lack > 0.0 ? low : high) = s;
    double next = s + sign * lack / value.slope;
    if ((next - low) * sign <= 0.0 || (high - next) * sign <= 0.0) next = 0.5 * (low + high);
    if (std::abs(next - s) < 1e-9 * steel.yield_stress) return next;
    s = next;
  }
  return s;
}

}  // namespace

PlasticStrain::Value PlasticStrain::at(double stress) const {
  if (points.empty()) {
    const double power = coefficient * std::pow(stress / reference, exponent);
    return {power, stress > 0.0 ? exponent * power / stress : 0.0};
  }
  const auto after = std::find_if(points.begin(), points.end(), [&](const CurvePoint& p) { return p.y > stress; });
  if (after == points.begin()) return {0.0, 0.0};
  const CurvePoint& low = *(after - 1);
  const double slope = after == points.end() ? beyond : (after->x - low.x) / (after->y - low.y);
  return {low.x + slope * (stress - low.y), slope};
}

PlasticStrain plastic_strain(const SteelDescription& steel) {
  const MaterialDescription& material = steel.material;
  if (material.law == MaterialLaw::bilinear) return bilinear(steel);
  if (!material.stress_strain.empty()) return from_points(material.stress_strain, steel.youngs_modulus);
  PlasticStrain plastic;
  plastic.coefficient = material.yield_strain - steel.yield_stress / steel.youngs_modulus;
  plastic.exponent = material.hardening_exponent.value_or(1e3);
  plastic.reference = steel.yield_stress;
  return plastic;
}

FibreCurve::FibreCurve(const SteelDescription& steel, const PlasticStrain& plastic, double hoop_stress,
                       double max_strain)
    : max_strain_(max_strain) {
  for (const double sign : {1.0, -1.0}) {
    std::vector<double>& stress = sign > 0.0 ? tension_ : compression_;
    std::vector<double>& slope = sign > 0.0 ? tension_slope_ : compression_slope_;
    // Strain is measured from the elastic state under the hoop stress alone.
    const double start = -steel.poissons_ratio * hoop_stress / steel.youngs_modulus;
    double s = 0.0;
    for (int j = 0; j <= kTable; ++j) {
      const double u = static_cast<double>(j) / kTable;
      if (j > 0) s = stress_at(steel, plastic, hoop_stress, start + sign * max_strain_ * u * u, s, sign);
      stress.push_back(s);
      slope.push_back(1.0 / axial_strain(steel, plastic, hoop_stress, s).slope);
    }
  }
}

FibreCurve::Value FibreCurve::at(double strain) const {
  const bool pulled = strain >= 0.0;
  const std::vector<double>&stress = pulled ? tension_ : compression_,
        &slope = pulled ? tension_slope_ : compression_slope_;
  const double size = std::abs(strain), sign = pulled ? 1.0 : -1.0;
  if (size >= max_strain_) {
    return {stress.back() + sign * slope.back() * (size - max_strain_), slope.back()};
  }
  const int j = std::min(static_cast<int>(kTable * std::sqrt(size / max_strain_)), kTable - 1);
  const double low = max_strain_ * j * j / (kTable * kTable),
               high = max_strain_ * (j + 1) * (j + 1) / (kTable * kTable);
  const double h = high - low, u = (size - low) / h;
  const std::size_t i = static_cast<std::size_t>(j);
  const double a = stress[i], b = stress[i + 1], da = sign * h * slope[i], db = sign * h * slope[i + 1];
  const double value = a + u * (da + u * (3.0 * (b - a) - 2.0 * da - db + u * (da + db - 2.0 * (b - a))));
  const double rate = da + u * (2.0 * (3.0 * (b - a) - 2.0 * da - db) + u * 3.0 * (da + db - 2.0 * (b - a)));
  return {value, sign * rate / h};
}

}  // namespace overbend
