/// The keys of a model as a form shows them.
#pragma once

#include "base/yaml_document.h"
#include "serve/http/http.h"

namespace overbend {

/// Every key that the model has or could have next, from the table of fields; see `fields` in docs/api.md. Of long
/// lists the first 200 items. Empty without a tree, of a text that is no YAML.
Json model_fields(const YamlNode* root);

}  // namespace overbend
