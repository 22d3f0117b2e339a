/// How the program ends.
#pragma once

#include "study/run/run_ending.h"

namespace overbend {

enum ExitCode : int {
  kDone = 0,
  kInternalFault = 1,
  kWrongInput = 2,     ///< The model file or the command line.
  kNoSolution = 3,     ///< Told: what, where, why.
  kCheckExceeded = 4,  ///< With --strict: a utilisation above 1.
  kInterrupted = 130,
};

/// Tells on stderr what did not end well, if anything, and returns the exit code for it.
ExitCode tell(const RunEnd& end);

}  // namespace overbend
