/// The winch of a mooring line as the model describes it.
#pragma once

#include <optional>

#include "mechanics/winch.h"
#include "model/mooring_description.h"

namespace overbend {

/// The law of the winch that a line names. None where the line has no winch, or one that holds its length whatever the
/// tension. A winch that follows the lengths of an operation gets its table from that.
std::optional<WinchLaw> winch_of(const MooringsDescription& moorings, const MooringLineDescription& line);

}  // namespace overbend
