/// Queries on moorings and station keeping.
#pragma once

#include "model/description/description.h"

namespace overbend {

bool has_mooring_lines(const Description& description);

/// Returns true if the hull is free to move: it has hydrostatics or floats in coupled motion.
bool hull_is_free(const Description& description);

/// Returns true if dynamic positioning holds a free hull, with or without mooring lines.
bool is_positioned(const Description& description);

/// Returns true if statics finds the vessel's position: on mooring lines, by dynamic positioning, or both.
inline bool finds_vessel_position(const Description& description) {
  return has_mooring_lines(description) || is_positioned(description);
}

/// Returns true if the model needs a vessel; free lines alone need none.
bool has_vessel(const Description& description);

/// Returns the model's moorings; without lines if it has none.
const MooringsDescription& find_moorings(const Description& description);

}  // namespace overbend
