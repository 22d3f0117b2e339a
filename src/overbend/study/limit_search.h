/// Where the lays that pass their checks begin and end.
#pragma once

#include <functional>
#include <optional>

#include "study/lay_cases.h"

namespace overbend {

/// A lay with the value of what is varied that it belongs to.
struct TriedLay {
  double value = 0.0;
  LayCase lay;
};
using TryLay = std::function<LayCase(double)>;

/// How far and how closely is searched.
struct LimitSearch {
  double factor = 1.15;     ///< Between values that are tried one after the other.
  int most_steps = 12;      ///< Of them.
  double tolerance = 1e-3;  ///< Of the limit, relative.
};

/// Both sides of a limit, closer than the tolerance.
struct LayLimit {
  TriedLay passing, beyond;
};

/// Bisects between a lay that passes and one that does not.
LayLimit narrowed(TriedLay passing, TriedLay failing, const LimitSearch& search, const TryLay& try_at);

/// From a lay that passes outwards, to smaller values where `down`; none where all that are tried pass.
std::optional<LayLimit> limit_beyond(TriedLay passing, bool down, const LimitSearch& search, const TryLay& try_at);

/// The least value with which a lay passes, searched from `begin` on: down where it passes, else up and then down for
/// one that does. None where no lay that is tried passes. Where even the smallest tried passes, it is `passing` and
/// `beyond` alike.
std::optional<LayLimit> least_passing(const TriedLay& begin, const LimitSearch& search, const TryLay& try_at);

}  // namespace overbend
