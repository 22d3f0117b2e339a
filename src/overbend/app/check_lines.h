/// The code checks on the command line.
#pragma once

#include <string>

#include "app/exit_code.h"
#include "results/check_results.h"

namespace overbend {

/// The governing checks, a line per region: how far each is used, by what and where.
std::string check_lines(const CheckTable& table);

/// "  verdict                     PASSED"
std::string verdict_line(const CheckTable& table, const Findings& findings);

/// With `strict`, kCheckExceeded where the verdict is exceeded or reserved by serious findings, told on stderr; else
/// kDone.
ExitCode strict_code(const CheckTable& table, const Findings& findings, bool strict);

}  // namespace overbend
