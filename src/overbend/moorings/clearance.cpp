#include "moorings/clearance.h"

#include <algorithm>
#include <limits>

namespace overbend {

double distance_of_stretches(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  const Vec3 a = a1 - a0, b = b1 - b0, from = a0 - b0;
  const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b), af = a.dot(from), bf = b.dot(from);
  double s = 0.0, t = 0.0;
  const double cross = aa * bb - ab * ab;
  if (cross > 1e-14 * aa * bb) s = std::clamp((ab * bf - af * bb) / cross, 0.0, 1.0);
  if (bb > 0.0) t = std::clamp((ab * s + bf) / bb, 0.0, 1.0);
  if (aa > 0.0) s = std::clamp((ab * t - af) / aa, 0.0, 1.0);
  if (bb > 0.0) t = std::clamp((ab * s + bf) / bb, 0.0, 1.0);
  return (from + s * a - t * b).norm();
}

double distance_between(const std::vector<Vec3>& one, const std::vector<Vec3>& other) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::max<std::size_t>(one.size(), 2) - 1 && !one.empty(); ++i) {
    for (std::size_t k = 0; k < std::max<std::size_t>(other.size(), 2) - 1 && !other.empty(); ++k) {
      const Vec3 &a = one[i], &b = other[k];
      const Vec3& a1 = i + 1 < one.size() ? one[i + 1] : a;
      const Vec3& b1 = k + 1 < other.size() ? other[k + 1] : b;
      least = std::min(least, distance_of_stretches(a, a1, b, b1));
    }
  }
  return least;
}

}  // namespace overbend
