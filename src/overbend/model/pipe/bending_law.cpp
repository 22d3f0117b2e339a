#include "model/pipe/bending_law.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "base/nonnegative_fit.h"
#include "base/require.h"

namespace overbend {
namespace {

constexpr double kOnset = 1e-4;                 ///< Relative moment deficit at which the first sliders slide.
constexpr double kMaxFitStrain = 0.03;          ///< Outer-fibre strain up to which the springs are fitted.
constexpr double kMinStiffnessFraction = 1e-4;  ///< Fraction of EI: a pipe never loses all stiffness.
constexpr int kFitPoints = 40;

using MomentAt = std::function<MomentPoint(double curvature, double guess)>;

/// Curvature range of a fit.
struct FitRange {
  double first = 0.0, last = 0.0;  ///< Onset of yielding and max. curvature [1/m].
};

/// Returns the curvature at which the moment is below EI kappa by the fraction kOnset.
double onset(const MomentAt& moment, double EI, double max_curvature) {
  double low = 0.0, high = max_curvature;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    const bool straight = moment(middle, 0.0).moment > (1.0 - kOnset) * EI * middle;
    (straight ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Returns the reduction of the elastic moment by the sliders with one limit in all directions, for unit stiffness,
/// bent along a d_j (`turn` 0) or between two (0.5).
double moment_reduction(double limit, double curvature, double turn) {
  double sum = 0.0;
  for (int j = 0; j < kDirections; ++j) {
    const double c = std::cos(std::numbers::pi * (j + 0.5 + turn) / kDirections);
    sum += std::abs(c) * std::max(0.0, curvature * std::abs(c) - limit);
  }
  return sum;
}

double moment_reduction(double limit, double curvature) {
  return 0.5 * (moment_reduction(limit, curvature, 0.0) + moment_reduction(limit, curvature, 0.5));
}

/// Chooses limits close together where the curve bends most, just beyond onset.
void set_limits(BendingLaw& law, const FitRange& range) {
  for (std::size_t i = 0; i < kSliders; ++i) {
    const double u = static_cast<double>(i) / kSliders;
    law.limit[i] = range.first * std::pow(range.last / range.first, u * u);
  }
  for (std::size_t i = 0; i < kStrainPoints; ++i) {
    law.curvature[i] = range.first * std::pow(range.last / range.first, static_cast<double>(i) / (kStrainPoints - 1));
  }
}

std::vector<double> fit_curvatures(const FitRange& range) {
  std::vector<double> k;
  for (int i = 1; i <= kFitPoints; ++i) {
    k.push_back(range.first * std::pow(range.last / range.first, static_cast<double>(i) / kFitPoints));
  }
  return k;
}

/// Least-squares fit of the relative moment deficit.
std::array<double, kSliders> fit_stiffness(const BendingLaw& law, const std::vector<double>& k,
                                           const std::vector<double>& moment) {
  Eigen::MatrixXd A(kFitPoints, kSliders);
  Eigen::VectorXd b(kFitPoints);
  for (int p = 0; p < kFitPoints; ++p) {
    const std::size_t index = static_cast<std::size_t>(p);
    for (int i = 0; i < kSliders; ++i) {
      A(p, i) = moment_reduction(law.limit[static_cast<std::size_t>(i)], k[index]) / moment[index];
    }
    b(p) = law.EI * k[index] / moment[index] - 1.0;
  }
  const Eigen::VectorXd x = nonnegative_fit(A, b);
  const double all = 0.5 * kDirections * x.sum(), max_total = (1.0 - kMinStiffnessFraction) * law.EI;
  std::array<double, kSliders> stiffness{};
  for (int i = 0; i < kSliders; ++i) {
    stiffness[static_cast<std::size_t>(i)] = x(i) * (all > max_total ? max_total / all : 1.0);
  }
  return stiffness;
}

void add_level(BendingLaw& law, const MomentAt& moment, double z, double elastic_strain, const FitRange& range) {
  BendingLevel level;
  level.z = z;
  double guess = elastic_strain;
  for (std::size_t i = 0; i < kStrainPoints; ++i) {
    guess = moment(law.curvature[i], guess).mid_strain;
    level.mid_strain[i] = guess - elastic_strain;
  }
  const std::vector<double> k = fit_curvatures(range);
  std::vector<double> m;
  guess = elastic_strain;
  for (const double curvature : k) {
    const MomentPoint point = moment(curvature, guess);
    m.push_back(point.moment);
    guess = point.mid_strain;
  }
  level.stiffness = fit_stiffness(law, k, m);
  law.levels.push_back(level);
  const LevelMix mix{static_cast<int>(law.levels.size()) - 1, 0.0};
  for (std::size_t i = 0; i < k.size(); ++i) {
    law.fit_error = std::max(law.fit_error, std::abs(monotonic(law, mix, k[i]).moment / m[i] - 1.0));
  }
}

BendingLaw from_moments(const MomentAt& moment, double EI, const FitRange& range) {
  BendingLaw law;
  law.EI = EI;
  set_limits(law, range);
  add_level(law, moment, 0.0, 0.0, range);
  return law;
}

BendingLaw from_table(const SteelDescription& steel) {
  const std::vector<CurvePoint>& points = steel.material.moment_curvature;
  require(!points.empty(), "a law by a table has points");
  const double EI = elastic_bending_stiffness(steel);
  const auto moment = [&](double k, double) {
    if (k <= points.front().x || points.size() == 1) return MomentPoint{std::min(EI * k, points.front().y), 0.0};
    std::size_t i = 1;
    while (i + 1 < points.size() && points[i].x < k) ++i;
    const double share = (k - points[i - 1].x) / (points[i].x - points[i - 1].x);
    return MomentPoint{points[i - 1].y + share * (points[i].y - points[i - 1].y), 0.0};
  };
  return from_moments(moment, EI, {points.front().x, std::max(points.back().x, 2.0 * points.front().x)});
}

BendingLaw from_form(const SteelDescription& steel, double EI) {
  const MaterialDescription& material = steel.material;
  MomentRambergOsgood form{material.moment_coefficient.value_or(0.0), material.moment_exponent.value_or(0.0)};
  if (!material.moment_coefficient) form = fit_moment_law(steel);
  const FirstYield yield = first_yield(steel);
  const auto moment = [&](double k, double) {
    return MomentPoint{yield.moment * relative_moment(form, k / yield.curvature), 0.0};
  };
  const double last = std::max(2.0 * kMaxFitStrain / steel.outside_diameter, 4.0 * yield.curvature);
  return from_moments(moment, EI, {onset(moment, EI, 2.0 * yield.curvature), last});
}

BendingLaw from_steel(const SteelDescription& steel, double EI, const std::vector<LevelLoads>& levels) {
  const double yield = first_yield(steel).curvature;
  FitRange range;
  range.last = std::max(2.0 * kMaxFitStrain / steel.outside_diameter, 4.0 * yield);
  std::vector<WallIntegral> walls;
  for (const LevelLoads& level : levels) walls.emplace_back(steel, level.wall, range.last);
  const auto make_moment_curve = [](const WallIntegral& wall) {
    return [&wall](double k, double guess) { return wall.at(k, guess); };
  };
  range.first = range.last;
  for (const WallIntegral& wall : walls) {
    range.first = std::min(range.first, onset(make_moment_curve(wall), EI, 2.0 * yield));
  }
  BendingLaw law;
  law.EI = EI;
  set_limits(law, range);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    add_level(law, make_moment_curve(walls[i]), levels[i].z, walls[i].at(0.0).mid_strain, range);
  }
  law.steel.emplace(steel, plastic_strain(steel), 0.0, 1.5 * kMaxFitStrain);
  return law;
}

}  // namespace

const Directions& directions() {
  static const Directions all = [] {
    Directions d{};
    for (std::size_t j = 0; j < kDirections; ++j) {
      const double angle = std::numbers::pi * (static_cast<double>(j) + 0.5) / kDirections;
      d.x[j] = std::cos(angle);
      d.y[j] = std::sin(angle);
    }
    return d;
  }();
  return all;
}

LevelMix level_at(const BendingLaw& law, double z) {
  const auto above =
      std::find_if(law.levels.begin(), law.levels.end(), [&](const BendingLevel& level) { return level.z > z; });
  if (above == law.levels.begin() || law.levels.size() == 1) return {0, 0.0};
  if (above == law.levels.end()) return {static_cast<int>(law.levels.size()) - 2, 1.0};
  const BendingLevel& below = *(above - 1);
  return {static_cast<int>(above - law.levels.begin()) - 1, (z - below.z) / (above->z - below.z)};
}

namespace {

/// Interpolates the levels at both ends of a mix.
class InterpolatedLevel {
 public:
  InterpolatedLevel(const BendingLaw& law, const LevelMix& mix)
      : lower_(law.levels[static_cast<std::size_t>(mix.lower)]),
        upper_(law.levels[std::min(static_cast<std::size_t>(mix.lower) + 1, law.levels.size() - 1)]),
        share_(mix.share) {}
  double stiffness(std::size_t slider) const { return mixed(lower_.stiffness[slider], upper_.stiffness[slider]); }
  double mid_strain(std::size_t index) const { return mixed(lower_.mid_strain[index], upper_.mid_strain[index]); }

 private:
  double mixed(double a, double b) const { return a + share_ * (b - a); }

  const BendingLevel &lower_, &upper_;
  double share_;
};

}  // namespace

double axis_strain(const BendingLaw& law, const LevelMix& mix, double curvature) {
  if (!(curvature > law.curvature.front())) return 0.0;
  const InterpolatedLevel between(law, mix);
  const auto after = std::lower_bound(law.curvature.begin(), law.curvature.end() - 1, curvature);
  const std::size_t i = static_cast<std::size_t>(after - law.curvature.begin());
  const double share = (curvature - law.curvature[i - 1]) / (law.curvature[i] - law.curvature[i - 1]);
  const double below = between.mid_strain(i - 1);
  return below + std::min(share, 1.0) * (between.mid_strain(i) - below);
}

MomentPoint monotonic(const BendingLaw& law, const LevelMix& mix, double curvature) {
  const InterpolatedLevel between(law, mix);
  MomentPoint point{law.EI * curvature, axis_strain(law, mix, curvature)};
  for (std::size_t i = 0; i < kSliders; ++i) {
    point.moment -= between.stiffness(i) * moment_reduction(law.limit[i], curvature);
  }
  return point;
}

double elastic_bending_stiffness(const SteelDescription& steel) {
  const std::vector<CurvePoint>& points = steel.material.moment_curvature;
  if (steel.material.law == MaterialLaw::moment_curvature && !points.empty()) {
    return points.front().y / points.front().x;
  }
  return steel.youngs_modulus * second_moment(steel.outside_diameter, steel.wall_thickness);
}

std::optional<BendingLaw> bending_law(const SteelDescription& steel, const std::vector<LevelLoads>& levels) {
  const double EI = elastic_bending_stiffness(steel);
  switch (steel.material.law) {
    case MaterialLaw::linear:
      return std::nullopt;
    case MaterialLaw::moment_ramberg_osgood:
      return from_form(steel, EI);
    case MaterialLaw::moment_curvature:
      return from_table(steel);
    case MaterialLaw::ramberg_osgood:
    case MaterialLaw::bilinear:
    case MaterialLaw::stress_strain:
      return from_steel(steel, EI, levels);
  }
  return std::nullopt;
}

}  // namespace overbend
