/// Requests about runs.
#pragma once

#include "serve/model/open_model.h"
#include "serve/runs/run_queue.h"

namespace overbend {

/// Adds the routes; `model` and `runs` must outlive them.
void add_run_routes(std::vector<HttpRoute>& routes, OpenModel& model, RunQueue& runs);

}  // namespace overbend
