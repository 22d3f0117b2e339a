#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "app/commands.h"
#include "base/ranges.h"
#include "base/units.h"
#include "modelfile/reading/yaml_reader.h"
#include "runstore/written_files.h"

namespace overbend {

std::optional<Description> load_model(const std::string& path) {
  constexpr std::size_t kMaxShownErrors = 50;
  ModelReading reading = read_model(path);
  const std::vector<std::string> errors = reading.diagnostics.lines(Severity::error);
  for (std::size_t i = 0; i < errors.size() && i < kMaxShownErrors; ++i) std::cerr << errors[i] << "\n";
  const auto count = static_cast<std::size_t>(reading.diagnostics.error_count());
  if (count > kMaxShownErrors) std::cerr << "... and " << count - kMaxShownErrors << " more\n";
  return std::move(reading.description);
}

std::optional<RunResult> find_output_conflict(const std::string& model_file, const std::filesystem::path& folder,
                                              const std::vector<std::string>& results) {
  if (const auto foreign = find_user_file_conflict(folder, results)) {
    return RunResult{RunStatus::wrong_input, "the folder '" + folder.string() + "' cannot be written: " + *foreign};
  }
  const std::filesystem::path model(model_file);
  const std::vector<std::string> written = read_written(folder).files;
  std::error_code error;
  if (ranges::find(written, model.filename().string()) == written.end()) return std::nullopt;
  if (!std::filesystem::equivalent(model, folder / model.filename(), error)) return std::nullopt;
  return RunResult{RunStatus::wrong_input, "the model file '" + model_file + "' is among the results in '" +
                                               folder.string() +
                                               "', which would be replaced; copy it first, or choose another folder"};
}

std::optional<double> parse_duration_option(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const QuantityReading duration = parse_quantity(text, "s");
  if (duration.value && *duration.value >= kMinDuration && *duration.value <= kMaxDuration) return *duration.value;
  throw std::invalid_argument(fmt::format("--duration: found {}, expected a time from {} s to {:g} s such as '600 s'",
                                          duration.found, kMinDuration, kMaxDuration));
}

}  // namespace overbend
