/// Exit codes of the program.
#pragma once

#include "study/run/run_status.h"

namespace overbend {

enum ExitCode : int {
  kDone = 0,
  kInternalError = 1,
  kWrongInput = 2,     ///< Error in the model file or on the command line.
  kNoSolution = 3,     ///< No equilibrium or no answer; the message states what, where and why.
  kCheckExceeded = 4,  ///< With --strict: utilisation above 1, or serious findings.
  kInterrupted = 130,
};

/// Prints a message on stderr if the run did not end normally, and returns the exit code.
ExitCode report_status(const RunResult& end);

}  // namespace overbend
