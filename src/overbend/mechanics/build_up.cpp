#include "mechanics/build_up.h"

#include <cmath>
#include <numbers>

namespace overbend {

BuildUp half_cosine(double t, double duration) {
  if (t >= 0.0 || duration <= 0.0) {
    return {};
  }
  if (t <= -duration) {
    return {0.0, 0.0, 0.0};
  }
  const double omega = std::numbers::pi / duration;
  const double phase = omega * t;
  return {0.5 * (1.0 + std::cos(phase)), -0.5 * omega * std::sin(phase), -0.5 * omega * omega * std::cos(phase)};
}

}  // namespace overbend
