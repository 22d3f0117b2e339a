#include "app/exit_code.h"

#include <iostream>

namespace overbend {
namespace {

ExitCode code_of(RunEnding ending) {
  switch (ending) {
    case RunEnding::done:
      return kDone;
    case RunEnding::interrupted:
      return kInterrupted;
    case RunEnding::wrong_input:
      return kWrongInput;
    case RunEnding::no_solution:
      return kNoSolution;
    case RunEnding::fault:
      break;
  }
  return kInternalFault;
}

}  // namespace

ExitCode tell(const RunEnd& end) {
  if (end.ending == RunEnding::interrupted) {
    std::cerr << "overbend: interrupted; continue the run with --resume\n";
  } else if (!end.why.empty()) {
    std::cerr << "overbend: " << end.why << "\n";
  }
  return code_of(end.ending);
}

}  // namespace overbend
