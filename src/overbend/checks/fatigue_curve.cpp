#include "checks/fatigue_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace overbend {
namespace {

/// Row of the tables: in air, in seawater with cathodic protection, in free corrosion.
struct Row {
  FatigueCurve curve;
  double slope, air, air_below, protected_water, free_water, thickness_exponent;
};

constexpr std::array<Row, 14> kRows = {{
    {FatigueCurve::b1, 4.0, 15.117, 17.146, 14.917, 12.436, 0.0},
    {FatigueCurve::b2, 4.0, 14.885, 16.856, 14.685, 12.262, 0.0},
    {FatigueCurve::c, 3.0, 12.592, 16.320, 12.192, 12.115, 0.05},
    {FatigueCurve::c1, 3.0, 12.449, 16.081, 12.049, 11.972, 0.10},
    {FatigueCurve::c2, 3.0, 12.301, 15.835, 11.901, 11.824, 0.15},
    {FatigueCurve::d, 3.0, 12.164, 15.606, 11.764, 11.687, 0.20},
    {FatigueCurve::e, 3.0, 12.010, 15.350, 11.610, 11.533, 0.20},
    {FatigueCurve::f, 3.0, 11.855, 15.091, 11.455, 11.378, 0.25},
    {FatigueCurve::f1, 3.0, 11.699, 14.832, 11.299, 11.222, 0.25},
    {FatigueCurve::f3, 3.0, 11.546, 14.576, 11.146, 11.068, 0.25},
    {FatigueCurve::g, 3.0, 11.398, 14.330, 10.998, 10.921, 0.25},
    {FatigueCurve::w1, 3.0, 11.261, 14.101, 10.861, 10.784, 0.25},
    {FatigueCurve::w2, 3.0, 11.107, 13.845, 10.707, 10.630, 0.25},
    {FatigueCurve::w3, 3.0, 10.970, 13.617, 10.570, 10.493, 0.25},
}};

/// Curves with other constants in the edition of October 2024, in air and in seawater with cathodic protection. The
/// thickness exponents of C and C1 are the larger ones of the older editions: no value was found for 2024.
struct NewRow {
  FatigueCurve curve;
  double slope, air, air_below, protected_water, protected_below, thickness_exponent;
};

constexpr std::array<NewRow, 5> kRows2024 = {{
    {FatigueCurve::b1, 4.0, 15.117, 17.146, 14.977, 17.222, 0.0},
    {FatigueCurve::b2, 4.0, 14.885, 16.856, 14.745, 16.931, 0.0},
    {FatigueCurve::c, 3.5, 13.640, 16.615, 13.431, 16.615, 0.15},
    {FatigueCurve::c1, 3.5, 13.473, 16.377, 13.264, 16.377, 0.15},
    {FatigueCurve::c2, 3.5, 13.301, 16.130, 13.091, 16.130, 0.15},
}};

constexpr double kMega = 1e6;
constexpr double kSlopeBelow = 5.0;
constexpr double kFreeSlope = 3.0;             ///< Slope of every curve in free corrosion, for all ranges.
constexpr double kReferenceThickness = 0.025;  ///< [m]

const Row& find_curve_row(FatigueCurve curve) {
  return kRows[static_cast<std::size_t>(curve)];
}

/// Returns constants in air and in protected seawater. In the edition of 2016 the lower line is the same in both.
NewRow find_curve_row(FatigueCurve curve, FatigueEdition edition) {
  const auto changed = [&](const NewRow& row) { return row.curve == curve; };
  const auto* row = std::find_if(kRows2024.begin(), kRows2024.end(), changed);
  if (edition == FatigueEdition::year_2024 && row != kRows2024.end()) return *row;
  const Row& old = find_curve_row(curve);
  return {curve, old.slope, old.air, old.air_below, old.protected_water, old.air_below, old.thickness_exponent};
}

constexpr bool in_order() {
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    if (static_cast<std::size_t>(kRows[i].curve) != i) return false;
  }
  return true;
}
static_assert(in_order());

/// Returns the stress range with a life of 1/damage.
double on_line(double log_a, double slope, double damage) {
  return kMega * std::pow(10.0, (log_a + std::log10(damage)) / slope);
}

double damage_by(double log_a, double slope, double range) {
  return std::pow(range / kMega, slope) * std::pow(10.0, -log_a);
}

}  // namespace

double SnCurve::damage(double range) const {
  if (range <= 0.0) return 0.0;
  return range < knee ? damage_by(log_a_below, slope_below, range) : damage_by(log_a, slope, range);
}

double SnCurve::find_range(double damage) const {
  if (damage <= 0.0) return 0.0;
  const double above = on_line(log_a, slope, damage);
  return above < knee ? on_line(log_a_below, slope_below, damage) : above;
}

const char* fatigue_code(FatigueEdition edition) {
  return edition == FatigueEdition::year_2024 ? "DNV-RP-C203 (2024)" : "DNV-RP-C203 (2016)";
}

SnCurve sn_curve(FatigueCurve curve, FatigueMedium medium, FatigueEdition edition) {
  const NewRow row = find_curve_row(curve, edition);
  SnCurve out;
  out.thickness_exponent = row.thickness_exponent;
  if (medium == FatigueMedium::seawater_free) {
    out.slope = kFreeSlope;
    out.log_a = find_curve_row(curve).free_water;
    return out;
  }
  const bool air = medium == FatigueMedium::air;
  out.slope = row.slope;
  out.log_a = air ? row.air : row.protected_water;
  out.slope_below = kSlopeBelow;
  out.log_a_below = air ? row.air_below : row.protected_below;
  out.knee = kMega * std::pow(10.0, (out.log_a_below - out.log_a) / (out.slope_below - out.slope));
  return out;
}

double thickness_effect(const SnCurve& curve, double thickness) {
  return thickness > kReferenceThickness ? std::pow(thickness / kReferenceThickness, curve.thickness_exponent) : 1.0;
}

double hi_lo_factor(double hi_lo, double diameter, double thickness) {
  return 1.0 + 3.0 * hi_lo / thickness * std::exp(-std::sqrt(thickness / diameter));
}

}  // namespace overbend
