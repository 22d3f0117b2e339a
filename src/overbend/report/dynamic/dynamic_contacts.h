/// Counts over all rollers of a dynamic run.
#pragma once

#include <string>

#include "results/dynamic_results.h"

namespace overbend {

/// A roller and its box; both null if there is none.
struct RollerPlace {
  const SupportDynamics* box = nullptr;
  const RollerDynamics* roller = nullptr;
  std::string name() const;  ///< "stinger 8, row 3, bottom".
};

struct ContactCount {
  int carrying = 0;     ///< Number of rollers in contact in the static state.
  int losing = 0;       ///< Number of these that lose contact at some time.
  int never = 0;        ///< Number of bottom rollers never in contact.
  int bottom = 0;       ///< Number of bottom rollers.
  RollerPlace hardest;  ///< Roller with the maximum reaction over time.
};

/// Counts contacts over all rollers of the run.
ContactCount count_contacts(const DynamicResults& results);

/// Returns the roller with this index in Supports::rollers.
RollerPlace find_roller(const DynamicResults& results, int roller);

}  // namespace overbend
