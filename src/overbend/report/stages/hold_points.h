/// Where an operation on the line pauses: before the head meets something else, and before the hardest stage.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/operation_results.h"

namespace overbend {

struct HoldPoint {
  std::size_t stage = 0;      ///< Before this one.
  std::string what;           ///< Plain text: "the head leaves the stinger tip".
  std::optional<double> out;  ///< How far the line has gone by then, linear between the stages [m].
};

/// In the order of the stages. Found from the places of the head at neighbouring stages that have an equilibrium: last
/// roller, stinger tip, water line, sea bed; and the stage whose checks are used most, or its cable where that is more.
std::vector<HoldPoint> hold_points(const OperationResults& results);

/// The check or the cable that is used most at a stage.
struct StageUse {
  double utilisation = 0.0;
  std::string what;  ///< Plain text: "local buckling, load controlled, sagbend".
};
/// None where nothing is judged.
std::optional<StageUse> largest_use(const StageResult& stage);

/// The stage that is used most; none where nothing is judged.
std::optional<std::size_t> hardest_stage(const OperationResults& results);

}  // namespace overbend
