/// Goal seek: variable keys of the model and target results. SI.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace overbend {

/// Variable: a key of the model file, or all keys that match a pattern, with bounds.
struct SeekVariable {
  std::string key;   ///< "supports.stinger.boxes[stinger 3].z": items by name, by index from 0, or by pattern.
  std::string unit;  ///< SI unit of its dimension, "1" for plain numbers.
  std::string show;  ///< Display unit; empty for plain numbers.
  std::optional<double> from;    ///< Lower bound;
  std::optional<double> to;      ///< upper bound: both or neither.
  std::optional<double> within;  ///< Alternative: max. change either way from the value in the model.
};

enum class SeekRelation { equals, at_most, at_least };

/// Condition on a result. A name with a pattern stands for every match.
struct SeekCondition {
  std::string result;  ///< Path as in summary.json, see resultfiles/summary/named_results.h.
  std::string unit;    ///< SI unit of its dimension.
  SeekRelation relation = SeekRelation::equals;
  double value = 0.0;
};

struct SeekDescription {
  std::vector<SeekVariable> vary;
  std::vector<SeekCondition> until;
  std::string minimise;  ///< Result to minimise; empty: find the feasible values nearest to those of the model.
};

}  // namespace overbend
