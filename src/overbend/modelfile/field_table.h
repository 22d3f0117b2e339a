/// The table of all keys of the model file.
#pragma once

#include <vector>

#include "modelfile/field.h"

namespace overbend {

/// Every key, groups before their members, in the order of the reference page.
const std::vector<Field>& field_table();

/// Version of the format that this program reads, the value of the key `overbend`.
inline constexpr int kFormatVersion = 1;

}  // namespace overbend
