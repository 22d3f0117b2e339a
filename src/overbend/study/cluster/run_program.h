/// Runs another program as a child process, without a shell.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace overbend {

struct ProgramOutput {
  int code = 0;  ///< Exit code; 128 plus the signal if one terminated it.
  std::string out, err;
};

/// Runs the program named by the first item of `command`, found on the PATH, with the other items as arguments,
/// unchanged, and waits for it; its input is empty. Empty if there is no such program.
std::optional<ProgramOutput> run_program(const std::vector<std::string>& command);

}  // namespace overbend
