/// What every first page begins with.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/finding.h"
#include "report/page/front_page.h"

namespace overbend {

/// The inputs are shown as the program reads them; nothing where it can no longer read the text.
std::optional<Description> description_of(const std::string& model_text);

/// Kind, title, document control and findings by severity.
FrontPage front_of(const std::string& kind, const std::string& title, const std::optional<Description>& description,
                   const Findings& findings);

}  // namespace overbend
