#include "model/waves/wave_theory.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <stdexcept>

#include "base/constants.h"

namespace overbend {
namespace {

/// Returns the value of a polynomial with increasing powers of x.
double polynomial(double x, std::initializer_list<double> coefficients) {
  double value = 0.0;
  for (const double* c = coefficients.end(); c != coefficients.begin();) value = value * x + *--c;
  return value;
}

/// S of [fenton1985] and the factors in the denominators.
struct Denominators {
  double s, one_minus_s, three, four;  // sech 2kd, 1 - S, 3 + 2 S, 4 + S
};

void potential_coefficients(const Denominators& q, double kd, StokesCoefficients& k) {
  const double s = q.s, sinh_kd = std::sinh(kd);
  const double c1 = std::cosh(kd) / sinh_kd, c2 = std::cosh(2.0 * kd), c3 = std::cosh(3.0 * kd) / sinh_kd;
  const double c4 = std::cosh(4.0 * kd), c5 = std::cosh(5.0 * kd) / sinh_kd;
  const double one3 = std::pow(q.one_minus_s, 3), one5 = std::pow(q.one_minus_s, 5), one6 = std::pow(q.one_minus_s, 6);
  k.a11 = c1;
  k.a22 = c2 * 3.0 * s * s / (2.0 * q.one_minus_s * q.one_minus_s);
  k.a31 = c1 * polynomial(s, {-4, -20, 10, -13}) / (8.0 * one3);
  k.a33 = c3 * polynomial(s, {0, 0, -2, 11}) / (8.0 * one3);
  k.a42 = c2 * polynomial(s, {0, 12, -14, -264, -45, -13}) / (24.0 * one5);
  k.a44 = c4 * polynomial(s, {0, 0, 0, 10, -174, 291, 278}) / (48.0 * q.three * one5);
  k.a51 =
      c1 * polynomial(s, {-1184, 32, 13232, 21712, 20940, 12554, -500, -3341, -670}) / (64.0 * q.three * q.four * one6);
  k.a53 = c3 * polynomial(s, {0, 4, 105, 198, -1376, -1302, -117, 58}) / (32.0 * q.three * one6);
  k.a55 = c5 * polynomial(s, {0, 0, 0, -6, 272, -1552, 852, 2029, 430}) / (64.0 * q.three * q.four * one6);
}

void surface_coefficients(const Denominators& q, double kd, StokesCoefficients& k) {
  const double s = q.s, coth_kd = 1.0 / std::tanh(kd);
  const double one3 = std::pow(q.one_minus_s, 3), one4 = std::pow(q.one_minus_s, 4), one6 = std::pow(q.one_minus_s, 6);
  k.b22 = coth_kd * (1.0 + 2.0 * s) / (2.0 * q.one_minus_s);
  k.b31 = -3.0 * polynomial(s, {1, 3, 3, 2}) / (8.0 * one3);
  k.b42 = coth_kd * polynomial(s, {6, -26, -182, -204, -25, 26}) / (6.0 * q.three * one4);
  k.b44 = coth_kd * polynomial(s, {24, 92, 122, 66, 67, 34}) / (24.0 * q.three * one4);
  k.b53 = 9.0 * polynomial(s, {132, 17, -2216, -5897, -6292, -2687, 194, 467, 82}) / (128.0 * q.three * q.four * one6);
  k.b55 = 5.0 * polynomial(s, {300, 1579, 3176, 2949, 1188, 675, 1326, 827, 130}) / (384.0 * q.three * q.four * one6);
}

void speed_coefficients(const Denominators& q, double kd, StokesCoefficients& k) {
  k.c0 = std::sqrt(std::tanh(kd));
  k.c2 = k.c0 * polynomial(q.s, {2, 0, 7}) / (4.0 * q.one_minus_s * q.one_minus_s);
  k.c4 = k.c0 * polynomial(q.s, {4, 32, -116, -400, -71, 146}) / (32.0 * std::pow(q.one_minus_s, 5));
}

/// Angular frequency of the Stokes wave of this wave number.
double stokes_omega(double k, double height, double depth) {
  const StokesCoefficients c = stokes_coefficients(k * depth);
  const double e2 = 0.25 * k * k * height * height;
  return std::sqrt(kGravity * k) * (c.c0 + e2 * (c.c2 + e2 * c.c4));
}

}  // namespace

double jonswap_gamma(double hs, double tp) {
  const double ratio = tp / std::sqrt(hs);
  if (ratio <= 3.6) return 5.0;
  return ratio < 5.0 ? std::exp(5.75 - 1.15 * ratio) : 1.0;
}

double linear_wave_number(double omega, double depth) {
  const double x = omega * omega * depth / kGravity;
  if (x <= 0.0) return 0.0;
  double y = x / std::sqrt(std::tanh(x));
  for (int i = 0; i < 30; ++i) {
    const double tanh_y = std::tanh(y);
    const double change = (y * tanh_y - x) / (tanh_y + y * (1.0 - tanh_y * tanh_y));
    y -= change;
    if (std::abs(change) <= 2e-16 * y) break;
  }
  return y / depth;
}

StokesCoefficients stokes_coefficients(double kd) {
  // From k d = 18 all coefficients have their deep-water values to machine precision; cosh would overflow later.
  const double limited = std::min(kd, 18.0);
  const double s = 1.0 / std::cosh(2.0 * limited);
  const Denominators q{s, 1.0 - s, 3.0 + 2.0 * s, 4.0 + s};
  StokesCoefficients k{};
  potential_coefficients(q, limited, k);
  surface_coefficients(q, limited, k);
  speed_coefficients(q, limited, k);
  return k;
}

double stokes_wave_number(double height, double period, double depth) {
  const double omega = 2.0 * std::numbers::pi / period;
  double k = linear_wave_number(omega, depth);
  for (int i = 0; i < 50; ++i) {
    const double step = 1e-6 * k;
    const double slope = (stokes_omega(k + step, height, depth) - stokes_omega(k - step, height, depth)) / (2.0 * step);
    const double change = (stokes_omega(k, height, depth) - omega) / slope;
    k -= change;
    if (!(k > 0.0)) break;
    if (std::abs(change) > 1e-14 * k) continue;
    if (height > highest_wave(2.0 * std::numbers::pi / k, depth)) break;
    return k;
  }
  throw std::domain_error("no Stokes wave has this height and period in this depth");
}

double highest_wave(double length, double depth) {
  const double x = length / depth;
  return depth * polynomial(x, {0.0, 0.141063, 0.0095721, 0.0077829}) /
         polynomial(x, {1.0, 0.078834, 0.0317567, 0.0093407});
}

double ursell_number(double height, double length, double depth) {
  return height * length * length / (depth * depth * depth);
}

double jonswap_shape(double x, double gamma) {
  if (x <= 0.0) return 0.0;
  const double x4 = x * x * x * x;
  const double base = 5.0 / (x4 * x) * std::exp(-1.25 / x4);
  if (gamma == 1.0) return base;
  const double width = x <= 1.0 ? 0.07 : 0.09;
  const double off = (x - 1.0) / width;
  return base * std::pow(gamma, std::exp(-0.5 * off * off));
}

}  // namespace overbend
