/// Requests for a goal seek.
#pragma once

#include <vector>

#include "serve/http/http.h"
#include "serve/model/open_model.h"

namespace overbend {

/// Returns the answer to POST /api/seek: goal seek of the open model. `wanted` has the form of the model key `seek`.
Json seek_answer(const ModelText& model, const Json& wanted);

/// Adds the route; the model must outlive it.
void add_seek_routes(std::vector<HttpRoute>& routes, OpenModel& model);

}  // namespace overbend
