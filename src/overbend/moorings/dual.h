/// Number with its derivatives with respect to four unknowns of a suspended line: forward differentiation (Griewank &
/// Walther, Evaluating Derivatives, 2008, chapter 3).
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace overbend {

/// Unknowns of a suspended line.
enum class CatenaryUnknown {
  pull,    ///< Horizontal tension at the fairlead [N].
  start,   ///< Start of the span: accumulated weight at which the line is parallel to the bed [N].
  height,  ///< Height of the fairlead [m].
  first,   ///< Unstressed length of the first piece [m].
};

struct Dual {
  double v = 0.0;
  Eigen::Vector4d d = Eigen::Vector4d::Zero();

  Dual() = default;
  Dual(double value) : v(value) {}  // NOLINT(google-explicit-constructor): a constant is a number with no derivatives
  Dual(double value, Eigen::Vector4d derivatives) : v(value), d(std::move(derivatives)) {}
  Dual(double value, CatenaryUnknown of) : v(value) { d[static_cast<int>(of)] = 1.0; }
  double operator[](CatenaryUnknown unknown) const { return d[static_cast<int>(unknown)]; }
};

inline Dual operator+(const Dual& a, const Dual& b) {
  return {a.v + b.v, a.d + b.d};
}
inline Dual operator-(const Dual& a, const Dual& b) {
  return {a.v - b.v, a.d - b.d};
}
inline Dual operator-(const Dual& a) {
  return {-a.v, -a.d};
}
inline Dual operator*(const Dual& a, const Dual& b) {
  return {a.v * b.v, a.d * b.v + a.v * b.d};
}
inline Dual operator/(const Dual& a, const Dual& b) {
  const double quotient = a.v / b.v;
  return {quotient, (a.d - quotient * b.d) / b.v};
}
inline Dual sqrt(const Dual& a) {
  const double root = std::sqrt(a.v);
  return {root, a.d / (2.0 * root)};
}
inline Dual log1p(const Dual& a) {
  return {std::log1p(a.v), a.d / (1.0 + a.v)};
}

/// Eliminates one unknown from `a` by the condition `zero` = 0: value after a last Newton step, derivatives along the
/// condition.
inline Dual eliminate(const Dual& a, const Dual& zero, CatenaryUnknown unknown) {
  const double ratio = a[unknown] / zero[unknown];
  return {a.v - ratio * zero.v, a.d - ratio * zero.d};
}

}  // namespace overbend
