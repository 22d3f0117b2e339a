/// Selection of the stations of a long line that are drawn.
#pragma once

#include <algorithm>
#include <cstddef>
#include <set>

namespace overbend {

/// Returns indices of at least the first, the last, and those selected by `is_extreme(i)`; of the others as many as a
/// printed figure can show, equally spaced. In ascending order.
template <class IsExtreme>
std::set<std::size_t> thinned(std::size_t count, IsExtreme is_extreme) {
  constexpr std::size_t kMaxStations = 2500;
  if (count == 0) {
    return {};
  }
  std::set<std::size_t> keep = {0, count - 1};
  const std::size_t stride = std::max<std::size_t>((count + kMaxStations - 1) / kMaxStations, 1);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % stride == 0 || (i > 0 && i + 1 < count && is_extreme(i))) {
      keep.insert(i);
    }
  }
  return keep;
}

}  // namespace overbend
