#include "model/vessel/box_row.h"

#include <cmath>

namespace overbend {

BoxPlace along_arc(const BoxPlace& from, double radius, double distance) {
  const double turn = distance / radius;
  const double half = 0.5 * turn;
  const double chord = half == 0.0 ? distance : distance * std::sin(half) / half;
  const double along = from.incline + half;
  return {from.x + chord * std::cos(along), from.z - chord * std::sin(along), from.incline + turn};
}

BoxPlace box_of_row(const BoxRowDescription& row, double radius, int index) {
  return along_arc({row.first.x, row.first.z, row.incline}, radius, index * row.spacing);
}

}  // namespace overbend
