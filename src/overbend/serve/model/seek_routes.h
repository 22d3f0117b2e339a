/// Goal seek for the page.
#pragma once

#include <vector>

#include "serve/http/http.h"
#include "serve/model/open_model.h"

namespace overbend {

/// The answer of POST /api/seek: what `wanted`, written as the key `seek` of a model, finds in the model as it is open.
Json seek_answer(const ModelText& model, const Json& wanted);

/// Adds the route; the model must outlive it.
void add_seek_routes(std::vector<HttpRoute>& routes, OpenModel& model);

}  // namespace overbend
