/// What the value of an option may be, with messages that say what was found and what was expected.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace overbend {

/// One of the words, as they are written.
CLI::Validator one_of_words(const std::vector<std::string>& words);

CLI::Validator whole_number(int low, int high);

/// A finite number from 0 on.
CLI::Validator seconds();

}  // namespace overbend
