/// Bed and route under a batch of points: the one place where the kernel computes them. For line_kernel.cpp alone.
///
/// Loads take the bed for flat where they touch it: the derivative of the normal is left out, which is exact for a
/// plane. A bed with curvature adds it to BedUnder and to the loads' tangents.
#pragma once

#include "mechanics/line_kernel_batch.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

struct BedUnder {
  Vec normal;
  Lanes clearance;  ///< Of the axis from the bed, along its normal [m].
};

inline BedUnder bed_under(const LineEnvironment& env, const Vec& r) {
  const Vec n{all(env.bed_normal[0]), all(env.bed_normal[1]), all(env.bed_normal[2])};
  return {n, dot(n, r) - env.bed_offset};
}

/// Horizontal unit vector across the route, to port, at the point of the route nearest to r.
inline Vec across_route(const LineEnvironment& env, const Vec& /*r*/) {
  return {all(env.route_normal[0]), all(env.route_normal[1]), all(env.route_normal[2])};
}

/// Distance from the route, to port [m].
inline Lanes off_route(const LineEnvironment& env, const Vec& r) {
  return dot(across_route(env, r), r) - env.route_offset;
}

/// Unit vector on the bed along the route, away from the barge.
inline Vec along_route(const LineEnvironment& env, const Vec& /*r*/) {
  return {all(env.bed_along[0]), all(env.bed_along[1]), all(env.bed_along[2])};
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
