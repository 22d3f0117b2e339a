#include "moorings/clearance.h"

#include <algorithm>
#include <limits>

namespace overbend {

double segment_distance(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
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

double polyline_distance(const std::vector<Vec3>& first, const std::vector<Vec3>& second) {
  double min_distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::max<std::size_t>(first.size(), 2) - 1 && !first.empty(); ++i) {
    for (std::size_t k = 0; k < std::max<std::size_t>(second.size(), 2) - 1 && !second.empty(); ++k) {
      const Vec3 &a = first[i], &b = second[k];
      const Vec3& a1 = i + 1 < first.size() ? first[i + 1] : a;
      const Vec3& b1 = k + 1 < second.size() ? second[k + 1] : b;
      min_distance = std::min(min_distance, segment_distance(a, a1, b, b1));
    }
  }
  return min_distance;
}

}  // namespace overbend
