/// A model with its equilibrium, ready for dynamic analysis.
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "model/model.h"
#include "results/static_results.h"
#include "statics/statics.h"
#include "study/run_ending.h"

namespace overbend {

/// Constant and shared by all runs that differ in the seed alone.
struct PreparedCase {
  Description description;
  Model model;
  StaticSolution start;
  StaticResults statics;
  std::string input;  ///< Of input_text().
};

/// All that a run depends on, except the seed: a run is resumed only with the same.
std::string input_text(const Description& description);

/// One line about a failure: what, where and why.
std::string failure_line(const StaticFailure& failure);

/// The same as the end of a run.
RunEnd failed_end(const StaticFailure& failure);

/// Builds the model and solves its statics; where it cannot be run, why.
std::variant<std::shared_ptr<const PreparedCase>, RunEnd> prepare_case(const Description& description);

}  // namespace overbend
