/// Counts over all rollers of a dynamic run.
#pragma once

#include <string>

#include "results/dynamic_results.h"

namespace overbend {

/// A roller with the box it belongs to; both null where there is none.
struct RollerPlace {
  const SupportDynamics* box = nullptr;
  const RollerDynamics* roller = nullptr;
  std::string name() const;  ///< "stinger 8, row 3, bottom".
};

struct ContactCount {
  int carrying = 0;     ///< Rollers that carry in the static state.
  int losing = 0;       ///< Of these, that lose the pipe at some time.
  int never = 0;        ///< Bottom rollers that the pipe never touches.
  int bottom = 0;       ///< All bottom rollers.
  RollerPlace hardest;  ///< With the largest reaction of all times.
};

ContactCount count_contacts(const DynamicResults& results);

/// The roller of this index in Supports::rollers.
RollerPlace find_roller(const DynamicResults& results, int roller);

}  // namespace overbend
