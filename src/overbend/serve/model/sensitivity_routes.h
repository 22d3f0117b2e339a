/// Requests for sensitivities of the key results.
#pragma once

#include <vector>

#include "serve/http/http.h"
#include "serve/model/open_model.h"

namespace overbend {

/// Returns the answer to POST /api/sensitivities: for each key result, the inputs whose tolerance has the largest
/// effect.
Json sensitivities_answer(const ModelText& model, const std::vector<YamlChange>& changes);

/// Adds the route; `model` must outlive it.
void add_sensitivity_routes(std::vector<HttpRoute>& routes, OpenModel& model);

}  // namespace overbend
