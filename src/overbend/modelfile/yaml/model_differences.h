/// In what model files differ, key by key.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace overbend {

/// A key that not all have alike.
struct DifferingKey {
  std::string key;                  ///< "stinger.boxes[stinger 7].height": items of a list by their name, else index.
  std::vector<std::string> values;  ///< Of every model as it stands there; empty where it is not given.
};

/// Compares YAML texts of models. Quantities that are equal within 1e-9 are alike whatever their units: 1 m and
/// 1000 mm. A text that is no YAML counts as empty. Keys in the order in which they first come.
std::vector<DifferingKey> differing_keys(std::span<const std::string> texts);

/// Whether two values of a key say the same.
bool same_quantity(const std::string& a, const std::string& b);

}  // namespace overbend
