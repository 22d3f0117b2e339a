/// Support that is out of line with the others, mostly by a typing error in one number.
#pragma once

#include <optional>
#include <string>

#include "model/model.h"

namespace overbend {

struct SupportOutlier {
  std::string name;          ///< "the box 'stinger 2'", "the tensioner".
  double height = 0.0;       ///< Height above the line through its neighbours; for the first and last point through the
                             ///< next two [m].
  double curvature = 0.0;    ///< Curvature of the circle through the three points [1/m].
  double yield_ratio = 0.0;  ///< Curvature relative to that at which the pipe yields.
};

/// Finds the tensioner or box without which the line of the others is smoothest, if it bends the pipe beyond that of
/// any lay: far past yield over a height beyond alignment tolerances.
std::optional<SupportOutlier> support_outlier(const Model& model);

/// "the box 'stinger 2' is 4.56 m below the line through its neighbours: a curvature of 0.0744 1/m, 6.0 times that at
/// which the pipe yields; check its z and the sign of its offset"
std::string outlier_message(const SupportOutlier& outlier);

}  // namespace overbend
