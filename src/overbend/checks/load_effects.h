/// Design load effects of DNV-ST-F101 sec. 4: functional parts are the static state, environmental parts the change in
/// time. Table 4-4, verified against one public restatement; the factor of a favourable environmental load effect
/// against none (docs/theory/checks.md).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/vec.h"
#include "checks/load_factors.h"

namespace overbend {

/// Combination b, the local check, always: 1.1 and 1.3. `condition` is the condition factor gamma_C.
inline LoadFactors local_check_factors(double condition) {
  return {1.1 * condition, condition / 1.1, 1.3, 1.0 / 1.3};
}

/// Combination a, the system check, if system effects are present: 1.2 and 0.7. Favourable effects are treated as in
/// the local check.
inline LoadFactors system_check_factors(double condition) {
  return {1.2 * condition, condition / 1.1, 0.7, 0.7};
}

/// Returns the maximum |gamma_F a + gamma_E b| over unfavourable and favourable factors: the worst case is a corner.
/// [unit of a]
inline double design_size(const LoadFactors& f, const Vec3& functional, const Vec3& environmental) {
  const double a = functional.squaredNorm(), b = environmental.squaredNorm(), ab = functional.dot(environmental);
  const auto squared = [&](double F, double E) { return F * F * a + 2.0 * F * E * ab + E * E * b; };
  const double with_unfavourable =
      std::max(squared(f.functional, f.environmental), squared(f.functional_favourable, f.environmental));
  const double with_favourable = std::max(squared(f.functional, f.environmental_favourable),
                                          squared(f.functional_favourable, f.environmental_favourable));
  return std::sqrt(std::max(0.0, std::max(with_unfavourable, with_favourable)));
}

/// Returns the scalar value of maximum magnitude, with its sign. [unit of a]
inline double design_value(const LoadFactors& f, double functional, double environmental) {
  double worst = 0.0;
  for (const double F : {f.functional, f.functional_favourable}) {
    for (const double E : {f.environmental, f.environmental_favourable}) {
      const double value = F * functional + E * environmental;
      if (std::abs(value) > std::abs(worst)) worst = value;
    }
  }
  return worst;
}

/// Transports a vector across the pipe with tangent `from` to the pipe with tangent `to` by the smallest rotation (both
/// unit): the remaining difference is a change of the load effect, not of the pipe's direction.
inline Vec3 transported(const Vec3& v, const Vec3& from, const Vec3& to) {
  const double opposite = 1.0 + from.dot(to);
  return opposite > 1e-6 ? Vec3(v - (v.dot(to) / opposite) * (from + to)) : v;
}

}  // namespace overbend
