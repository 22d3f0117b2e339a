/// Where the lays that pass their checks begin and end.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "study/lay_table/lay_cases.h"

namespace overbend {

/// A lay with the value of what is varied that it belongs to.
struct TriedLay {
  double value = 0.0;
  LayCase lay;
};
using TryLay = std::function<LayCase(double)>;

/// How far and how closely is searched.
struct LimitSearch {
  double factor = 1.15;      ///< Between values that are tried one after the other.
  int most_steps = 12;       ///< Of them.
  double least_step = 1.05;  ///< Factor between those of the search for the least.
  double tolerance = 1e-3;   ///< Of the limit, relative.
};

/// Both sides of a limit, closer than the tolerance.
struct LayLimit {
  TriedLay passing, beyond;
};

/// Bisects between a lay that passes and one that does not.
LayLimit narrowed(TriedLay passing, TriedLay failing, const LimitSearch& search, const TryLay& try_at);

/// From a lay that passes outwards, to smaller values where `down`; none where all that are tried pass.
std::optional<LayLimit> limit_beyond(TriedLay passing, bool down, const LimitSearch& search, const TryLay& try_at);

/// What the search for the least led to.
struct LeastLay {
  std::optional<LayLimit> limit;  ///< None where no lay that was tried passes.
  std::vector<TriedLay> tried;    ///< By rising value.
};

/// The least value between `from` and `to` with which a lay passes: upwards in steps, closer around every lay that is
/// nearer to passing than those on both sides of it, since lays may pass over a stretch shorter than a step. Where the
/// least that is tried passes, it is `passing` and `beyond` alike. `try_near` may start from the lay tried last; what
/// is told is tried by `try_at`.
LeastLay least_passing(double from, double to, const LimitSearch& search, const TryLay& try_near, const TryLay& try_at);

}  // namespace overbend
