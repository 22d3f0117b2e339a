/// What the equilibrium of a lay on mooring lines hangs on besides the loads.
#pragma once

#include <optional>
#include <string>

#include "base/finding.h"
#include "model/description/description.h"
#include "results/static_results.h"

namespace overbend {

/// A vessel that gives way to its pipe while side rollers hold that may rest in several ways: which rollers the pipe
/// bears on hangs on how both came there. A sentence that names the boxes whose side rollers bear, and with what;
/// nothing where none do or where the lengths of the lines hold the vessel as drawn.
std::optional<Finding> find_side_roller_contact(const Description& description, const StaticResults& results);

}  // namespace overbend
