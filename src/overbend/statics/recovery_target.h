/// What the file wants, tension or anchor, beside what was found.
#pragma once

#include "model/model.h"
#include "results/static_results.h"

namespace overbend {

/// Warns where the recovered forces and places miss what the file wants.
void warn_of_missed_target(StaticResults& results, const Model& model);

}  // namespace overbend
