#include "mechanics/mobilised_friction.h"

namespace overbend {
namespace {

using ByUnknowns = Eigen::Matrix<double, 3, 12>;

/// Derivative, with the unknowns, of a field at the material point: `values` are its shape functions, `slope` its
/// derivative along the pipe, `place` the derivative of the point's position.
ByUnknowns change(const Eigen::Vector4d& values, const Vec3& slope, const ElementVector& place) {
  ByUnknowns m = slope * place.transpose();
  for (int j = 0; j < 4; ++j) m.block<3, 3>(0, 3 * j) += values(j) * Mat3::Identity();
  return m;
}

ByUnknowns cross(const Vec3& a, const ByUnknowns& m) {
  ByUnknowns out;
  for (int i = 0; i < 12; ++i) out.col(i) = a.cross(Vec3(m.col(i)));
  return out;
}

}  // namespace

ElementMatrix mobilised_friction_tangent(const PlacedRoller& roller, const ClosestPoint& closest,
                                         const RollerDistance& distance, const RollerDistanceDerivatives& derivatives,
                                         const ElementVector& q, double length, const MobilisedFrictionForce& force) {
  const HermiteValues n = hermite(closest.xi, length);
  const CentrelinePoint point = centreline(q, closest.xi, length);
  const Vec3 d = distance.direction, t = point.a.normalized(), l = d.cross(t);
  const Mat3 projected =
      closest.beyond_face ? Mat3(Mat3::Identity()) : Mat3(Mat3::Identity() - roller.axis * roller.axis.transpose());
  const ByUnknowns turn_t =
      (Mat3::Identity() - t * t.transpose()) / point.a.norm() * change(n.first, point.b, derivatives.place);
  const ByUnknowns turn_d =
      (Mat3::Identity() - d * d.transpose()) * projected / distance.value * change(n.value, point.a, derivatives.place);
  const ByUnknowns turn_l = cross(d, turn_t) - cross(t, turn_d);
  const Vec3 direction = force.along * t + force.across * l;
  const ByUnknowns by_unknowns = -force.stiffness * direction * derivatives.gradient.transpose() +
                                 force.normal * (force.along * turn_t + force.across * turn_l);
  ElementMatrix k;
  for (int j = 0; j < 4; ++j) {
    k.middleRows<3>(3 * j) =
        -n.value(j) * by_unknowns - n.first(j) * force.normal * direction * derivatives.place.transpose();
  }
  return k;
}

}  // namespace overbend
