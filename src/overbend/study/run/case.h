/// What is computed: a model, the keys changed in it and the seed of its sea.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/machines/controller.h"
#include "model/description/description.h"
#include "modelfile/yaml/yaml_edit.h"

namespace overbend {

/// One case of a study. Everything that distinguishes it from the other cases of the same model is in here.
struct Case {
  std::string name;                          ///< Of its folder within the study's; empty: it runs in that itself.
  std::string words{};                       ///< For people.
  std::vector<YamlChange> changes{};         ///< Of keys of the model file, one after the other.
  std::optional<double> duration{};          ///< Simulated time instead of the model's [s]; the text keeps its own.
  std::optional<std::uint64_t> seed{};       ///< Left out: the model's first.
  std::vector<ControllerUse> controllers{};  ///< Of its run alone: they remember.
};

/// Throws std::invalid_argument where a seed is beyond those that a model file can have.
void require_seeds(const std::vector<std::uint64_t>& seeds);

/// The simulated time in the place of the model's [s], of a model without analysis.dynamic as well; without one nothing
/// changes. Throws std::invalid_argument where it is no time that can be meant.
void set_duration(Description& description, const std::optional<double>& duration);

/// The model with the case's keys set in its text, and its duration. Throws std::runtime_error where a key cannot be
/// set or the model is none any more.
Description describe(const Description& base, const Case& one);

/// Whether two cases have one model and nothing else but their seeds apart.
bool same_model(const Case& a, const Case& b);

}  // namespace overbend
