/// The page of a study: what its cases say, its charts and its cases.
#pragma once

#include <filesystem>

#include "report/page/page.h"
#include "results/study_results.h"

namespace overbend {

/// The whole page.
Document study_document(const StudyResults& results);

/// Writes it, beside its place first and then renamed. Throws std::runtime_error where that fails.
void write_study_report(const StudyResults& results, const std::filesystem::path& file);

}  // namespace overbend
