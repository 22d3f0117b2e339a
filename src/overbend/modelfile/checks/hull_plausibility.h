/// Plausibility of a floating hull: its numbers against each other and its dimensions.
#pragma once

#include "base/diagnostics.h"
#include "model/description/description.h"
#include "modelfile/schema/field_value.h"

namespace overbend {

/// Checks the mass against the displaced water (an error, since constant forces would balance the difference), centre
/// of gravity and radii of gyration against the dimensions, metacentric height, and the water density of the files
/// against that of the model. Call after the hull's files are read.
void check_hull_plausibility(const FieldValue& root, const Description& description, Diagnostics& diagnostics);

}  // namespace overbend
