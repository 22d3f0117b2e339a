/// A case: changes of a model and the seed of its sea.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/machines/controller.h"
#include "model/description/description.h"
#include "modelfile/yaml/yaml_edit.h"

namespace overbend {

/// One case of a study: everything that distinguishes it from the other cases of the same model.
struct Case {
  std::string name;                          ///< Name of its folder within the study's folder; empty: the study's
                                             ///< folder itself.
  std::string label{};                       ///< Label for people.
  std::vector<YamlChange> changes{};         ///< Changes of keys of the model file, applied in order.
  std::optional<double> duration{};          ///< Simulated time that replaces the model's [s]; not written into the
                                             ///< model text.
  std::optional<std::uint64_t> seed{};       ///< Seed of the sea; if empty, the first seed of the model.
  std::vector<ControllerUse> controllers{};  ///< Controllers of this run only: they keep state.
};

/// Throws std::invalid_argument if a seed is outside the range of model files.
void require_seeds(const std::vector<std::uint64_t>& seeds);

/// Replaces the simulated time of the model [s], also in a model without analysis.dynamic; does nothing without a
/// duration. Throws std::invalid_argument if the duration is outside the permitted range.
void set_duration(Description& description, const std::optional<double>& duration);

/// Returns the model with the keys of the case set in its text, and with its duration. Throws std::runtime_error if a
/// key cannot be set or the changed text is not a valid model.
Description describe(const Description& base, const Case& study_case);

/// True if two cases differ in nothing but their seeds.
bool same_model(const Case& a, const Case& b);

}  // namespace overbend
