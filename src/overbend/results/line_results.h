/// What is found of lines by themselves: at rest, and in motion. SI; frame W.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/finding.h"
#include "base/vec.h"
#include "results/dynamic_results.h"

namespace overbend {

/// A node of a line.
struct LineNodeResult {
  double s = 0.0;                                     ///< Unstressed length from the first end [m].
  Vec3 place = Vec3::Zero();                          ///< [m]
  double tension = 0.0;                               ///< Effective [N].
  double least_tension = 0.0, largest_tension = 0.0;  ///< Over time; of statics where there is no run [N].
};

/// An end of a line. Forces are those on the line by what holds it.
struct LineEndResult {
  Vec3 force = Vec3::Zero();  ///< [N]
  double tension = 0.0;       ///< Size of the force [N].
  double declination = 0.0;   ///< Of the line there from horizontal, positive where it hangs from its end [rad].
  Spread in_time;             ///< Of the tension; of statics where there is no run [N].
};

struct LineResult {
  std::string name;
  double length = 0.0;  ///< Unstressed [m].
  int elements = 0;
  double weight = 0.0;                                ///< Submerged, of the segments and points [N].
  double on_bed = 0.0;                                ///< Length that the bed bears [m].
  double largest_tension = 0.0, least_tension = 0.0;  ///< Along the line at rest [N].
  std::optional<double> utilisation;                  ///< Largest tension over its segment's breaking load [-].
  double residual = 0.0;                              ///< Largest unbalanced force over the weight in air [-].
  int iterations = 0;
  LineEndResult first, second;
  std::vector<LineNodeResult> nodes;
  /// Over time, where there was a run: least and largest tension along the line, and the histories at the ends.
  double least_in_time = 0.0, largest_in_time = 0.0;  ///< [N]
  std::optional<double> utilisation_in_time;          ///< Largest over time over its segment's breaking load [-].
  std::vector<double> first_history, second_history;  ///< [N]
};

struct LinesResults {
  std::string title, version;
  Assumptions assumptions;
  Findings findings;
  CheckTable checks;
  std::vector<LineResult> lines;
  bool moved = false;         ///< Whether there was a run.
  std::vector<double> time;   ///< Of the histories [s].
  double energy_drift = 0.0;  ///< Of the run: what is missing over what went through [-].
  int steps = 0;
};

}  // namespace overbend
