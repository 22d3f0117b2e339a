/// Command line of the program.
#pragma once

namespace overbend {

/// Runs the program and returns its exit code (app/exit_code.h). Does not throw: an internal error prints one line on
/// stderr.
int run_command_line(int count, const char* const* arguments);

}  // namespace overbend
