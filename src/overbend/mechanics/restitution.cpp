#include "mechanics/restitution.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace overbend {
namespace {

/// Returns contact time times natural frequency over two: acos(zeta)/sqrt(1 - zeta^2), continued beyond critical
/// damping.
double half_contact_time(double zeta) {
  const double below = 1.0 - zeta;
  if (std::abs(below) < 1e-4) {  // both forms are 0/0 at critical damping; the next term of the series is below 1e-13
    return 1.0 + below / 3.0 + 2.0 / 15.0 * below * below;
  }
  const double root = std::sqrt(std::abs(below) * (1.0 + zeta));
  return (zeta < 1.0 ? std::acos(zeta) : std::acosh(zeta)) / root;
}

double textbook_ratio(double restitution) {
  if (restitution <= 0.0) {
    return 1.0;
  }
  const double log = std::log(restitution);
  return -log / std::hypot(std::numbers::pi, log);
}

double clipped_ratio(double restitution) {
  double low = 0.0;
  double high = kMaxDampingRatio;
  if (restitution <= compute_restitution(high)) {
    return high;
  }
  // Restitution decreases monotonically with damping: bisection is safe, and 60 halvings reach rounding accuracy.
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (compute_restitution(middle) > restitution ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double compute_restitution(double damping_ratio) {
  return std::exp(-2.0 * damping_ratio * half_contact_time(damping_ratio));
}

double damping_ratio(double restitution, RestitutionForm form) {
  if (restitution >= 1.0) {
    return 0.0;
  }
  return form == RestitutionForm::clipped ? clipped_ratio(restitution) : textbook_ratio(restitution);
}

}  // namespace overbend
