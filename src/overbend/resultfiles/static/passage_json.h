/// The key operation.passage of summary.json.
#pragma once

#include "resultfiles/summary/summary_json.h"
#include "results/passage_results.h"

namespace overbend {

/// Returns the maxima as {value, stage, passed}; SI.
Json passage_json(const PassageResults& passage);

}  // namespace overbend
