/// Reference page of the model file, generated from the field table.
#pragma once

#include <string>

namespace overbend {

/// Returns the Markdown of docs/input.md.
std::string reference_page();

}  // namespace overbend
