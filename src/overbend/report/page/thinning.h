/// Which stations of a long line are drawn.
#pragma once

#include <algorithm>
#include <cstddef>
#include <set>

namespace overbend {

/// Indices of at least the first, the last, and those that `is_extreme(i)` picks among the others; of the rest as many
/// as a printed figure can show, equally spaced. Rising.
template <class IsExtreme>
std::set<std::size_t> thinned(std::size_t count, IsExtreme is_extreme) {
  constexpr std::size_t kMost = 2500;
  if (count == 0) {
    return {};
  }
  std::set<std::size_t> keep = {0, count - 1};
  const std::size_t stride = std::max<std::size_t>((count + kMost - 1) / kMost, 1);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % stride == 0 || (i > 0 && i + 1 < count && is_extreme(i))) {
      keep.insert(i);
    }
  }
  return keep;
}

}  // namespace overbend
