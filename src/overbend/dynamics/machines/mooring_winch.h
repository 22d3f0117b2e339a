/// The winch of a mooring line as the model describes it.
#pragma once

#include <optional>

#include "mechanics/winch.h"
#include "model/description/mooring_description.h"

namespace overbend {

/// The law of a winch, of whatever mode. One that follows the lengths of an operation gets its table from that.
WinchLaw winch_law(const WinchDescription& winch);

/// The winch that a line names; null where it names none.
const WinchDescription* winch_named_by(const MooringsDescription& moorings, const MooringLineDescription& line);

/// The law of the winch that a line names. None where the line has no winch, or one that holds its length whatever the
/// tension.
std::optional<WinchLaw> winch_of(const MooringsDescription& moorings, const MooringLineDescription& line);

}  // namespace overbend
