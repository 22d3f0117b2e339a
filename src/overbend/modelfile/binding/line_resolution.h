/// Derived numbers of lines, computed after the model file is bound.
#pragma once

#include "model/description/description.h"

namespace overbend {

/// Copies the numbers of named types to the segments; open numbers (make_open_line_type) follow from diameter, weight
/// and water.
void resolve_lines(Description& description);

}  // namespace overbend
