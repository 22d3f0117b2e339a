/// Numbers of lines that follow from others, after the model file is bound.
#pragma once

#include "model/description/description.h"

namespace overbend {

/// Segments that name a type get its numbers; what was left open (started_type) follows from diameter, weight and
/// water.
void resolve_lines(Description& description);

}  // namespace overbend
