#include "study/operability/operability_folder.h"

#include <stdexcept>

#include "modelfile/study_file/study_reader.h"
#include "resultfiles/studies/operability_json.h"
#include "runstore/replace_file.h"

namespace overbend {

namespace fs = std::filesystem;

constexpr const char* kFile = "operability.json";

void write_operability(const OperabilityResults& results, const fs::path& folder) {
  replace_file(folder / kFile, json_text(operability_json(results), 1) + "\n");
}

std::optional<OperabilityResults> read_operability(const fs::path& folder) {
  const std::optional<Json> json = read_json_object(folder / kFile);
  if (!json) return std::nullopt;
  try {
    return operability_from_json(*json);
  } catch (const Json::exception&) {  // damaged: recreated from the records
    return std::nullopt;
  }
}

void refresh_operability(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder / "trials", error)) return;
  const std::optional<Json> study = read_json_object(folder / "study.json");
  if (!study || !study->contains("study")) return;
  StudyReading reading = read_study_file(study->at("study").get<std::string>());
  if (!reading.study) {
    const std::vector<std::string> errors = reading.diagnostics.lines(Severity::error);
    throw std::runtime_error(errors.empty() ? "the study file cannot be read" : errors.front());
  }
  if (!reading.study->operability) return;
  const CaseBase base(std::move(*reading.base), std::move(*reading.study));
  write_operability(run_operability(base, {.folder = folder, .threads = 1, .gather = true}), folder);
}

}  // namespace overbend
