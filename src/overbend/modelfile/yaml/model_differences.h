/// Differences between model files, key by key.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace overbend {

/// Key that differs between the models.
struct DifferingKey {
  std::string key;                  ///< "stinger.boxes[stinger 7].height": items of a list by name, else by index.
  std::vector<std::string> values;  ///< Value in each model as written; empty if it is not given.
};

/// Compares YAML texts of models. Quantities that are equal within 1e-9 are equal in any unit: 1 m and 1000 mm. Invalid
/// YAML counts as empty. Keys are in the order of their first appearance.
std::vector<DifferingKey> differing_keys(std::span<const std::string> texts);

/// Returns true if two values of a key are equal.
bool same_quantity(const std::string& a, const std::string& b);

}  // namespace overbend
