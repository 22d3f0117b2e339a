/// The keys of a model as a form shows them.
#pragma once

#include <string>

#include "serve/http.h"

namespace overbend {

/// Every key that the model has or could have next, from the table of fields; see `fields` in docs/api.md. Empty for a
/// text that is no YAML.
Json model_fields(const std::string& text);

}  // namespace overbend
