#include "hull/slow_motion.h"

#include <cmath>
#include <numbers>

namespace overbend {
namespace {

Vec3 followed(const Vec6& h) {
  return {h(0), h(1), h(5)};
}

}  // namespace

SlowMotion slow_motion_at_rest(const Vec6& h) {
  return {followed(h), Vec3::Zero()};
}

SlowMotion slow_motion_after(const SlowMotion& before, const Vec6& h0, const Vec6& h1, double step, double period) {
  if (step <= 0.0) return before;
  const double w = 2.0 * std::numbers::pi / period;
  // For x = x0 + s t the filter ends up behind by 2 s / w; the initial deviation decays as (a + b t) exp(-w t).
  const Vec3 x0 = followed(h0), x1 = followed(h1), slope = (x1 - x0) / step;
  const Vec3 a = before.value - (x0 - 2.0 / w * slope);
  const Vec3 b = before.rate - slope + w * a;
  const double decay = std::exp(-w * step);
  return {x1 - 2.0 / w * slope + decay * (a + step * b), slope + decay * (b - w * (a + step * b))};
}

}  // namespace overbend
