/// Status of a finished run or study.
#pragma once

#include <string>

namespace overbend {

enum class RunStatus {
  done,
  interrupted,  ///< Stopped by its observer; a checkpoint is kept.
  wrong_input,  ///< Invalid model, folder or checkpoint.
  no_solution,
  error,  ///< Error of the disk or the program.
};

struct RunResult {
  RunStatus ending = RunStatus::done;
  std::string why{};  ///< One-line reason, if it did not end well.
};

}  // namespace overbend
