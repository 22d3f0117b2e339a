/// Assumptions of floating hulls, moorings and lines: sentences for the report.
#pragma once

#include "base/assumption.h"
#include "model/model.h"

namespace overbend {

/// Appends what had to be assumed of hull, mooring lines and lines by themselves; nothing where there are none.
void assume_floating(Assumptions& list, const Model& model);

}  // namespace overbend
