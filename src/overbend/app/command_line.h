/// The command line: which commands there are and how the program ends.
#pragma once

namespace overbend {

/// Runs the program; returns its exit code (app/exit_code.h). Throws nothing: a fault of our own ends in one line on
/// stderr.
int run_command_line(int count, const char* const* words);

}  // namespace overbend
