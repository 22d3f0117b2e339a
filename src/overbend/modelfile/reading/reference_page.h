/// The reference page of the model file, made from the field table.
#pragma once

#include <string>

namespace overbend {

/// Markdown of docs/input.md.
std::string reference_page();

}  // namespace overbend
