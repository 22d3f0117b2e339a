/// What is found of lines by themselves at rest. SI; frame W.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"

namespace overbend {

/// A node of a line.
struct LineNodeResult {
  double s = 0.0;             ///< Unstressed length from the first end [m].
  Vec3 place = Vec3::Zero();  ///< [m]
  double tension = 0.0;       ///< Effective [N].
};

/// An end of a line. Forces are those on the line by what holds it.
struct LineEndResult {
  Vec3 force = Vec3::Zero();  ///< [N]
  double tension = 0.0;       ///< Size of the force [N].
  double declination = 0.0;   ///< Of the line there from horizontal, positive where it hangs from its end [rad].
};

struct LineResult {
  std::string name;
  double length = 0.0;  ///< Unstressed [m].
  int elements = 0;
  double weight = 0.0;                                ///< Submerged, of the segments and points [N].
  double on_bed = 0.0;                                ///< Length that the bed bears [m].
  double largest_tension = 0.0, least_tension = 0.0;  ///< Along the line [N].
  std::optional<double> utilisation;                  ///< Largest tension over its segment's breaking load [-].
  double residual = 0.0;                              ///< Largest unbalanced force over the weight in air [-].
  int iterations = 0;
  LineEndResult first, second;
  std::vector<LineNodeResult> nodes;
};

}  // namespace overbend
