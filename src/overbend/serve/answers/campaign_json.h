/// Results so far of a study of many cases, for the page.
#pragma once

#include "results/study_results.h"
#include "serve/http/http.h"

namespace overbend {

/// Returns `{title, analysis, inputs, outputs, cases, operability, findings}`; numbers are in the units shown, null if
/// missing. Outputs that are texts are omitted; each case contains its governing check.
Json campaign_json(const StudyResults& results);

}  // namespace overbend
