/// Where a key stands in the file of a model.
#pragma once

#include <string>

namespace overbend {

/// "model.yaml:37: operation.loads"; of a key that is not there the line of the deepest group that is. `text` is what
/// the file holds; without one, or where it cannot be read, the key alone.
std::string input_place(const std::string& file, const std::string& text, const std::string& key);

}  // namespace overbend
