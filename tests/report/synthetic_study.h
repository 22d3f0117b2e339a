/// Made-up results of studies of every shape, to look at their pages.
#pragma once

#include <string>

#include "results/study_results.h"

namespace overbend::testing {

/// "curves", "maps", "facets", "swings", "sample", "operability".
StudyResults synthetic_study(const std::string& shape);

}  // namespace overbend::testing
