/// Reads results.h5 back.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "model/description/lay_operation_description.h"
#include "results/sensitivity_results.h"
#include "results/static_results.h"

namespace overbend {

/// Static results with their model file.
struct StoredStatics {
  StaticResults results;
  std::string model_text;
  std::string model_file;                    ///< Path as given by the user.
  std::optional<LayStageDescription> stage;  ///< Stage of an operation on the line, if the results are of one.
  std::optional<SensitivityResults> sensitivities;
};

/// Returns the data of write_static_results, bit for bit. Throws std::runtime_error that names the missing dataset if
/// the file has another layout.
StoredStatics read_static_results(const std::filesystem::path& h5);

}  // namespace overbend
