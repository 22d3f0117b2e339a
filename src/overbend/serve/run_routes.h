/// Requests about runs.
#pragma once

#include "serve/open_model.h"
#include "serve/run_queue.h"

namespace overbend {

/// Adds the routes; what they are given must outlive them.
void add_run_routes(std::vector<HttpRoute>& routes, OpenModel& model, RunQueue& runs);

}  // namespace overbend
