/// Assumptions on floating hulls, moorings and free lines: sentences for the report.
#pragma once

#include "base/assumption.h"
#include "model/model.h"

namespace overbend {

/// Appends the assumptions on hull, mooring lines and free lines; nothing if there are none.
void assume_floating(Assumptions& list, const Model& model);

}  // namespace overbend
