/// Ranges of lay tables on the command line.
#pragma once

#include <string>

#include "model/description/lay_table_description.h"

namespace overbend {

/// Sets the range and steps of the table from a text such as "200 kN..400 kN/20" or "200..400 kN/20" of `vary`; the
/// steps may be omitted. Throws std::invalid_argument with a message for the user if the text is not a range.
void take_range(LayTableVary vary, const std::string& range, LayTableDescription& table);

}  // namespace overbend
