/// Hold points of an operation on the line: before the head meets another object, and before the governing stage.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/operation_results.h"

namespace overbend {

struct HoldPoint {
  std::size_t stage = 0;      ///< The stage after the hold point.
  std::string what;           ///< Plain text: "the head leaves the stinger tip".
  std::optional<double> out;  ///< Progress of the line, linear between the stages [m].
};

/// Returns the hold points in the order of the stages. They are found from the positions of the head at consecutive
/// stages with an equilibrium: last roller, stinger tip, water line, seabed; and the stage with the maximum utilisation
/// of its checks or its cable.
std::vector<HoldPoint> hold_points(const OperationResults& results);

/// The check or the cable with the maximum utilisation at a stage.
struct StageUtilisation {
  double utilisation = 0.0;
  std::string what;  ///< Plain text: "local buckling, load controlled, sagbend".
};
/// Returns none if nothing is judged.
std::optional<StageUtilisation> find_max_utilisation(const StageResult& stage);

/// Returns the stage with the maximum utilisation; none if nothing is judged.
std::optional<std::size_t> find_governing_stage_index(const OperationResults& results);

}  // namespace overbend
