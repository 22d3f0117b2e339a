/// The start dialogue: what it offers, and the model made from its answers.
#pragma once

#include <string>

#include "serve/http/http.h"

namespace overbend {

/// Pipes, grades, vessels and what is taken where nothing is said; sizes in m and Pa.
Json new_dialogue();

/// The text of a model from answers as typed ("16", "89 m"). HttpFault 422 names the answer that is wrong.
std::string new_text(const Json& answers);

}  // namespace overbend
