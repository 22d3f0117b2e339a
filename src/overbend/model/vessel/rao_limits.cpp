#include "model/vessel/rao_limits.h"

#include <fmt/core.h>

#include <cmath>
#include <set>

#include "base/constants.h"
#include "model/waves/wave_theory.h"

namespace overbend {
namespace {

using Complex = std::complex<double>;

/// Ratio of horizontal orbit to surface amplitude, mean from the surface to the draught: mean of cosh k(z+d)/sinh kd.
double mean_orbit(double k, double draught, double depth) {
  const double t = std::min(draught, depth);
  if (t <= 0.0) return 1.0 / std::tanh(k * depth);
  const double lower = std::exp(-k * t) * (1.0 - std::exp(-2.0 * k * (depth - t))) / (1.0 - std::exp(-2.0 * k * depth));
  return (1.0 - lower) / (k * t);  // (sinh kd - sinh k(d-t)) / (k t sinh kd), without overflow
}

/// Response of a point that moves with the water, per unit amplitude, crest at the wave origin at t = 0.
RaoTable::Response water_response(const RaoTable& raos, double heading, double k, double orbit) {
  const Vec3 travel(std::cos(heading), std::sin(heading), 0.0);
  const Complex later = std::polar(1.0, -k * travel.dot(raos.reference_V - raos.wave_origin_V));
  const Complex behind(0.0, -1.0);  // lag of a quarter period
  return {later * behind * orbit * travel.x(), later * behind * orbit * travel.y(), later,
          later * behind * k * travel.y(),     -later * behind * k * travel.x(),    0.0};
}

bool agree(double ratio, double difference) {
  return ratio > 0.5 && ratio < 2.0 && std::abs(std::remainder(difference, 2.0 * kPi)) < kPi / 3.0;
}

}  // namespace

RaoLimits long_wave_limits(const RaoTable& raos, double vessel_length, double draught, double depth) {
  RaoLimits limits;
  limits.omega = raos.omegas.front();
  const double k = linear_wave_number(limits.omega, depth);
  limits.wave_length = 2.0 * kPi / k;
  limits.long_enough = limits.wave_length >= 4.0 * vessel_length;
  const double orbit = mean_orbit(k, draught, depth);
  for (const double heading : {0.0, 0.5 * kPi, kPi}) {
    const RaoTable::Response response = raos.at(heading, limits.omega);
    const RaoTable::Response water = water_response(raos, heading, k, orbit);
    for (std::size_t i = 0; i < 5; ++i) {
      if (std::abs(water[i]) < 1e-3 * (i < 3 ? 1.0 : k)) continue;  // zero by symmetry
      RaoLimitRow row{heading,
                      static_cast<int>(i),
                      std::abs(response[i]) / std::abs(water[i]),
                      -std::arg(response[i]),
                      -std::arg(water[i]),
                      true};
      row.agrees = agree(row.ratio, row.lag - row.expected_lag);
      limits.rows.push_back(row);
    }
  }
  return limits;
}

Findings limit_findings(const RaoLimits& limits) {
  Findings findings;
  if (!limits.long_enough) return findings;
  // Mirrored headings are equivalent for a degree of freedom: it is reported for the first only.
  std::set<int> reported;
  for (const RaoLimitRow& row : limits.rows) {
    if (row.agrees || !reported.insert(row.freedom).second) continue;
    std::string headings;
    for (const RaoLimitRow& other_row : limits.rows) {
      if (other_row.agrees || other_row.freedom != row.freedom) continue;
      headings += fmt::format("{}{:.0f}", headings.empty() ? "" : " and ", other_row.heading * kToDegrees);
    }
    findings.push_back(Finding{
        FindingCode::rao_conventions,
        fmt::format("RAOs: in long waves travelling towards {} deg {} is {:.2f} times the water motion, with a lag of "
                    "{:.0f} deg; a free hull has {:.0f} deg: check the conventions (vessel.motion.convention)",
                    headings, kFreedomNames[static_cast<std::size_t>(row.freedom)], row.ratio, row.lag * kToDegrees,
                    row.expected_lag * kToDegrees)}
                           .on("RAO of " + std::string(kFreedomNames[static_cast<std::size_t>(row.freedom)]))
                           .with("ratio", row.ratio, "1"));
  }
  return findings;
}

}  // namespace overbend
