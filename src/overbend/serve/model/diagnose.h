/// A model text read, with its faults as the page shows them.
#pragma once

#include "modelfile/reading/yaml_reader.h"
#include "serve/http/http.h"

namespace overbend {

/// `[{severity, line, column, key, message}]`, lines and columns from 1. `text` is the text read, from which the
/// columns follow. The first 200, and how many there are besides.
Json diagnostics_json(const Diagnostics& diagnostics, const std::string& text);

/// The same of a model's text that was read; parses nothing again.
Json diagnostics_json(const ModelReading& reading, const std::string& text);

}  // namespace overbend
