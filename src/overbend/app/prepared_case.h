/// A model with its equilibrium, ready for a dynamic run.
#pragma once

#include <memory>
#include <string>

#include "study/dynamic_realisation.h"

namespace overbend {

struct PreparedCase {
  Description description;
  Model model;
  StaticSolution start;
  StaticResults statics;
  std::string input;  ///< Of input_text().

  /// Valid as long as this lives, where it lives.
  DynamicCase shared() const { return {description, model, start, statics, input}; }
};

/// Tells on stderr why there is no equilibrium; the code that the program ends with.
ExitCode tell_failure(const StaticFailure& failure);

/// Builds the model and solves its statics. Null where it cannot be run, told on stderr; `code` says why.
std::unique_ptr<PreparedCase> prepare_case(const Description& description, ExitCode& code);

/// Sets the simulated time to a quantity such as "600 s"; an empty text leaves the model's. False where it is none,
/// told on stderr.
bool set_duration(Description& description, const std::string& text);

}  // namespace overbend
