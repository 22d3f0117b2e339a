/// What a lay table varies, in the words of the command line.
#pragma once

#include <string>

#include "model/description/lay_table_description.h"

namespace overbend {

/// Puts a range such as "200 kN..400 kN/20" or "200..400 kN/20" of `vary` into the table; the steps may be left out.
/// Throws std::invalid_argument, with what to tell, where it is none.
void take_range(LayTableVary vary, const std::string& range, LayTableDescription& table);

}  // namespace overbend
