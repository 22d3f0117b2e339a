/// Search for the limits of the lays that pass their checks.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "study/lay_table/lay_cases.h"

namespace overbend {

/// A lay and its value of the varied quantity.
struct TriedLay {
  double value = 0.0;
  LayCase lay;
};
using TryLay = std::function<LayCase(double)>;

/// Steps and accuracy of a limit search.
struct LimitSearch {
  double factor = 1.15;             ///< Ratio of successive trial values.
  int max_steps = 12;               ///< Maximum number of trial values.
  double min_search_factor = 1.05;  ///< Ratio of successive values in the search for the minimum.
  double tolerance = 1e-3;          ///< Relative accuracy of the limit [-].
};

/// Both sides of a limit, within the tolerance.
struct LayLimit {
  TriedLay passing, beyond;
};

/// Bisects between a lay that passes and one that does not.
LayLimit narrowed(TriedLay passing, TriedLay failing, const LimitSearch& search, const TryLay& try_at);

/// Searches outwards from a lay that passes, to smaller values if `down`; empty if all trial values pass.
std::optional<LayLimit> limit_beyond(TriedLay passing, bool down, const LimitSearch& search, const TryLay& try_at);

/// Result of the search for the minimum.
struct MinPassingLay {
  std::optional<LayLimit> limit;  ///< Empty if no trial lay passes.
  std::vector<TriedLay> tried;    ///< By increasing value.
};

/// Finds the minimum value between `from` and `to` at which a lay passes: upwards in steps, refined around every lay
/// that is nearer to passing than its two neighbours, because lays may pass in a range shorter than a step. If the
/// lowest trial value passes, it is both `passing` and `beyond`. `try_near` may start from the last lay; reported lays
/// are solved by `try_at`.
MinPassingLay find_min_passing(double from, double to, const LimitSearch& search, const TryLay& try_near,
                               const TryLay& try_at);

}  // namespace overbend
