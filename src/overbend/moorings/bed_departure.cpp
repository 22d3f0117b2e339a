#include "moorings/bed_departure.h"

#include <cmath>

namespace overbend {
namespace {

constexpr double kSampleInterval = 2.0;  ///< Sampling interval [m]. Shape points on the bed may exist at its ends only.
constexpr double kContactHeight = 1e-3;  ///< Maximum height over the straight bed of a part that lies on it [m].

double level_distance(const Vec3& a, const Vec3& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

}  // namespace

BedDeparture bed_departure(const SeabedSurface& bed, const std::vector<Vec3>& shape_W) {
  BedDeparture maximum;
  if (bed.shape() == nullptr || shape_W.size() < 2) return maximum;
  const Vec3 &fairlead = shape_W.front(), &anchor = shape_W.back();
  const double total = level_distance(fairlead, anchor);
  const double under_fairlead = bed.height(fairlead.x(), fairlead.y());
  const auto look = [&](const Vec3& p) {
    const double from_anchor = level_distance(p, anchor);
    const double over_bed = p.z() - bed.height(p.x(), p.y());
    if (-over_bed > maximum.inside) {
      maximum.inside = -over_bed;
      maximum.inside_at = from_anchor;
    }
    const double straight = anchor.z() + (total > 0.0 ? from_anchor / total : 0.0) * (under_fairlead - anchor.z());
    if (p.z() - straight < kContactHeight && over_bed > maximum.over_hollow) {
      maximum.over_hollow = over_bed;
      maximum.hollow_at = from_anchor;
    }
  };
  for (std::size_t i = 1; i < shape_W.size(); ++i) {
    const Vec3 &a = shape_W[i - 1], &b = shape_W[i];
    const int parts = 1 + static_cast<int>(level_distance(a, b) / kSampleInterval);
    for (int k = 1; k <= parts; ++k) look(a + (static_cast<double>(k) / parts) * (b - a));
  }
  return maximum;
}

}  // namespace overbend
