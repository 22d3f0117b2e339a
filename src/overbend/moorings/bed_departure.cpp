#include "moorings/bed_departure.h"

#include <cmath>

namespace overbend {
namespace {

constexpr double kLooksEvery = 2.0;  ///< [m] A shape's points on the bed may stand at its ends alone.
constexpr double kLies = 1e-3;       ///< Nearer than this to the straight bed a line lies on it [m].

double level_distance(const Vec3& a, const Vec3& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

}  // namespace

BedDeparture bed_departure(const BedSurface& bed, const std::vector<Vec3>& shape_W) {
  BedDeparture most;
  if (bed.shape() == nullptr || shape_W.size() < 2) return most;
  const Vec3 &fairlead = shape_W.front(), &anchor = shape_W.back();
  const double whole = level_distance(fairlead, anchor);
  const double under_fairlead = bed.height(fairlead.x(), fairlead.y());
  const auto look = [&](const Vec3& p) {
    const double from_anchor = level_distance(p, anchor);
    const double over_bed = p.z() - bed.height(p.x(), p.y());
    if (-over_bed > most.inside) {
      most.inside = -over_bed;
      most.inside_at = from_anchor;
    }
    const double straight = anchor.z() + (whole > 0.0 ? from_anchor / whole : 0.0) * (under_fairlead - anchor.z());
    if (p.z() - straight < kLies && over_bed > most.over_hollow) {
      most.over_hollow = over_bed;
      most.hollow_at = from_anchor;
    }
  };
  for (std::size_t i = 1; i < shape_W.size(); ++i) {
    const Vec3 &a = shape_W[i - 1], &b = shape_W[i];
    const int parts = 1 + static_cast<int>(level_distance(a, b) / kLooksEvery);
    for (int k = 1; k <= parts; ++k) look(a + (static_cast<double>(k) / parts) * (b - a));
  }
  return most;
}

}  // namespace overbend
