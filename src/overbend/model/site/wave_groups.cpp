#include "model/site/wave_groups.h"

#include <algorithm>
#include <cmath>

#include "base/random.h"

namespace overbend {

bool is_calm(const WaveGroups& groups) {
  return std::all_of(groups.begin(), groups.end(), [](const auto& group) { return group.type == WaveType::none; });
}

bool is_irregular(const WaveGroups& groups) {
  return std::any_of(groups.begin(), groups.end(), [](const auto& group) { return is_irregular(group.type); });
}

bool is_random(const WaveGroups& groups) {
  return std::any_of(groups.begin(), groups.end(), [](const auto& group) { return is_random(group.type); });
}

double significant_height(const WaveGroups& groups) {
  double squares = 0.0;
  for (const WavesDescription& group : groups) squares += is_irregular(group.type) ? group.hs * group.hs : 0.0;
  return std::sqrt(squares);
}

double max_period(const WaveGroups& groups) {
  double max_value = 0.0;
  for (const WavesDescription& group : groups) {
    if (group.type != WaveType::none) max_value = std::max(max_value, group.period > 0.0 ? group.period : group.tp);
  }
  return max_value;
}

std::uint64_t default_seed(const WaveGroups& groups) {
  for (const WavesDescription& group : groups) {
    if (is_random(group.type)) return group.seed;
  }
  return groups.empty() ? WavesDescription{}.seed : groups.front().seed;
}

std::uint64_t group_seed(const WaveGroups& groups, std::size_t index, std::uint64_t run_seed) {
  constexpr std::uint64_t kBetweenStreams = 0xD1B54A32D192ED03U;  // odd, so that no two streams coincide
  const std::uint64_t seed = groups[index].seed + (run_seed - default_seed(groups));
  if (index == 0) return seed;
  std::uint64_t state = seed + index * kBetweenStreams;
  return splitmix64(state);
}

}  // namespace overbend
