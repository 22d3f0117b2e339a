/// Vectors at many places, one array per component: loops over the places become vector instructions.
#pragma once

#include <cmath>
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

// For loops that the compiler makes vectors of: pointers instead of arrays, three doubles instead of a matrix.

struct Parts {
  double x, y, z;
};

inline Parts operator+(const Parts& a, const Parts& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Parts operator-(const Parts& a, const Parts& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Parts operator*(double s, const Parts& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline double dot(const Parts& a, const Parts& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline double length(const Parts& a) {
  return std::sqrt(dot(a, a));
}
inline Parts cross(const Parts& a, const Parts& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct PlainColumns {
  double *x, *y, *z;
  explicit PlainColumns(VectorColumns& columns) : x(columns.x.data()), y(columns.y.data()), z(columns.z.data()) {}
  void put(std::size_t i, const Parts& v) const {
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
  }
};

struct ConstColumns {
  const double *x, *y, *z;
  explicit ConstColumns(const VectorColumns& columns) : x(columns.x.data()), y(columns.y.data()), z(columns.z.data()) {}
  Parts at(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

}  // namespace overbend
