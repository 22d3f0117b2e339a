#include "app/exit_code.h"

#include <iostream>

namespace overbend {
namespace {

ExitCode exit_code_of_status(RunStatus ending) {
  switch (ending) {
    case RunStatus::done:
      return kDone;
    case RunStatus::interrupted:
      return kInterrupted;
    case RunStatus::wrong_input:
      return kWrongInput;
    case RunStatus::no_solution:
      return kNoSolution;
    case RunStatus::error:
      break;
  }
  return kInternalError;
}

}  // namespace

ExitCode report_status(const RunResult& end) {
  if (end.ending == RunStatus::interrupted) {
    std::cerr << "overbend: interrupted; continue the run with --resume\n";
  } else if (!end.why.empty()) {
    std::cerr << "overbend: " << end.why << "\n";
  }
  return exit_code_of_status(end.ending);
}

}  // namespace overbend
