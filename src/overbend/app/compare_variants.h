/// The variants of a model that are compared.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/description.h"
#include "results/comparison_results.h"

namespace overbend {

struct Variant {
  std::string name;         ///< And of its folder.
  std::string words;        ///< For people.
  std::string path, value;  ///< The key of the model file that makes it.
};

const std::vector<Variant>& variants_of(ComparisonOf of);

/// Why the model cannot be compared so; nothing when it can.
std::optional<std::string> comparison_obstacle(ComparisonOf of, const Description& description);

/// The model with the variant's key set in its text. Throws std::runtime_error where it cannot be set.
Description vary(const Description& description, const Variant& variant);

}  // namespace overbend
