/// The support that stands out of the line of the others: mostly a slip in one number.
#pragma once

#include <optional>
#include <string>

#include "model/model.h"

namespace overbend {

struct SupportOutlier {
  std::string name;        ///< "the box 'stinger 2'", "the tensioner".
  double height = 0.0;     ///< Above the line through its neighbours, of the first and last through the next two [m].
  double curvature = 0.0;  ///< Of the circle through the three [1/m].
  double of_yield = 0.0;   ///< Curvature over that at which the pipe yields.
};

/// The tensioner or box without which the line of the others is smoothest, where it bends the pipe beyond what any lay
/// has: far past yield over a height beyond what is set out by eye.
std::optional<SupportOutlier> support_outlier(const Model& model);

/// "the box 'stinger 2' is 4.56 m below the line through its neighbours: a curvature of 0.0744 1/m, 6.0 times that at
/// which the pipe yields; check its z and the sign of its offset"
std::string outlier_words(const SupportOutlier& outlier);

}  // namespace overbend
