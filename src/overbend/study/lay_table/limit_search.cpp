#include "study/lay_table/limit_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace overbend {
namespace {

constexpr double kNoLay = std::numeric_limits<double>::infinity();

TriedLay tried(double value, const TryLay& try_at) {
  return {value, try_at(value)};
}

/// Distance of a lay from passing: its utilisation, 0 if it passes.
double distance_from_passing(const LayCase& lay) {
  if (lay.passed()) return 0.0;
  return lay.lay ? lay.lay->utilisation.value_or(kNoLay) : kNoLay;
}

class MinPassingSearch {
 public:
  MinPassingSearch(const LimitSearch& search, const TryLay& try_near, const TryLay& try_at)
      : search_(search), try_near_(try_near), try_at_(try_at) {}

  MinPassingLay run(double from, double to) {
    std::vector<std::pair<double, double>> steps;  // value and distance from passing
    for (double value = from; !limit_; value = std::min(value * search_.min_search_factor, to)) {
      steps.emplace_back(value, look_at(value));
      const std::size_t n = steps.size();
      if (!limit_ && n >= 3 && steps[n - 2].second < steps[n - 3].second &&
          steps[n - 2].second <= steps[n - 1].second) {
        close_in(steps[n - 3].first, steps[n - 1].first);
      }
      if (value >= to) break;
    }
    MinPassingLay result{std::move(limit_), {}};
    for (auto& [value, lay] : tried_) result.tried.push_back({value, std::move(lay)});
    return result;
  }

 private:
  double look_at(double value) {
    LayCase& lay = tried_[value] = try_near_(value);
    if (lay.passed()) {
      lay = try_at_(value);
      if (lay.passed()) found({value, lay});
    }
    return distance_from_passing(lay);
  }

  /// Golden-section search for the lay nearest to passing.
  void close_in(double low, double high) {
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
    double inner = high - golden * (high - low), outer = low + golden * (high - low);
    double at_inner = look_at(inner), at_outer = limit_ ? 0.0 : look_at(outer);
    while (!limit_ && high - low > search_.tolerance * high) {
      if (at_inner <= at_outer) {
        high = std::exchange(outer, inner);
        at_outer = at_inner;
        inner = high - golden * (high - low);
        at_inner = look_at(inner);
      } else {
        low = std::exchange(inner, outer);
        at_inner = at_outer;
        outer = low + golden * (high - low);
        at_outer = look_at(outer);
      }
    }
  }

  void found(TriedLay passing) {
    for (auto below = tried_.lower_bound(passing.value); below != tried_.begin();) {
      --below;
      TriedLay less = tried(below->first, try_at_);
      if (!less.lay.passed()) {
        limit_ = narrowed(std::move(passing), std::move(less), search_, try_at_);
        return;
      }
      passing = std::move(less);
    }
    limit_ = LayLimit{passing, passing};
  }

  const LimitSearch& search_;
  const TryLay &try_near_, &try_at_;
  std::map<double, LayCase> tried_;
  std::optional<LayLimit> limit_;
};

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
  for (int i = 0; i < search.max_steps; ++i) {
    TriedLay next = tried(passing.value * factor, try_at);
    if (!next.lay.passed()) return narrowed(std::move(passing), std::move(next), search, try_at);
    passing = std::move(next);
  }
  return std::nullopt;
}

MinPassingLay find_min_passing(double from, double to, const LimitSearch& search, const TryLay& try_near,
                               const TryLay& try_at) {
  return MinPassingSearch(search, try_near, try_at).run(from, to);
}

}  // namespace overbend
