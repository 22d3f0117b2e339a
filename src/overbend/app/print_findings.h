/// Text of findings for the terminal.
#pragma once

#include <string>

#include "base/finding.h"

namespace overbend {

/// Returns a line for each finding, the serious ones first: "  serious: the pipe has left 'stinger 8' ...
/// [pipe-off-rollers]".
std::string finding_lines(const Findings& findings);

/// The same for several runs, with the number of runs that have each finding: "  serious (3 of 5 seeds): ...".
std::string shared_finding_lines(const std::vector<Findings>& runs, const std::string& runs_name);

}  // namespace overbend
