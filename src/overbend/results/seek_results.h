/// What a goal seek found: plain data, SI units.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/description/seek_description.h"

namespace overbend {

/// One key that was varied.
struct SeekUnknown {
  std::string path;       ///< In the model file, indices from 0: "supports.stinger.boxes[2].z".
  std::string name;       ///< The same with the name of the item, for people.
  std::string unit;       ///< SI.
  std::string show;       ///< Unit it is written in; empty for plain numbers.
  double from = 0.0;      ///< Bounds [unit].
  double to = 0.0;        ///< [unit]
  double before = 0.0;    ///< In the model [unit].
  double answer = 0.0;    ///< [unit]
  bool at_bound = false;  ///< The answer lies on a bound.
  bool found = false;     ///< Whether there is an answer.
};

/// One condition, or what was minimised, at the answer.
struct SeekGoal {
  std::string result;
  std::string unit;                  ///< SI.
  std::optional<SeekRelation> is{};  ///< None: minimised.
  double wanted = 0.0;               ///< [unit]
  std::optional<double> before{};    ///< Of the model as it was.
  std::optional<double> reached{};   ///< [unit]
  std::vector<double> slope{};       ///< d result / d unknown, in the order of the unknowns; empty where not told.
};

/// A place where a single result leaps over the value wanted.
struct SeekJump {
  double at = 0.0;     ///< Of the key.
  double below = 0.0;  ///< The result just below
  double above = 0.0;  ///< and just above.
  std::string why;     ///< Supports that come into contact or let go there; empty where none do.
};

/// A model that was solved on the way, or could not be.
struct SeekStep {
  std::vector<double> values;   ///< In the order of the unknowns.
  std::vector<double> results;  ///< In the order of the goals; empty where there is no equilibrium.
  std::string failure;          ///< Why not.
};

struct SeekResults {
  bool found = false;
  std::string why;  ///< Why there is no answer: one sentence.
  std::vector<SeekUnknown> unknowns;
  std::vector<SeekGoal> goals;
  std::vector<double> others;    ///< Further answers of a single key.
  std::vector<SeekJump> jumps;   ///< Of a single key.
  std::optional<bool> monotone;  ///< Of a single key: the result never turns between the bounds.
  double residual = 0.0;         ///< Largest distance from a condition, relative to what is wanted.
  int evaluations = 0;           ///< Models solved or tried.
  double wall_time = 0.0;        ///< [s]
  std::vector<SeekStep> path;    ///< In the order of the search.
  std::vector<std::string> remarks;
  std::vector<std::string> stages;  ///< Of a lift: the stages that the answer changes, as lines for a model file.
};

}  // namespace overbend
