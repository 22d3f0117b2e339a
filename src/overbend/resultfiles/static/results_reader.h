/// Reads results.h5 back.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "model/description/lay_operation.h"
#include "results/sensitivity_results.h"
#include "results/static_results.h"

namespace overbend {

/// Static results with the model file they came from.
struct StoredStatics {
  StaticResults results;
  std::string model_text;
  std::string model_file;                    ///< Its path as it was given.
  std::optional<LayStageDescription> stage;  ///< Of an operation on the line, where the results are of one.
  std::optional<SensitivityResults> sensitivities;
};

/// Gives back what write_static_results wrote, bit for bit. Throws std::runtime_error that says what is missing where
/// the file is none of ours.
StoredStatics read_static_results(const std::filesystem::path& h5);

}  // namespace overbend
