/// Slow position and heading of a hull: what phases of the waves and headings of tables hang on.
///
///     u'' = w^2 (x - u) - 2 w u',   w = 2 pi / T
///
/// a critically damped low-pass for each of x, y and psi, advanced exactly over a step in which x is linear.
#pragma once

#include "base/vec.h"
#include "model/description/hydrodynamic_data.h"

namespace overbend {

struct SlowMotion {
  Vec3 value = Vec3::Zero();  ///< x_f, y_f, psi_f [m, m, rad].
  Vec3 rate = Vec3::Zero();   ///< Their rates [m/s, m/s, rad/s].
};

/// At rest where the hull is.
SlowMotion slow_rest(const Vec6& h);

/// After a step of length `step` [s] in which x, y and psi go linearly from those of h0 to those of h1. `period` is the
/// corner period T [s].
SlowMotion slow_motion_after(const SlowMotion& before, const Vec6& h0, const Vec6& h1, double step, double period);

}  // namespace overbend
