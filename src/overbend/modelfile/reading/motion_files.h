/// Motion file of the vessel as described in the model file.
#pragma once

#include "base/diagnostics.h"
#include "model/description/description.h"
#include "modelfile/schema/field_value.h"

namespace overbend {

/// Fills `raos` or `history` of the vessel and other bodies from their motion files, with the conventions given under
/// vessel.motion.convention and the same keys of a body. A missing file leaves them empty without a message, which the
/// checks add; errors in an existing file are added to `diagnostics`.
void read_motion_file(const FieldValue& root, Description& description, Diagnostics& diagnostics);

}  // namespace overbend
