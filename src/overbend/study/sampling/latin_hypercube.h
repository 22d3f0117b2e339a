/// Draws of a study: Latin hypercube of given distributions.
#pragma once

#include <vector>

#include "model/description/study_description.h"

namespace overbend {

/// Value below which the key lies with probability `p` in 0 to 1 exclusive [SI]; its bounds cut the distribution off
/// and what is left is scaled to 1.
double quantile(const SampledKey& key, double p);

/// `count` draws, each with a value for every key [SI]. Of every key one value lies in each of `count` equally probable
/// ranges; which go together is a random permutation of each key by itself (McKay, Beckman and Conover 1979). The same
/// seed gives the same draws on every machine.
std::vector<std::vector<double>> latin_hypercube(const StudySample& sample);

}  // namespace overbend
