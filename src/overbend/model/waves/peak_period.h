/// Peak period of a wind sea from its zero up-crossing period.
#pragma once

#include <optional>

namespace overbend {

/// Returns Tp / Tz of the JONSWAP spectrum with this peak enhancement over all frequencies, where
/// Tz = 2 pi sqrt(m0 / m2), by integration of its density [dnvc205]: 1.4077 for gamma 1 (Pierson-Moskowitz), 1.2863 for
/// gamma 3.3.
double tp_over_tz(double gamma);

/// Returns the peak period [s] of a JONSWAP sea with significant height `hs` [m] and zero up-crossing period `tz` [s].
/// Without `gamma`, the factor is that of jonswap_gamma() for the height and the returned period.
double peak_period(double hs, double tz, std::optional<double> gamma);

}  // namespace overbend
