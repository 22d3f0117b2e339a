/// What keeps a vessel in its place.
#pragma once

#include "model/description/description.h"

namespace overbend {

bool has_mooring_lines(const Description& description);

/// Whether the hull is free to move: it has hydrostatics or floats in coupled motion.
bool hull_is_free(const Description& description);

/// Whether dynamic positioning holds a hull that is free, with mooring lines or without.
bool is_positioned(const Description& description);

/// Whether statics find where the vessel lies: on its mooring lines, by dynamic positioning, or both.
inline bool has_station(const Description& description) {
  return has_mooring_lines(description) || is_positioned(description);
}

/// Whether something is on a vessel: lines by themselves need none.
bool has_vessel(const Description& description);

/// The model's moorings; of no lines where it has none.
const MooringsDescription& moorings_of(const Description& description);

}  // namespace overbend
