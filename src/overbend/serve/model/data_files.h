/// Data that models refer to: response amplitude operators, motion histories, spectra.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "serve/http/http.h"

namespace overbend {

/// Writes a data file under a plain name. HttpFault 422 where the name or the folder does not allow that, 409 where the
/// folder has another file of this name.
void write_data_file(const std::filesystem::path& folder, const std::string& name, const std::string& text);

/// GET and POST /api/data of the folder that the program was started in.
void add_data_routes(std::vector<HttpRoute>& routes, const std::filesystem::path& folder);

}  // namespace overbend
