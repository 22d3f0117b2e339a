/// Another program as a child process, without a shell.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace overbend {

struct ProgramOutput {
  int code = 0;  ///< Exit code; 128 and the signal where one ended it.
  std::string out, err;
};

/// Runs the program of that name on the PATH with the words after it as arguments, each exactly as it is, and waits for
/// it; its input is empty. Nothing where there is no such program.
std::optional<ProgramOutput> run_program(const std::vector<std::string>& words);

}  // namespace overbend
