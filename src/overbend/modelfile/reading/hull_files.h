/// Reading of the files of a coupled hull.
#pragma once

#include "base/diagnostics.h"
#include "model/description/description.h"
#include "modelfile/schema/field_value.h"

namespace overbend {

/// Fills the description's hydrodynamic data and tables of current and wind coefficients, and reports where they do not
/// fit the vessel. No effect without a coupled hull.
void read_hull_files(const FieldValue& root, Description& description, Diagnostics& diagnostics);

}  // namespace overbend
