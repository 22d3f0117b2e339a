/// Path of the program that tests run.
#pragma once

#include <string>

namespace overbend::testing {

/// Path of the program that was built with the tests' executable.
std::string program_path();

}  // namespace overbend::testing
