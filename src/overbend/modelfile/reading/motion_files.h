/// The file that a vessel's motion comes from, as the model file describes it.
#pragma once

#include "base/diagnostics.h"
#include "model/description/description.h"
#include "modelfile/schema/field_value.h"

namespace overbend {

/// Fills `raos` or `history` of the vessel and of other bodies from their motion files, with the conventions stated
/// under vessel.motion.convention and the same of a body. A file that is not there leaves them empty without a
/// complaint, which the checks make; what is wrong in one that is there goes to `diagnostics`.
void read_motion_file(const FieldValue& root, Description& description, Diagnostics& diagnostics);

}  // namespace overbend
