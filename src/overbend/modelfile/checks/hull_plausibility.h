/// Numbers of a floating hull against each other and against its size.
#pragma once

#include "base/diagnostics.h"
#include "model/description/description.h"
#include "modelfile/schema/field_value.h"

namespace overbend {

/// Mass against the water that the hull displaces (an error: the difference would be held by constant forces), centre
/// of gravity and radii of gyration against its dimensions, metacentric height, and the density of water behind the
/// files' values against that of the model. After the hull's files were read.
void check_hull_plausibility(const FieldValue& root, const Description& description, Diagnostics& diagnostics);

}  // namespace overbend
