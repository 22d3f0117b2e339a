/// Static results of stand-alone lines. SI; frame W.
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

/// A line end. Forces are those on the line from its attachment.
struct LineEndResult {
  Vec3 force = Vec3::Zero();  ///< [N]
  double tension = 0.0;       ///< Magnitude of the force [N].
  double declination = 0.0;   ///< Angle of the line below horizontal, positive if the line is suspended from this end
                              ///< [rad].
};

struct LineResult {
  std::string name;
  double length = 0.0;  ///< Unstressed [m].
  int elements = 0;
  double weight = 0.0;                          ///< Submerged weight of segments and point masses [N].
  double on_bed = 0.0;                          ///< Length in contact with the seabed [m].
  double max_tension = 0.0, min_tension = 0.0;  ///< Along the line [N].
  std::optional<double> utilisation;            ///< Maximum of tension over breaking load of the segment [-].
  double residual = 0.0;                        ///< Maximum unbalanced force over the weight in air [-].
  int iterations = 0;
  LineEndResult first, second;
  std::vector<LineNodeResult> nodes;
};

}  // namespace overbend
