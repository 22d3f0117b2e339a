/// The small matrices of a border: of a node that a body holds, and of a roller's contact.
#pragma once

#include "system/free_body.h"
#include "system/hinged_sections.h"
#include "system/line_assembly.h"
#include "system/system.h"

namespace overbend {

/// A node that a body holds: dq = motion dh + what is free along the guide.
struct HeldEnd {
  int node = 0;
  Mat6 motion = Mat6::Zero();        ///< E. Rows of unknowns that are not held by the body are zero.
  Mat6 turning = Mat6::Zero();       ///< How E^T force changes with the body where the force stays.
  Mat6 turned_force = Mat6::Zero();  ///< (dE/dq)^T force: by unknowns of the node (rows) and the body (columns).
};

HeldEnd held_end(const Attachment& held, const LineAssembly& line, const LineState& state, const BodyPose& pose);

/// E^T force, force the residual of the held unknowns: what they exert on the body, with minus.
Vec6 held_end_force(const Attachment& held, const LineAssembly& line, const LineState& state, const BodyPose& pose);

/// Blocks of the tangent between a node and one of its neighbours.
struct NeighbourBlocks {
  int neighbour = 0;
  Mat6 to_own, from_own;  ///< Rows of the neighbour by the node; rows of the node by the neighbour.
};
Mat6 own_block(const LineAssembly& line, int node);
/// With the node before, which there has to be; with the node behind.
NeighbourBlocks blocks_before(const LineAssembly& line, int node);
NeighbourBlocks blocks_behind(const LineAssembly& line, int node);

/// What a contact between a line's element and a body adds to the border.
struct ContactBorder {
  Eigen::Matrix<double, 12, 6> columns = Eigen::Matrix<double, 12, 6>::Zero();  ///< d residual of the element / d h.
  Eigen::Matrix<double, 12, 6> rows = Eigen::Matrix<double, 12, 6>::Zero();     ///< Transposed: d R_h / d q.
  Mat6 corner = Mat6::Zero();                                                   ///< d R_h / d h.
};

/// By objectivity: `residual` (minus the nodal forces) and `tangent` of the contact at the element's unknowns `q`;
/// `turning` as RollerContacts::turning_of.
ContactBorder contact_border(const BodyPose& pose, const ElementVector& q, const ElementVector& residual,
                             const ElementMatrix& tangent, const Eigen::Matrix<double, 12, 3>& turning);

using ElementMotion = Eigen::Matrix<double, 12, 1>;

/// The same of a contact with a body that turns about a hinge: one column and one row.
struct TwistBorder {
  ElementMotion column = ElementMotion::Zero(), row = ElementMotion::Zero();
};
TwistBorder twist_border(const Twist& twist, const ElementVector& q, const ElementVector& residual,
                         const ElementMatrix& tangent, const Eigen::Matrix<double, 12, 3>& turning);

/// Motion of what may carry a hinge: a velocity of the point `at`, and a turning about it.
struct CarrierMotion {
  Vec3 velocity = Vec3::Zero(), axis = Vec3::Zero(), at = Vec3::Zero();
};

/// How the force on a hinge changes with another coordinate, whose column is `column`. `by` is its motion where it
/// carries the hinge, which moves and turns with it; else null.
double twist_corner(const Twist& twist, const CarrierMotion* by, const ElementVector& q, const ElementVector& residual,
                    const ElementMotion& column);

/// Motion of the vessel with its coordinate `k`, and of the nodes of an element that went with it.
CarrierMotion carrier_motion(const BodyPose& pose, int k);
ElementMotion element_motion(const CarrierMotion& motion, const ElementVector& q);

/// Adds six rows of six columns to a panel of the border, from column `first` on.
void add_to_panel(double* panel, int stride, int first, const Mat6& part);

/// Removes held directions from a panel, six rows of a node's unknowns.
void remove_held(const HeldDirections& held, double* panel, int stride);

}  // namespace overbend
