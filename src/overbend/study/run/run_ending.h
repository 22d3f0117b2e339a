/// How a run or a study ended, as a value.
#pragma once

#include <string>

namespace overbend {

enum class RunEnding {
  done,
  interrupted,  ///< By whoever follows it; a checkpoint is kept.
  wrong_input,  ///< Model, folder or what is to be resumed.
  no_solution,
  fault,  ///< Of the disk or the program.
};

struct RunEnd {
  RunEnding ending = RunEnding::done;
  std::string why{};  ///< One line, where it did not end well.
};

}  // namespace overbend
