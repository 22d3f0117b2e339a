#include "numerics/generalized_alpha.h"

#include <algorithm>
#include <cmath>

namespace overbend {

GeneralizedAlpha::GeneralizedAlpha(double spectral_radius)
    : alpha_m((2.0 * spectral_radius - 1.0) / (spectral_radius + 1.0)),
      alpha_f(spectral_radius / (spectral_radius + 1.0)),
      beta(0.25 * (1.0 - alpha_m + alpha_f) * (1.0 - alpha_m + alpha_f)),
      gamma(0.5 - alpha_m + alpha_f),
      half_extrapolation(std::min(2.0, 0.5 / std::abs(alpha_m - alpha_f))),
      full_extrapolation(std::min(20.0, 1.0 / std::abs(alpha_m - alpha_f))) {}

}  // namespace overbend
