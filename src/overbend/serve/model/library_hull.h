/// A hull of the library for a vessel whose own motion response is not known.
#pragma once

#include <filesystem>
#include <vector>

#include "serve/http/http.h"

namespace overbend {

/// POST /api/hull: RAOs of the box barge that comes with the program, scaled to the vessel's length and beam, as a file
/// in the folder that the program was started in.
void add_hull_routes(std::vector<HttpRoute>& routes, const std::filesystem::path& folder);

}  // namespace overbend
