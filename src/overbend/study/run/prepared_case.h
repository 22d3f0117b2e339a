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
#include "study/run/run_ending.h"

namespace overbend {

/// Constant and shared by all runs that differ in the seed alone.
struct PreparedCase {
  Description description;
  Model model;
  StaticSolution start;
  StaticResults statics;
  std::string input;  ///< Of input_text(), with what use_controllers() adds.
  /// That drive machines of its run from outside. They remember: a case that has some is for one run at a time.
  std::vector<ControllerUse> controllers{};
};

/// All that a run depends on, except the seed: a run is resumed only with the same.
std::string input_text(const Description& description);

/// Gives the run of a case controllers. They become part of its input by what they drive and how often they are asked:
/// a run begun with them is not gone on with without them, nor the other way round. What they answer is not known here:
/// that it is the same when a run is taken up is up to who gives them.
void use_controllers(PreparedCase& prepared, std::vector<ControllerUse> controllers);

/// One line about a failure: what, where and why.
std::string failure_line(const StaticFailure& failure);

/// The same as the end of a run.
RunEnd failed_end(const StaticFailure& failure, const Description& description);

/// Why a run in time of the model would show nothing: the water is calm and nothing moves.
std::optional<RunEnd> refuse_calm_run(const Description& description);

/// Builds the model and solves its statics; where it cannot be run, why.
std::variant<std::shared_ptr<const PreparedCase>, RunEnd> prepare_case(
    const Description& description, const std::vector<ControllerUse>& controllers = {});

}  // namespace overbend
