/// Groups of waves that exist at once: wind sea and swell.
#pragma once

#include <cstdint>
#include <vector>

#include "model/description/waves_description.h"

namespace overbend {

using WaveGroups = std::vector<WavesDescription>;

inline bool is_regular(WaveType type) {
  return type == WaveType::airy || type == WaveType::stokes5;
}

/// Returns true for a sea of many waves: from a spectrum, or as measured.
inline bool is_irregular(WaveType type) {
  return type != WaveType::none && !is_regular(type);
}

/// Returns true if the phases depend on the seed.
inline bool is_random(WaveType type) {
  return is_irregular(type) && type != WaveType::elevation;
}

bool is_calm(const WaveGroups& groups);
bool is_irregular(const WaveGroups& groups);
bool is_random(const WaveGroups& groups);

/// Returns the significant wave height of all irregular groups together, the root of the sum of their squares [m].
double significant_height(const WaveGroups& groups);

/// Returns the maximum of the groups' peak periods or periods [s]; 0 in calm water and for measured
/// elevations.
double max_period(const WaveGroups& groups);

/// Returns the seed of a run that is given none: that of the first random group.
std::uint64_t default_seed(const WaveGroups& groups);

/// Returns the seed of the random numbers of one group in a run of this seed.
///
/// A run's seed replaces that of the first random group, and shifts those of all others by the same difference, so that
/// every group varies with it. Each place in the list has a stream of its own: the same seed in two groups gives
/// different phases. The stream of the first place is the seed itself.
std::uint64_t group_seed(const WaveGroups& groups, std::size_t index, std::uint64_t run_seed);

}  // namespace overbend
