/// Operations whose stages a goal seek evaluates; for all others it evaluates the normal lay configuration.
#pragma once

#include "model/description/mooring_description.h"

namespace overbend {

inline bool is_seek_over_stages(OperationType type) {
  return type == OperationType::lift || drags_along_bed(type);
}

}  // namespace overbend
