/// Sine, cosine and exponential of a register of doubles. For wave_kernel.cpp only.
///
/// Arguments are reduced to a small interval in which the Taylor series is accurate to the last digit or two.
#pragma once

#include "base/simd.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {

using Bits = long long __attribute__((vector_size(8 * OVERBEND_ISA_WIDTH), may_alias));

/// Adding and subtracting it rounds to the nearest integer, which is then in the low bits.
inline constexpr double kRounder = 0x1.8p52;

/// Valid for |x| below 1e6: pi/2 is subtracted in two parts, the first with 33 bits.
inline void sine_cosine(const Lanes& x, Lanes& sine, Lanes& cosine) {
  const Lanes shifted = x * 0x1.45f306dc9c883p-1 + kRounder;
  const Lanes turns = shifted - kRounder;
  const Lanes r = (x - turns * 0x1.921fb544p+0) - turns * 0x1.0b4611a626331p-34;
  const Lanes q = r * r;
  Lanes s = q * (1.0 / 355687428096000.0) - 1.0 / 1307674368000.0;
  s = s * q + 1.0 / 6227020800.0;
  s = s * q - 1.0 / 39916800.0;
  s = s * q + 1.0 / 362880.0;
  s = s * q - 1.0 / 5040.0;
  s = s * q + 1.0 / 120.0;
  s = s * q - 1.0 / 6.0;
  s = s * q * r + r;
  Lanes c = q * (1.0 / 20922789888000.0) - 1.0 / 87178291200.0;
  c = c * q + 1.0 / 479001600.0;
  c = c * q - 1.0 / 3628800.0;
  c = c * q + 1.0 / 40320.0;
  c = c * q - 1.0 / 720.0;
  c = c * q + 1.0 / 24.0;
  c = c * q - 0.5;
  c = c * q + 1.0;
  const Bits quarter = (Bits)shifted;
  const Bits swap = -(quarter & 1);
  const Bits s_bits = (Bits)s, c_bits = (Bits)c;
  sine = (Lanes)(((s_bits & ~swap) | (c_bits & swap)) ^ ((quarter & 2) << 62));
  cosine = (Lanes)(((c_bits & ~swap) | (s_bits & swap)) ^ (((quarter + 1) & 2) << 62));
}

/// exp(x), the decay of waves with depth, and exp(-x).
struct Exponentials {
  Lanes down, up;
};

/// Valid for x from -700 to 700. Both are sums of the even and the odd part of the series.
inline Exponentials exponentials(const Lanes& x) {
  const Lanes shifted = x * 0x1.71547652b82fep+0 + kRounder;
  const Lanes doublings = shifted - kRounder;
  const Lanes r = (x - doublings * 0x1.62e42feep-1) - doublings * 0x1.a39ef35793c76p-33;
  const Lanes q = r * r;
  Lanes even = q * (1.0 / 479001600.0) + 1.0 / 3628800.0;
  even = even * q + 1.0 / 40320.0;
  even = even * q + 1.0 / 720.0;
  even = even * q + 1.0 / 24.0;
  even = even * q + 0.5;
  even = even * q + 1.0;
  Lanes odd = q * (1.0 / 6227020800.0) + 1.0 / 39916800.0;
  odd = odd * q + 1.0 / 362880.0;
  odd = odd * q + 1.0 / 5040.0;
  odd = odd * q + 1.0 / 120.0;
  odd = odd * q + 1.0 / 6.0;
  odd = odd * q + 1.0;
  const Bits exponent = (Bits)shifted << 52;
  return {(Lanes)((Bits)(even + r * odd) + exponent), (Lanes)((Bits)(even - r * odd) - exponent)};
}

}  // namespace overbend::OVERBEND_ISA_NAMESPACE
