#include "mechanics/ground.h"

namespace overbend {
namespace {

Vec3 vector_of(const double (&v)[3]) {
  return {v[0], v[1], v[2]};
}

}  // namespace

GroundPoint ground_at(const LineEnvironment& env, const Vec3& r) {
  GroundPoint at;
  at.normal = vector_of(env.bed_normal);
  at.clearance = at.normal.dot(r) - env.bed_offset;
  at.across_route = vector_of(env.route_normal);
  at.off_route = at.across_route.dot(r) - env.route_offset;
  at.along_route = vector_of(env.bed_along);
  return at;
}

}  // namespace overbend
