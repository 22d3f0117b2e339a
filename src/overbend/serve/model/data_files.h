/// Data that models refer to: response amplitude operators, motion histories, spectra.
#pragma once

#include <filesystem>
#include <vector>

#include "serve/http/http.h"

namespace overbend {

/// GET and POST /api/data of the folder that the program was started in.
void add_data_routes(std::vector<HttpRoute>& routes, const std::filesystem::path& folder);

}  // namespace overbend
