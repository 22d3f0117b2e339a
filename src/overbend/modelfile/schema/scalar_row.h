/// Keys of the model file with a single value.
#pragma once

#include <string>

#include "modelfile/schema/field.h"

namespace overbend {

/// Returns the row of a key with a single value of any kind, list items in brackets; null if there is none.
const Field* scalar_row(const std::string& key);

}  // namespace overbend
