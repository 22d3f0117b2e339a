/// Import of files of other programs into the open folder.
#pragma once

#include <filesystem>
#include <vector>

#include "serve/http/http.h"

namespace overbend {

/// Adds POST /api/import: `{"files": [{"name", "text"}, ...]}`, the first of which is translated and may include the
/// others. All are put into the folder, where the model finds their RAOs. The answer has `text`, the model, and
/// `account`.
void add_import_routes(std::vector<HttpRoute>& routes, const std::filesystem::path& folder);

}  // namespace overbend
