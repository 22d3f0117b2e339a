#include "mechanics/rod_element.h"

#include <array>

#include "mechanics/axial_law.h"
#include "mechanics/quadrature.h"

namespace overbend {
namespace {

/// Rows of the derivative of a = r' with respect to the element's unknowns are `first` times the unit matrix.
Eigen::Matrix<double, 3, 12> spread(const Eigen::Vector4d& shape) {
  Eigen::Matrix<double, 3, 12> matrix;
  for (int j = 0; j < 4; ++j) {
    matrix.block<3, 3>(0, 3 * j) = shape(j) * Mat3::Identity();
  }
  return matrix;
}

void add_membrane(const RodProperties& rod, const ElementVector& q, const RodMotion& motion, RodForce& result) {
  std::array<double, 3> strain{};
  std::array<ElementVector, 3> gradient;
  std::array<ElementMatrix, 3> hessian;
  for (int k = 0; k < 3; ++k) {
    const HermiteValues n = hermite(0.5 * k, rod.length);
    const Eigen::Matrix<double, 3, 12> da = spread(n.first);
    const Vec3 a = da * q;
    const Vec3 u = a.normalized();
    strain[k] = a.norm() - 1.0;
    gradient[k] = da.transpose() * u;
    hessian[k] = da.transpose() * (Mat3::Identity() - u * u.transpose()) * da / a.norm();
  }
  if (rod.compression < 1.0) {
    for (int k = 0; k < 3; ++k) {
      const double rate = gradient[k].dot(motion.v);
      const AxialLaw at_rest = axial_law(strain[k], strain[k], rod.compression);
      const AxialLaw law = axial_law(strain[k], strain[k] + rod.damping * rate, rod.compression);
      const double w = kSlackWeight[k] * rod.length * rod.EA;
      const ElementVector ahead =
          (1.0 + rod.damping * motion.velocity_share) * gradient[k] + rod.damping * hessian[k] * motion.v;
      result.energy += w * at_rest.energy;
      result.loss += w * (law.force - at_rest.force) * rate;
      result.force += w * law.force * gradient[k];
      result.stiffness += w * gradient[k] * (law.slope * gradient[k] + law.slope_ahead * ahead).transpose();
      result.stiffness += w * law.force * hessian[k];
    }
    return;
  }
  for (int k = 0; k < 3; ++k) {
    for (int l = 0; l < 3; ++l) {
      const double m = rod.EA * rod.length * kStrainMass[k][l];
      result.energy += 0.5 * m * strain[k] * strain[l];
      result.force += m * strain[l] * gradient[k];
      result.stiffness += m * (gradient[k] * gradient[l].transpose() + strain[l] * hessian[k]);
    }
  }
}

/// W = EI/2 (p/g - m^2/g^2) with a = r', b = r'', g = a.a, p = b.b, m = a.b.
void add_bending(const RodProperties& rod, const ElementVector& q, RodForce& result) {
  const Mat3 identity = Mat3::Identity();
  for (int i = 0; i < kGaussPoints; ++i) {
    const HermiteValues n = hermite(kGaussXi[i], rod.length);
    const Eigen::Matrix<double, 3, 12> da = spread(n.first);
    const Eigen::Matrix<double, 3, 12> db = spread(n.second);
    const Vec3 a = da * q;
    const Vec3 b = db * q;
    const double g = a.squaredNorm(), p = b.squaredNorm(), m = a.dot(b);
    const double g2 = g * g, g3 = g2 * g, g4 = g2 * g2;
    const double weight = kGaussWeight[i] * rod.length * rod.EI;
    const Mat3 aa = a * a.transpose(), ab = a * b.transpose(), ba = b * a.transpose(), bb = b * b.transpose();
    const Vec3 w_a = -p / g2 * a - m / g2 * b + 2.0 * m * m / g3 * a;
    const Vec3 w_b = b / g - m / g2 * a;
    const Mat3 w_bb = identity / g - aa / g2;
    const Mat3 w_ba = -2.0 * ba / g2 - ab / g2 - m * identity / g2 + 4.0 * m * aa / g3;
    const Mat3 w_aa = -p * identity / g2 + 4.0 * p * aa / g3 - bb / g2 + 4.0 * m * (ba + ab) / g3 +
                      2.0 * m * m * identity / g3 - 12.0 * m * m * aa / g4;
    result.energy += 0.5 * weight * (p / g - m * m / g2);
    result.force += weight * (da.transpose() * w_a + db.transpose() * w_b);
    result.stiffness += weight * (da.transpose() * w_aa * da + db.transpose() * w_bb * db + db.transpose() * w_ba * da +
                                  da.transpose() * w_ba.transpose() * db);
  }
}

}  // namespace

CentrelinePoint centreline(const ElementVector& q, double xi, double length) {
  const HermiteValues n = hermite(xi, length);
  const Eigen::Map<const Eigen::Matrix<double, 3, 4>> nodes(q.data());
  return {nodes * n.value, nodes * n.first, nodes * n.second};
}

double curvature(const CentrelinePoint& centreline) {
  return centreline.a.cross(centreline.b).norm() / centreline.a.squaredNorm();
}

RodForce rod_force(const RodProperties& properties, const ElementVector& q, const RodMotion& motion) {
  RodForce result;
  add_membrane(properties, q, motion, result);
  add_bending(properties, q, result);
  return result;
}

}  // namespace overbend
