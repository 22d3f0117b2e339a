/// POST /api/sensitivities: what the key results hang on.
#pragma once

#include <vector>

#include "serve/http/http.h"
#include "serve/model/open_model.h"

namespace overbend {

/// The answer: of each key result the inputs whose tolerance moves it most.
Json sensitivities_of(const ModelText& model, const std::vector<YamlChange>& changes);

/// Adds the route; `model` must outlive it.
void add_sensitivity_routes(std::vector<HttpRoute>& routes, OpenModel& model);

}  // namespace overbend
