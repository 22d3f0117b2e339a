/// The code checks on the command line.
#pragma once

#include <string>

#include "app/exit_code.h"
#include "results/check_results.h"

namespace overbend {

/// The governing checks, a line per region: how far each is used, by what and where.
std::string check_lines(const CheckTable& table);

/// With `strict`, kCheckExceeded where a governing utilisation is above 1, told on stderr; else kDone.
ExitCode strict_code(const CheckTable& table, bool strict);

}  // namespace overbend
