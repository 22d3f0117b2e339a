#include "seafiles/rao_symmetry.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/constants.h"

namespace overbend {
namespace {

constexpr double kSameHeading = 1e-7;                 // [rad]
constexpr int kHeadingsOfACircle = 72;                // every 5 deg: linear interpolation is accurate to 0.1 %
using Responses = std::vector<std::complex<double>>;  ///< Responses at one heading: [omega][6].

double wrapped(double heading) {
  const double turned = heading - kTurn * std::floor(heading / kTurn);
  return kTurn - turned < kSameHeading ? 0.0 : turned;
}

Responses responses(const RaoTable& table, std::size_t heading) {
  const auto first = table.values.begin() + static_cast<std::ptrdiff_t>(heading * table.omegas.size() * 6);
  return {first, first + static_cast<std::ptrdiff_t>(table.omegas.size() * 6)};
}

/// Mirrors responses at midship: surge, pitch and yaw change sign.
Responses mirrored_at_midship(Responses values) {
  constexpr std::array<double, 6> kSigns = {-1.0, 1.0, 1.0, 1.0, -1.0, -1.0};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] *= kSigns[i % 6];
  return values;
}

/// Rotates the responses of a circular vessel to waves turned by `angle` [rad].
Responses turned_by(Responses values, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (std::size_t i = 0; i < values.size(); i += 3) {  // translations and rotations both transform as vectors
    const std::complex<double> x = values[i], y = values[i + 1];
    values[i] = c * x - s * y;
    values[i + 1] = s * x + c * y;
  }
  return values;
}

void set_headings(RaoTable& table, const std::map<double, Responses>& by_heading) {
  table.headings.clear();
  table.values.clear();
  for (const auto& [heading, values] : by_heading) {
    if (!table.headings.empty() && heading - table.headings.back() < kSameHeading) continue;
    table.headings.push_back(heading);
    table.values.insert(table.values.end(), values.begin(), values.end());
  }
}

}  // namespace

void complete_by_symmetry(RaoTable& table, RaoSymmetry symmetry) {
  std::map<double, Responses> by_heading;
  for (std::size_t i = 0; i < table.headings.size(); ++i) by_heading.emplace(table.headings[i], responses(table, i));
  const std::map<double, Responses> known = by_heading;
  if (symmetry == RaoSymmetry::fore_aft || symmetry == RaoSymmetry::quarters) {
    for (const auto& [heading, values] : known) by_heading.emplace(wrapped(kPi - heading), mirrored_at_midship(values));
  } else if (symmetry == RaoSymmetry::circular && known.size() == 1) {
    const auto& [first, values] = *known.begin();
    for (int i = 1; i < kHeadingsOfACircle; ++i) {
      const double angle = kTurn * i / kHeadingsOfACircle;
      by_heading.emplace(wrapped(first + angle), turned_by(values, angle));
    }
  } else {
    return;
  }
  set_headings(table, by_heading);
}

}  // namespace overbend
