/// Requests about the open model: text, keys, files, examples, start dialogue.
#pragma once

#include "serve/model/open_model.h"

namespace overbend {

/// Adds the routes; `model` must outlive them.
void add_model_routes(std::vector<HttpRoute>& routes, OpenModel& model);

}  // namespace overbend
