/// Border matrices of a node held by a body and of a roller contact.
#pragma once

#include "system/free_body.h"
#include "system/hinged_sections.h"
#include "system/line_assembly.h"
#include "system/system.h"

namespace overbend {

/// Node held by a body: dq = motion dh plus the free unknowns along the guide.
struct HeldEnd {
  int node = 0;
  Mat6 motion = Mat6::Zero();        ///< E. Rows of unknowns that the body does not hold are zero.
  Mat6 turning = Mat6::Zero();       ///< Derivative of E^T force by the body's coordinates at constant force.
  Mat6 turned_force = Mat6::Zero();  ///< (dE/dq)^T force: by unknowns of the node (rows) and the body (columns).
};

/// Returns the border of a held end at the last evaluation.
HeldEnd held_end(const Attachment& held, const LineAssembly& line, const LineState& state, const BodyPose& pose);

/// Returns E^T force, where force is the residual of the held unknowns: minus their load on the body.
Vec6 held_end_force(const Attachment& held, const LineAssembly& line, const LineState& state, const BodyPose& pose);

/// Blocks of the tangent between a node and a neighbour.
struct NeighbourBlocks {
  int neighbour = 0;
  Mat6 to_own, from_own;  ///< Rows of the neighbour by the node; rows of the node by the neighbour.
};
/// Returns the diagonal block of a node.
Mat6 diagonal_block(const LineAssembly& line, int node);
/// Returns the blocks with the previous node, which must exist; with the next node.
NeighbourBlocks blocks_before(const LineAssembly& line, int node);
NeighbourBlocks blocks_behind(const LineAssembly& line, int node);

/// Border contribution of a contact between a line element and a body.
struct ContactBorder {
  Eigen::Matrix<double, 12, 6> columns = Eigen::Matrix<double, 12, 6>::Zero();  ///< d residual of the element / d h.
  Eigen::Matrix<double, 12, 6> rows = Eigen::Matrix<double, 12, 6>::Zero();     ///< Transposed: d R_h / d q.
  Mat6 corner = Mat6::Zero();                                                   ///< d R_h / d h.
};

/// Returns the border by objectivity from `residual` (minus the nodal forces) and `tangent` of the contact at the
/// element's unknowns `q`; `turning` as in RollerContacts::turning_of.
ContactBorder contact_border(const BodyPose& pose, const ElementVector& q, const ElementVector& residual,
                             const ElementMatrix& tangent, const Eigen::Matrix<double, 12, 3>& turning);

using ElementMotion = Eigen::Matrix<double, 12, 1>;

/// The same for a contact with a body that rotates about a hinge: one column and one row.
struct TwistBorder {
  ElementMotion column = ElementMotion::Zero(), row = ElementMotion::Zero();
};
TwistBorder twist_border(const Twist& twist, const ElementVector& q, const ElementVector& residual,
                         const ElementMatrix& tangent, const Eigen::Matrix<double, 12, 3>& turning);

/// Motion of a body that may carry a hinge: velocity of the point `origin`, and rotation about it.
struct CarrierMotion {
  Vec3 velocity = Vec3::Zero(), axis = Vec3::Zero(), origin = Vec3::Zero();
};

/// Returns the derivative of the generalised force on a hinge by another coordinate, whose column is `column`. `by`:
/// motion of that coordinate if it carries the hinge, which then moves and rotates with it; else null.
double twist_corner(const Twist& twist, const CarrierMotion* by, const ElementVector& q, const ElementVector& residual,
                    const ElementMotion& column);

/// Return the motion of the vessel with its coordinate `k`, and of the nodes of an element that moves with it.
CarrierMotion carrier_motion(const BodyPose& pose, int k);
ElementMotion element_motion(const CarrierMotion& motion, const ElementVector& q);

/// Adds a 6 x 6 matrix to a panel of the border, from column `first`.
void add_to_panel(double* panel, int stride, int first, const Mat6& part);

/// Removes constrained directions from a panel of the six rows of a node's unknowns.
void remove_held(const HeldDirections& held, double* panel, int stride);

}  // namespace overbend
