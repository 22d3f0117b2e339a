/// Sentences about a goal seek.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/seek_results.h"

namespace overbend {

/// The unit that values of the key are shown in: the one it is written in, or the US unit of that. Empty for plain
/// numbers.
std::string key_unit(const SeekUnknown& unknown);
/// The usual unit of a result; empty for plain numbers.
std::string goal_unit(const SeekGoal& goal);

/// A value of the key in the unit it is written in: "278.469 kN".
std::string quantity_words(double value, const SeekUnknown& unknown, int digits = 6);

/// A value of the result in its usual unit: "65 MPa".
std::string result_words(double value, const SeekGoal& goal, int digits = 6);

/// What a search over the bounds of one key saw.
struct ScanWords {
  std::optional<double> least, largest;  ///< Of the result.
  std::vector<double> gaps;              ///< Values of the key without an equilibrium, rising.
  std::string failure;                   ///< Why the first of them has none.
};

/// Why there is no answer: what stands in the way.
std::string why_none(const SeekResults& results, const ScanWords& words);

/// "at most 65 MPa"
std::string wanted_words(const SeekGoal& goal);

}  // namespace overbend
