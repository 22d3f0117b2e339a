/// Where the program is that tests run.
#pragma once

#include <string>

namespace overbend::testing {

/// Of the program that was built with the tests' executable.
std::string program_path();

}  // namespace overbend::testing
