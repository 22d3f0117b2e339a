/// Diagnostics of a model text for the page.
#pragma once

#include "modelfile/reading/yaml_reader.h"
#include "serve/http/http.h"

namespace overbend {

/// Returns `[{severity, line, column, key, message}]` with lines and columns from 1. `text` is the text read, from
/// which columns are found. Contains the first 200 diagnostics and the number of further ones.
Json diagnostics_json(const Diagnostics& diagnostics, const std::string& text);

/// The same for a model text that was read, without parsing it again.
Json diagnostics_json(const ModelReading& reading, const std::string& text);

}  // namespace overbend
