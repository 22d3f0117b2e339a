/// The tail of average conditional exceedance rates fitted to what was counted.
#pragma once

#include <optional>
#include <span>

#include "numerics/acer.h"

namespace overbend {

/// Weighted least squares of the logarithm (Naess & Gaidai 2009): the least of
///
///     sum w_j (ln rate_j - ln q + a (level_j - b)^c)^2,    w_j = (ln high_j - ln low_j)^-2
///
/// with q, a > 0, b not above the lowest level nor further below it than three times the range of the levels, and
/// 0.5 <= c <= 5. For given b and c the best q and a follow from a straight line; b and c are searched for, from `near`
/// where a tail close to the answer is known. None where the rates do not fall.
std::optional<AcerTail> fit_acer_tail(std::span<const AcerLevel> levels, const AcerTail* near = nullptr);

}  // namespace overbend
