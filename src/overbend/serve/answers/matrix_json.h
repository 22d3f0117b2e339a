/// What a study of many cases has given so far, as the page shows it.
#pragma once

#include "results/study_results.h"
#include "serve/http/http.h"

namespace overbend {

/// `{title, analysis, inputs, outputs, cases, operability, warnings}`: numbers in the units shown, null where there is
/// none. Texts among the outputs are left out: the governing check stands with each case.
Json matrix_json(const StudyResults& results);

}  // namespace overbend
