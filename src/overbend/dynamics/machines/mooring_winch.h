/// Winch of a mooring line from its description.
#pragma once

#include <optional>

#include "mechanics/winch.h"
#include "model/description/mooring_description.h"

namespace overbend {

/// Returns the law of a winch of any mode. A winch that follows the lengths of an operation gets its table later.
WinchLaw winch_law(const WinchDescription& winch);

/// Returns the winch named by a line; null if it names none.
const WinchDescription* find_winch(const MooringsDescription& moorings, const MooringLineDescription& line);

/// Returns the law of the winch named by a line. Empty if the line has no winch, or a winch that holds its length at
/// any tension.
std::optional<WinchLaw> find_winch_law(const MooringsDescription& moorings, const MooringLineDescription& line);

}  // namespace overbend
