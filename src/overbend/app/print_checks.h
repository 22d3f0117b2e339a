/// Text of the code checks for the terminal.
#pragma once

#include <string>

#include "app/exit_code.h"
#include "results/check_results.h"
#include "results/verdict.h"

namespace overbend {

/// Returns a line per region with the governing check: utilisation, criterion and location.
std::string check_lines(const CheckTable& table);

/// Returns a line such as "  verdict                     PASSED".
std::string verdict_line(const Verdict& verdict);

/// Returns kCheckExceeded, with a message on stderr, if `strict` is set and the verdict is exceeded or reserved by
/// serious findings; kDone otherwise.
ExitCode strict_code(const CheckTable& table, const Findings& findings, bool strict);

}  // namespace overbend
