/// Vectors at many places, one array per component, so that loops over the places are vectorised.
#pragma once

#include <cstddef>
#include <vector>

#include "base/vec.h"

namespace overbend {

struct VectorColumns {
  std::vector<double> x, y, z;

  explicit VectorColumns(std::size_t places = 0) : x(places, 0.0), y(places, 0.0), z(places, 0.0) {}

  std::size_t size() const { return x.size(); }
  void resize(std::size_t places) {
    for (std::vector<double>* component : {&x, &y, &z}) component->resize(places);
  }
  Vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, const Vec3& v) {
    x[i] = v.x();
    y[i] = v.y();
    z[i] = v.z();
  }
};

}  // namespace overbend
