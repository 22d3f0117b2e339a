/// Goodness of fit of a distribution in the tail of its sample. docs/theory/statistics.md has the formulas.
#pragma once

#include <span>

namespace overbend {

/// Returns the Anderson-Darling distance with the weight on the upper tail [ahmad1988] of a sample in ascending order
/// from its distribution: `shares` are the values of the distribution function.
double upper_tail_distance(std::span<const double> shares);

/// Returns the minimum of the probabilities that as many values of a sample are as large as its largest, second largest
/// ... tenth largest. `expected`, ascending: number of values of a sample of this size that the distribution has above
/// the largest, the second largest and so on. A probability of a hundredth indicates an outlier: a value of another
/// population than the rest.
double min_probability(std::span<const double> expected);

}  // namespace overbend
