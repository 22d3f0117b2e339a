/// Findings in the terminal.
#pragma once

#include <string>

#include "base/finding.h"

namespace overbend {

/// A line for each, the serious ones first: "  serious: the pipe has left 'stinger 8' ... [pipe-off-rollers]".
std::string finding_lines(const Findings& findings);

/// The same of several runs, with the number of runs that have each: "  serious (3 of 5 seeds): ...".
std::string shared_finding_lines(const std::vector<Findings>& runs, const std::string& runs_name);

}  // namespace overbend
