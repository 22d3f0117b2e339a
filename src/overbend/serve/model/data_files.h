/// Data files of models: response amplitude operators, motion histories, spectra.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "serve/http/http.h"

namespace overbend {

/// Writes a data file. `name` must be a plain file name. HttpError 422 if the name is invalid or the folder cannot be
/// written, 409 if the folder contains a different file of this name.
void write_data_file(const std::filesystem::path& folder, const std::string& name, const std::string& text);

/// Adds GET and POST /api/data for the folder that the program was started in.
void add_data_routes(std::vector<HttpRoute>& routes, const std::filesystem::path& folder);

}  // namespace overbend
