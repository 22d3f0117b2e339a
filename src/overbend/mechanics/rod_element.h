/// Torsion-free Kirchhoff-Love rod element with cubic Hermite interpolation, plain scalar form.
///
///   r1, t1 o=================o r2, t2      t = dr/ds, s = unstressed length, element length h
///
/// Meier, Popp & Wall, CMAME 278 (2014) and 290 (2015): no rotations, C1 centreline, symmetric tangent. The membrane
/// strain that enters the energy is the quadratic through the strains at both ends and the middle, which removes
/// locking; four Gauss points integrate the bending. This form is the reference; `line_kernel` does the same for eight
/// elements at once.
#pragma once

#include <Eigen/Core>

#include "base/vec.h"

namespace overbend {

using ElementVector = Eigen::Matrix<double, 12, 1>;  ///< r1, t1, r2, t2.
using ElementMatrix = Eigen::Matrix<double, 12, 12>;

struct RodProperties {
  double length = 1.0;       ///< Unstressed [m].
  double EA = 0.0;           ///< [N]
  double EI = 0.0;           ///< [N m2]
  double compression = 1.0;  ///< Fraction of EA effective in compression, see slack_law.h [-].
  double damping = 0.0;      ///< Damping of the tension-only part: extrapolation time of its strain [s].
};

/// Motion of an element: rates of its unknowns, and their derivative with the unknowns by an integrator's formula
/// [1/s].
struct RodMotion {
  ElementVector v = ElementVector::Zero();
  double velocity_share = 0.0;
};

struct RodForce {
  double energy = 0.0;                              ///< Strain energy [J].
  double loss = 0.0;                                ///< Power dissipated by damping [W].
  ElementVector force = ElementVector::Zero();      ///< Derivative of the energy: internal force [N], [N m].
  ElementMatrix stiffness = ElementMatrix::Zero();  ///< Derivative of the force; at rest symmetric.
};

/// Values and derivatives in s of the Hermite functions of r1, t1, r2, t2 at xi in [0, 1].
struct HermiteValues {
  Eigen::Vector4d value, first, second;
};
inline HermiteValues hermite(double xi, double h) {
  const double x2 = xi * xi, x3 = x2 * xi;
  HermiteValues n;
  n.value << 1.0 - 3.0 * x2 + 2.0 * x3, h * (xi - 2.0 * x2 + x3), 3.0 * x2 - 2.0 * x3, h * (x3 - x2);
  n.first << (-6.0 * xi + 6.0 * x2) / h, 1.0 - 4.0 * xi + 3.0 * x2, (6.0 * xi - 6.0 * x2) / h, 3.0 * x2 - 2.0 * xi;
  n.second << (-6.0 + 12.0 * xi) / (h * h), (-4.0 + 6.0 * xi) / h, (6.0 - 12.0 * xi) / (h * h), (6.0 * xi - 2.0) / h;
  return n;
}

/// Position, tangent r' and r'' of the centreline at xi.
struct CentrelinePoint {
  Vec3 r, a, b;
};
/// Returns position, r' and r'' at xi for an element of unstressed `length` [m].
CentrelinePoint centreline(const ElementVector& q, double xi, double length);

/// Curvature |a x b| / |a|^2 [1/m].
double curvature(const CentrelinePoint& centreline);

/// Returns energy, force and tangent of membrane and bending.
RodForce rod_force(const RodProperties& properties, const ElementVector& q, const RodMotion& motion = {});

}  // namespace overbend
