/// Whether a fitted distribution describes the tail of its sample. docs/theory/statistics.md has the formulas.
#pragma once

#include <span>

namespace overbend {

/// Anderson and Darling's distance with the weight on the upper tail [ahmad1988], of a sample in ascending order from
/// its distribution: `shares` are the values of the distribution function.
double upper_tail_distance(std::span<const double> shares);

/// The smallest of the chances that as many of the sample are as large as its largest, its second largest ... tenth
/// largest. `expected`, ascending: how many values of a sample of this size the distribution has above the largest, the
/// second largest and so on. A chance of a hundredth is an outlier: of another population than the rest.
double least_chance(std::span<const double> expected);

}  // namespace overbend
