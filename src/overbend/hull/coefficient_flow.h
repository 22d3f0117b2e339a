/// Loads of a flow of water or air on the hull from a table of coefficients over its direction, in the form of OCIMF.
#pragma once

#include <vector>

#include "model/description/hull_description.h"

namespace overbend {

/// F_x = 1/2 rho V^2 A_x c_x, F_y = 1/2 rho V^2 A_y c_y, M_z = 1/2 rho V^2 A_y L c_z.
struct CoefficientTable {
  double frontal_area = 0.0, lateral_area = 0.0, length = 0.0;  ///< A_x, A_y, L [m2, m2, m].
  /// By the direction the flow goes to, anticlockwise from the bow, [0, 2 pi), F along V.
  std::vector<CoefficientRow> rows;
};

/// F_x, F_y [N] and M_z [N m] about midship, and their derivatives by the two velocities.
struct FlowOnTable {
  Vec3 force = Vec3::Zero();
  Eigen::Matrix<double, 3, 2> by_flow = Eigen::Matrix<double, 3, 2>::Zero();
};

/// Returns the loads of `flow`, the fluid velocity relative to the hull, forward and to port [m/s]; `density` of the
/// fluid [kg/m3]. Linear between the rows. Does not allocate.
FlowOnTable flow_on_table(const CoefficientTable& table, double density, const Eigen::Vector2d& flow);

/// Returns F_x, F_y and M_z about midship as six forces about a reference point; they act at its height, without heel
/// or trim moment.
Vec6 about_reference(const Vec3& at_midship, const Vec3& reference_V);

/// Returns rows by the direction the flow goes to, anticlockwise from the bow, sorted, from a table with other angles:
/// `from_bow`, where the flow comes from, clockwise from the bow; `from_stern_ocimf`, where it comes from,
/// anticlockwise from the stern. In all three, forces are along x forward and y to port, moments positive bow to port,
/// as in OCIMF.
std::vector<CoefficientRow> coefficients_from_bow(std::vector<CoefficientRow> rows, CoefficientAxes axes);

}  // namespace overbend
