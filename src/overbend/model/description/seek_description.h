/// Goal seek: which keys of the model may change, and what its results are to be. SI.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace overbend {

/// A key of the model file, or several that a pattern stands for, with its bounds.
struct SeekVariable {
  std::string key;   ///< "supports.stinger.boxes[stinger 3].z": items by name, by index from 0, or by pattern.
  std::string unit;  ///< SI unit of its dimension, "1" for plain numbers.
  std::string show;  ///< Unit that it is written in; empty for plain numbers.
  std::optional<double> from;    ///< Bounds of the value,
  std::optional<double> to;      ///< both or none.
  std::optional<double> within;  ///< Instead: how far the value may go either way from where the model has it.
};

enum class SeekRelation { equals, at_most, at_least };

/// What a result is to be. A name with a pattern stands for every value that it matches.
struct SeekCondition {
  std::string result;  ///< As in summary.json, see resultfiles/summary/named_results.h.
  std::string unit;    ///< SI unit of its dimension.
  SeekRelation relation = SeekRelation::equals;
  double value = 0.0;
};

struct SeekDescription {
  std::vector<SeekVariable> vary;
  std::vector<SeekCondition> until;
  std::string minimise;  ///< A result; empty: the values nearest to the model's that meet the conditions.
};

}  // namespace overbend
