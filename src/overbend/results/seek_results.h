/// Results of a goal seek: plain data, SI units.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/description/seek_description.h"

namespace overbend {

/// One key that was varied.
struct SeekUnknown {
  std::string path;       ///< Path in the model file, indices from 0: "supports.stinger.boxes[2].z".
  std::string name;       ///< The same with the name of the item, for readers.
  std::string unit;       ///< SI.
  std::string show;       ///< Unit it is written in; empty for plain numbers.
  double from = 0.0;      ///< Bounds [unit].
  double to = 0.0;        ///< [unit]
  double before = 0.0;    ///< Initial value in the model [unit].
  double answer = 0.0;    ///< [unit]
  bool at_bound = false;  ///< The answer lies on a bound.
  bool found = false;     ///< True if there is an answer.
};

/// One condition or objective at the answer.
struct SeekGoal {
  std::string result;
  std::string unit;                  ///< SI.
  std::optional<SeekRelation> is{};  ///< Relation of the condition; none for an objective that is minimised.
  double wanted = 0.0;               ///< Target [unit].
  std::optional<double> before{};    ///< Value of the initial model [unit].
  std::optional<double> reached{};   ///< [unit]
  std::vector<double> slope{};       ///< d result / d unknown, in the order of the unknowns; empty if not available.
};

/// A value of a single key at which the result jumps across the target.
struct SeekJump {
  double key_value = 0.0;  ///< Value of the key.
  double below = 0.0;      ///< Result just below.
  double above = 0.0;      ///< Result just above.
  std::string why;         ///< Supports whose contact opens or closes at the jump; empty without any.
};

/// A model evaluated during the search, with or without an equilibrium.
struct SeekStep {
  std::vector<double> values;   ///< In the order of the unknowns.
  std::vector<double> results;  ///< In the order of the goals; empty without an equilibrium.
  std::string failure;          ///< Reason for the missing equilibrium.
};

struct SeekResults {
  bool found = false;
  std::string why;  ///< Reason why there is no answer: one sentence.
  std::vector<SeekUnknown> unknowns;
  std::vector<SeekGoal> goals;
  std::vector<double> others;    ///< Further answers of a single key.
  std::vector<SeekJump> jumps;   ///< Only for a single key.
  std::optional<bool> monotone;  ///< Only for a single key: true if the result is monotone between the bounds.
  double residual = 0.0;         ///< Maximum error of a condition, relative to its target.
  int evaluations = 0;           ///< Number of models evaluated.
  double wall_time = 0.0;        ///< [s]
  std::vector<SeekStep> path;    ///< In the order of the search.
  std::vector<std::string> remarks;
  std::vector<std::string> stages;  ///< For a lift: the stages changed by the answer, as lines for a model file.
};

}  // namespace overbend
