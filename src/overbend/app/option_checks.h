/// Validators of option values, with messages that state what was found and what was expected.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace overbend {

/// Accepts one of the choices, case-sensitively.
CLI::Validator one_of_choices(const std::vector<std::string>& choices);

/// Accepts an integer from `low` to `high`.
CLI::Validator whole_number(int low, int high);

/// Accepts a finite number of at least 0 [s].
CLI::Validator seconds();

}  // namespace overbend
