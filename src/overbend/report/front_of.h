/// What every first page begins with.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/front_page.h"

namespace overbend {

/// The inputs are shown as the program reads them; nothing where it can no longer read the text.
std::optional<Description> description_of(const std::string& model_text);

/// Kind, title, document control and warnings by weight.
FrontPage front_of(const std::string& kind, const std::string& title, const std::optional<Description>& description,
                   const std::vector<std::string>& remarks);

/// The working load of the mooring lines, where the model gives one [N].
std::optional<double> working_load_of(const std::optional<Description>& description);

}  // namespace overbend
