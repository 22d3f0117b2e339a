/// Fit of the tail of average conditional exceedance rates to counted rates.
#pragma once

#include <optional>
#include <span>

#include "numerics/acer.h"

namespace overbend {

/// Weighted least squares of the logarithm (Naess & Gaidai 2009): minimises
///
///     sum w_j (ln rate_j - ln q + a (level_j - b)^c)^2,    w_j = (ln high_j - ln low_j)^-2
///
/// with q, a > 0, b not above the lowest level nor further below it than three times the range of the levels, and 0.5
/// <= c <= 5. For given b and c the best q and a follow from a straight line; b and c are searched, starting from
/// `near` if an approximate tail is known. Empty if the rates do not decrease.
std::optional<AcerTail> fit_acer_tail(std::span<const AcerLevel> levels, const AcerTail* near = nullptr);

}  // namespace overbend
