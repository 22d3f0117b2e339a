/// The page of a study: summary, charts and cases.
#pragma once

#include <filesystem>

#include "report/page/page.h"
#include "results/study_results.h"

namespace overbend {

/// Returns the whole page.
Document study_document(const StudyResults& results);

/// Writes the page to a temporary file and renames it. Throws std::runtime_error on failure.
void write_study_report(const StudyResults& results, const std::filesystem::path& file);

}  // namespace overbend
