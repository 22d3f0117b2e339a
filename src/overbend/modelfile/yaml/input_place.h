/// Position of a key in a model file.
#pragma once

#include <string>

namespace overbend {

/// Returns "model.yaml:37: operation.loads"; for a missing key the line of its deepest existing group. `text` is the
/// file's content; if it is empty or unreadable, only the key.
std::string input_place(const std::string& file, const std::string& text, const std::string& key);

}  // namespace overbend
