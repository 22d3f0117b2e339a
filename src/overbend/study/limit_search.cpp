#include "study/limit_search.h"

#include <cmath>

namespace overbend {
namespace {

TriedLay tried(double value, const TryLay& try_at) {
  return {value, try_at(value)};
}

}  // namespace

LayLimit narrowed(TriedLay passing, TriedLay failing, const LimitSearch& search, const TryLay& try_at) {
  while (std::abs(passing.value - failing.value) > search.tolerance * std::abs(passing.value)) {
    TriedLay middle = tried(0.5 * (passing.value + failing.value), try_at);
    (middle.lay.passed() ? passing : failing) = std::move(middle);
  }
  return {std::move(passing), std::move(failing)};
}

std::optional<LayLimit> limit_beyond(TriedLay passing, bool down, const LimitSearch& search, const TryLay& try_at) {
  const double factor = down ? 1.0 / search.factor : search.factor;
  for (int i = 0; i < search.most_steps; ++i) {
    TriedLay next = tried(passing.value * factor, try_at);
    if (!next.lay.passed()) return narrowed(std::move(passing), std::move(next), search, try_at);
    passing = std::move(next);
  }
  return std::nullopt;
}

std::optional<LayLimit> least_passing(const TriedLay& begin, const LimitSearch& search, const TryLay& try_at) {
  const auto downwards = [&](const TriedLay& passing) -> LayLimit {
    std::optional<LayLimit> limit = limit_beyond(passing, true, search, try_at);
    return limit ? std::move(*limit) : LayLimit{passing, passing};
  };
  if (begin.lay.passed()) return downwards(begin);
  TriedLay before = begin;
  for (int i = 0; i < search.most_steps; ++i) {
    TriedLay next = tried(before.value * search.factor, try_at);
    if (next.lay.passed()) return narrowed(std::move(next), std::move(before), search, try_at);
    before = std::move(next);
  }
  double value = begin.value;
  for (int i = 0; i < search.most_steps; ++i) {
    value /= search.factor;
    const TriedLay next = tried(value, try_at);
    if (next.lay.passed()) return downwards(next);
  }
  return std::nullopt;
}

}  // namespace overbend
