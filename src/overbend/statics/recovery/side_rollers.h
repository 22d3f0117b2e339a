/// Ambiguity of the equilibrium of a lay on mooring lines.
#pragma once

#include <optional>
#include <string>

#include "base/finding.h"
#include "model/description/description.h"
#include "results/static_results.h"

namespace overbend {

/// A vessel displaced by its pipe while side rollers hold the pipe may have several equilibria: the loaded rollers
/// depend on how both came there. Returns a finding that names the boxes with loaded side rollers and their forces;
/// nullopt if there are none or the line lengths hold the vessel in its nominal pose.
std::optional<Finding> warn_of_side_roller_contact(const Description& description, const StaticResults& results);

}  // namespace overbend
