/// Values at the point of a line that meets a roller, for roller_contacts.cpp and roller_contact_tangents.cpp.
#pragma once

#include "mechanics/rod_element.h"

namespace overbend {

inline ElementVector dofs_of(const double* values, int element) {
  return ElementVector(Eigen::Map<const ElementVector>(values + 6 * element));
}

/// Value at xi of a field given by its nodal values.
inline Vec3 at_point(const HermiteValues& n, const ElementVector& nodes) {
  return n.value(0) * nodes.segment<3>(0) + n.value(1) * nodes.segment<3>(3) + n.value(2) * nodes.segment<3>(6) +
         n.value(3) * nodes.segment<3>(9);
}

/// To places and tangents number [from, to) of an element: 0 and 1 are its lower node, 2 and 3 its upper.
inline void add_point_force(double* element, const HermiteValues& n, int from, int to, const Vec3& force) {
  for (int j = from; j < to; ++j) {
    for (int i = 0; i < 3; ++i) {
      element[3 * j + i] -= n.value(j) * force(i);
    }
  }
}

}  // namespace overbend
