/// Low-frequency position and heading of a hull, for the phases of waves and the headings of tables.
///
///     u'' = w^2 (x - u) - 2 w u',   w = 2 pi / T
///
/// a critically damped low-pass for each of x, y and psi, advanced exactly over a step in which x is linear.
#pragma once

#include "base/vec.h"
#include "model/description/hydrodynamic_data.h"

namespace overbend {

/// Low-frequency motion.
struct SlowMotion {
  Vec3 value = Vec3::Zero();  ///< x_f, y_f, psi_f [m, m, rad].
  Vec3 rate = Vec3::Zero();   ///< Their rates [m/s, m/s, rad/s].
};

/// Returns the motion at rest at the position of h.
SlowMotion slow_motion_at_rest(const Vec6& h);

/// Returns the motion after a step of length `step` [s] in which x, y and psi change linearly from those of h0 to those
/// of h1. `period` is the corner period T [s].
SlowMotion slow_motion_after(const SlowMotion& before, const Vec6& h0, const Vec6& h1, double step, double period);

}  // namespace overbend
