/// Start dialogue: choices, and the model made from its answers.
#pragma once

#include <string>

#include "serve/http/http.h"

namespace overbend {

/// Returns pipes, grades, vessels and defaults; sizes in m and Pa.
Json new_dialogue();

/// Returns the text of a model made from answers as typed ("16", "89 m"). HttpError 422 names the invalid answer.
std::string new_text(const Json& answers);

}  // namespace overbend
