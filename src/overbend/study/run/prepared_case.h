/// A model with its equilibrium, ready for dynamic analysis.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "dynamics/machines/controller.h"
#include "model/model.h"
#include "results/static_results.h"
#include "statics/solver/statics.h"
#include "study/run/run_status.h"

namespace overbend {

/// Constant and shared by all runs that differ in the seed alone.
struct PreparedCase {
  Description description;
  Model model;
  StaticSolution start;
  StaticResults statics;
  std::string input;  ///< Result of input_text(), with the additions of use_controllers().
  /// External controllers of machines of the run. They keep state: a case with controllers serves one run at a time.
  std::vector<ControllerUse> controllers{};
};

/// Returns all that a run depends on, except the seed; a run is resumed only with the same text.
std::string input_text(const Description& description);

/// Sets the controllers of a case. Their machines and intervals become part of its input: a run started with
/// controllers cannot be resumed without them, nor the reverse. Their commands are unknown here: the caller must supply
/// the same controllers when a run is resumed.
void use_controllers(PreparedCase& prepared, std::vector<ControllerUse> controllers);

/// Returns one line about a failure: what, where and why.
std::string failure_line(const StaticFailure& failure);

/// Returns the failure as the result of a run.
RunResult failure_result(const StaticFailure& failure, const Description& description);

/// Returns an error if a dynamic run of the model would show nothing: calm water and no motion.
std::optional<RunResult> reject_calm_run(const Description& description);

/// Builds the model and solves its statics; returns an error if it cannot be run.
std::variant<std::shared_ptr<const PreparedCase>, RunResult> prepare_case(
    const Description& description, const std::vector<ControllerUse>& controllers = {});

}  // namespace overbend
