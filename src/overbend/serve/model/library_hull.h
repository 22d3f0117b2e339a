/// RAOs from the library for a vessel whose motion response is unknown.
#pragma once

#include <filesystem>
#include <vector>

#include "serve/http/http.h"

namespace overbend {

/// Adds POST /api/hull: RAOs of the box barge included in the program, scaled to the vessel's length and beam, as a
/// file in the folder that the program was started in.
void add_hull_routes(std::vector<HttpRoute>& routes, const std::filesystem::path& folder);

}  // namespace overbend
