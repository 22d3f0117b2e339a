#include "model/bending_law.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace overbend {
namespace {

constexpr double kOnset = 1e-4;          ///< Lack of moment, relative, at which the first spring slides.
constexpr double kLargestStrain = 0.03;  ///< At the outer fibre, where the last spring slides.
constexpr double kLeastRest = 1e-4;      ///< Of EI: a pipe never loses all stiffness.

using MomentAt = std::function<MomentPoint(double curvature, double guess)>;

/// Curvature at which the moment falls short of EI kappa by kOnset.
double onset(const MomentAt& moment, double EI, double largest) {
  double low = 0.0, high = largest;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    const bool straight = moment(middle, 0.0).moment > (1.0 - kOnset) * EI * middle;
    (straight ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

BendingLevel springs(const MomentAt& moment, double z, double EI, double elastic_strain,
                     const std::array<double, kSprings>& limit) {
  BendingLevel level;
  level.z = z;
  double last_k = limit[0], last_m = EI * limit[0], slope_before = EI;
  double guess = elastic_strain;
  for (std::size_t i = 1; i < kSprings; ++i) {
    const MomentPoint at = moment(limit[i], guess);
    guess = at.mid_strain;
    const double slope = std::clamp((at.moment - last_m) / (limit[i] - last_k), kLeastRest * EI, slope_before);
    level.stiffness[i - 1] = slope_before - slope;
    level.mid_strain[i] = at.mid_strain - elastic_strain;
    slope_before = slope;
    last_k = limit[i];
    last_m = at.moment;
  }
  level.rest = slope_before;  // the last spring would need a slope beyond the last limit: the curve goes on straight
  return level;
}

std::array<double, kSprings> geometric(double first, double last) {
  std::array<double, kSprings> limit{};
  for (std::size_t i = 0; i < kSprings; ++i) {
    limit[i] = first * std::pow(last / first, static_cast<double>(i) / (kSprings - 1));
  }
  return limit;
}

BendingLaw from_moments(const MomentAt& moment, double EI, double first, double last) {
  BendingLaw law;
  law.limit = geometric(first, last);
  law.levels.push_back(springs(moment, 0.0, EI, 0.0, law.limit));
  return law;
}

/// Straight between the points, which become limits; what springs are left stand close behind the last.
BendingLaw from_table(const SteelDescription& steel, double EI) {
  std::vector<CurvePoint> points = steel.material.moment_curvature;
  points.front().x = points.front().y / EI;  // the straight part is the section's own
  const auto moment = [&](double k, double) {
    if (k <= points.front().x || points.size() == 1) return MomentPoint{std::min(EI * k, points.front().y), 0.0};
    std::size_t i = 1;
    while (i + 1 < points.size() && points[i].x < k) ++i;
    const double share = (k - points[i - 1].x) / (points[i].x - points[i - 1].x);
    return MomentPoint{points[i - 1].y + share * (points[i].y - points[i - 1].y), 0.0};
  };
  if (points.size() > kSprings) return from_moments(moment, EI, points.front().x, points.back().x);
  BendingLaw law;
  for (std::size_t i = 0; i < kSprings; ++i) {
    law.limit[i] = i < points.size() ? points[i].x : law.limit[i - 1] * 1.1;
  }
  law.levels.push_back(springs(moment, 0.0, EI, 0.0, law.limit));
  return law;
}

BendingLaw from_form(const SteelDescription& steel, double EI) {
  const MaterialDescription& material = steel.material;
  MomentRambergOsgood form{material.moment_coefficient.value_or(0.0), material.moment_exponent.value_or(0.0)};
  if (!material.moment_coefficient) form = fit_moment_law(steel);
  const FirstYield yield = first_yield(steel);
  const auto moment = [&](double k, double) {
    return MomentPoint{yield.moment * relative_moment(form, k / yield.curvature), 0.0};
  };
  const double last = 2.0 * kLargestStrain / steel.outside_diameter;
  return from_moments(moment, EI, onset(moment, EI, 2.0 * yield.curvature), std::max(last, 4.0 * yield.curvature));
}

BendingLaw from_steel(const SteelDescription& steel, double EI, const std::vector<LevelLoads>& levels) {
  const double yield = first_yield(steel).curvature;
  const double last = std::max(2.0 * kLargestStrain / steel.outside_diameter, 4.0 * yield);
  std::vector<WallIntegral> walls;
  for (const LevelLoads& level : levels) walls.emplace_back(steel, level.wall, last);
  const auto moment_of = [](const WallIntegral& wall) {
    return [&wall](double k, double guess) { return wall.at(k, guess); };
  };
  double first = last;
  for (const WallIntegral& wall : walls) first = std::min(first, onset(moment_of(wall), EI, 2.0 * yield));
  BendingLaw law;
  law.limit = geometric(first, last);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double elastic = walls[i].at(0.0).mid_strain;
    law.levels.push_back(springs(moment_of(walls[i]), levels[i].z, EI, elastic, law.limit));
  }
  law.steel.emplace(steel, plastic_strain(steel), 0.0, 1.5 * kLargestStrain);
  return law;
}

}  // namespace

LevelMix level_at(const BendingLaw& law, double z) {
  const auto above =
      std::find_if(law.levels.begin(), law.levels.end(), [&](const BendingLevel& level) { return level.z > z; });
  if (above == law.levels.begin() || law.levels.size() == 1) return {0, 0.0};
  if (above == law.levels.end()) return {static_cast<int>(law.levels.size()) - 2, 1.0};
  const BendingLevel& below = *(above - 1);
  return {static_cast<int>(above - law.levels.begin()) - 1, (z - below.z) / (above->z - below.z)};
}

MomentPoint monotonic(const BendingLaw& law, const LevelMix& mix, double curvature) {
  const BendingLevel& lower = law.levels[static_cast<std::size_t>(mix.lower)];
  const BendingLevel& upper = law.levels[std::min(static_cast<std::size_t>(mix.lower) + 1, law.levels.size() - 1)];
  const auto between = [&](double a, double b) { return a + mix.share * (b - a); };
  MomentPoint point{between(lower.rest, upper.rest) * curvature, 0.0};
  for (std::size_t i = 0; i < kSprings; ++i) {
    point.moment += between(lower.stiffness[i], upper.stiffness[i]) * std::min(curvature, law.limit[i]);
    if (i > 0 && curvature > law.limit[i - 1]) {
      const double share = std::min(1.0, (curvature - law.limit[i - 1]) / (law.limit[i] - law.limit[i - 1]));
      const double from = between(lower.mid_strain[i - 1], upper.mid_strain[i - 1]);
      point.mid_strain = from + share * (between(lower.mid_strain[i], upper.mid_strain[i]) - from);
    }
  }
  return point;
}

std::optional<BendingLaw> bending_law(const SteelDescription& steel, const std::vector<LevelLoads>& levels) {
  const double EI = steel.youngs_modulus * second_moment(steel.outside_diameter, steel.wall_thickness);
  switch (steel.material.law) {
    case MaterialLaw::linear:
      return std::nullopt;
    case MaterialLaw::moment_ramberg_osgood:
      return from_form(steel, EI);
    case MaterialLaw::moment_curvature:
      return from_table(steel, EI);
    case MaterialLaw::ramberg_osgood:
    case MaterialLaw::bilinear:
    case MaterialLaw::stress_strain:
      return from_steel(steel, EI, levels);
  }
  return std::nullopt;
}

}  // namespace overbend
