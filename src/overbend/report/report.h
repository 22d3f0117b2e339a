/// The report of a static or dynamic analysis: one file that opens offline in any browser and prints on A4 and Letter.
///
///     results ---> document (sections, tables, figures' data) ---> page (web/src/report, embedded) that draws it
///
/// Nothing is fetched from anywhere.
#pragma once

#include <filesystem>
#include <string>

#include "report/page/page.h"
#include "results/dynamic_results.h"
#include "results/seek_results.h"
#include "results/sensitivity_results.h"

namespace overbend {

/// What may come with a static analysis; null for none.
struct StaticExtras {
  const SensitivityResults* sensitivities = nullptr;
  const SeekResults* seek = nullptr;  ///< Of statics that a goal seek ended at.
};

/// The report as data. `model_text` is the model file as the user wrote it; it is printed, and its inputs are listed.
/// `extras` get sections of their own.
Document report_document(const StaticResults& results, const std::string& model_text, const StaticExtras& extras = {});

/// Of a dynamic run: its own results first, then the static state that it starts from.
Document report_document(const StaticResults& statics, const DynamicResults& results, const std::string& model_text);

/// Writes the report to a temporary file and renames it to `file`. Throws std::runtime_error where that fails.
void write_report(const StaticResults& results, const std::string& model_text, const std::filesystem::path& file,
                  const StaticExtras& extras = {});
void write_report(const StaticResults& statics, const DynamicResults& results, const std::string& model_text,
                  const std::filesystem::path& file);

}  // namespace overbend
