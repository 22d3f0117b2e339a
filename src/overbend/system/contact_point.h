/// Interpolation at the contact point of a line and a roller, for roller_contacts.cpp and roller_contact_tangents.cpp.
#pragma once

#include "mechanics/rod_element.h"

namespace overbend {

inline ElementVector element_unknowns(const double* values, int element) {
  return ElementVector(Eigen::Map<const ElementVector>(values + 6 * element));
}

/// Value at xi of a field with these nodal values.
inline Vec3 at_point(const Eigen::Vector4d& shape, const ElementVector& nodes) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 4>>(nodes.data()) * shape;
}

/// Subtracts a force from rows [from, to) of positions and tangents of an element: 0 and 1 are its lower node, 2 and 3
/// its upper.
inline void add_point_force(double* element, const Eigen::Vector4d& shape, int from, int to, const Vec3& force) {
  for (int j = from; j < to; ++j) {
    for (int i = 0; i < 3; ++i) {
      element[3 * j + i] -= shape(j) * force(i);
    }
  }
}

}  // namespace overbend
