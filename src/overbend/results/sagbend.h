/// Test for pipe in the sagbend.
#pragma once

#include "results/static_results.h"

namespace overbend {

/// Returns true if any pipe or head is in the sagbend, where its stress is never zero: a cable alone may reach the
/// seabed.
inline bool has_sagbend(const StaticResults& r) {
  return r.sagbend.von_mises.value > 0.0;
}

}  // namespace overbend
