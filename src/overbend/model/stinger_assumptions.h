/// Assumptions of a stinger on hinges: sentences for the report.
#pragma once

#include "base/assumption.h"
#include "model/model.h"

namespace overbend {

/// Appends what had to be assumed of the stinger; nothing where it is fixed.
void assume_stinger(Assumptions& list, const Model& model);

}  // namespace overbend
