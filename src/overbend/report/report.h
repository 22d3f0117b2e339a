/// The report of a static or dynamic analysis: one file that opens offline in any browser and prints on A4 and Letter.
///
///     results ---> document (sections, tables, data of figures) ---> page (web/src/report, embedded) that draws it
///
/// No external resources are loaded.
#pragma once

#include <filesystem>
#include <string>

#include "report/page/page.h"
#include "results/dynamic_results.h"
#include "results/seek_results.h"
#include "results/sensitivity_results.h"

namespace overbend {

/// Optional additions to a static analysis; null for none.
struct StaticExtras {
  const SensitivityResults* sensitivities = nullptr;
  const SeekResults* seek = nullptr;  ///< For static results that a goal seek ended at.
};

/// Returns the report as data. `model_text` is the model file as the user wrote it; it is printed, and its inputs are
/// listed. `extras` have their own sections.
Document report_document(const StaticResults& results, const std::string& model_text, const StaticExtras& extras = {});

/// Returns the report of a dynamic run: its own results first, then the static state that it starts from.
Document report_document(const StaticResults& statics, const DynamicResults& results, const std::string& model_text);

/// Writes the report to a temporary file and renames it to `file`. Throws std::runtime_error on failure.
void write_report(const StaticResults& results, const std::string& model_text, const std::filesystem::path& file,
                  const StaticExtras& extras = {});
void write_report(const StaticResults& statics, const DynamicResults& results, const std::string& model_text,
                  const std::filesystem::path& file);

}  // namespace overbend
