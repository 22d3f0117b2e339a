/// Operations whose stages a goal seek looks at; of others it looks at the lay as such.
#pragma once

#include "model/description/mooring_description.h"

namespace overbend {

inline bool is_sought_by_stages(OperationType type) {
  return type == OperationType::lift || drags_along_bed(type);
}

}  // namespace overbend
