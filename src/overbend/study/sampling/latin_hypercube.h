/// Draws of a study: Latin hypercube of given distributions.
#pragma once

#include <vector>

#include "model/description/study_description.h"

namespace overbend {

/// Returns the value that the key does not exceed with probability `p`, 0 < p < 1 [SI]; its bounds truncate the
/// distribution, which is scaled to 1.
double quantile(const SampledKey& key, double p);

/// Returns `count` draws, each with a value for every key [SI]. For every key one value lies in each of `count` equally
/// probable intervals, combined by an independent random permutation per key (McKay, Beckman and Conover 1979). The
/// same seed gives the same draws on every machine.
std::vector<std::vector<double>> latin_hypercube(const StudySample& sample);

}  // namespace overbend
