/// Sentences about a goal seek.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/seek_results.h"

namespace overbend {

/// Returns the display unit of the key: that of the model file, or the corresponding US unit. Empty for plain numbers.
std::string key_unit(const SeekUnknown& unknown);
/// Returns the usual unit of a result; empty for plain numbers.
std::string goal_unit(const SeekGoal& goal);

/// Returns a value of the key in its unit of the model file: "278.469 kN".
std::string quantity_text(double value, const SeekUnknown& unknown, int digits = 6);

/// Returns a value of the result in its usual unit: "65 MPa".
std::string goal_value_text(double value, const SeekGoal& goal, int digits = 6);

/// Findings of a scan over the bounds of one key.
struct ScanSummary {
  std::optional<double> minimum, maximum;  ///< Range of the result.
  std::vector<double> gaps;                ///< Values of the key without an equilibrium, ascending.
  std::string failure;                     ///< Reason for the first of them.
};

/// Returns the reason why there is no answer.
std::string no_answer_reason(const SeekResults& results, const ScanSummary& labels);

/// Returns "at most 65 MPa".
std::string goal_text(const SeekGoal& goal);

}  // namespace overbend
