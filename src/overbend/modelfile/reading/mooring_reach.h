/// Check that mooring lines of given length reach their anchors.
#pragma once

#include "base/diagnostics.h"
#include "model/description/description.h"
#include "modelfile/schema/field_value.h"

namespace overbend {

/// Reports, at the key of its length, every mooring line that would have to break to reach its anchor from the vessel
/// as drawn on a level seabed. Lines whose length follows from a tension always reach.
void check_reach(const FieldValue& root, const Description& description, Diagnostics& diagnostics);

}  // namespace overbend
