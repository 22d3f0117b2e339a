/// Assumptions on a hinged stinger: sentences for the report.
#pragma once

#include "base/assumption.h"
#include "model/model.h"

namespace overbend {

/// Appends the assumptions on the stinger; nothing if it is fixed.
void assume_stinger(Assumptions& list, const Model& model);

}  // namespace overbend
