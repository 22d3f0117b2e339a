/// Common content of every first page.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/finding.h"
#include "report/page/front_page.h"

namespace overbend {

/// Reads the inputs of the model text; nothing if it can no longer be read.
std::optional<Description> read_description(const std::string& model_text);

/// Returns kind, title, document control and findings by severity.
FrontPage make_front_page(const std::string& kind, const std::string& title,
                          const std::optional<Description>& description, const Findings& findings);

}  // namespace overbend
