/// Keys of a model for the form of the page.
#pragma once

#include "base/yaml_document.h"
#include "serve/http/http.h"

namespace overbend {

/// Returns every key that the model has or may have, from the table of fields; see `fields` in docs/api.md. Only the
/// first 200 items of long lists are included. Empty without a tree (text is not YAML).
Json model_fields(const YamlNode* root);

}  // namespace overbend
