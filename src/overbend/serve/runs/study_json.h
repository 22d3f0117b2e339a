/// Results of the cases of a study, for the page.
#pragma once

#include <filesystem>

#include "serve/http/http.h"
#include "serve/runs/run_info.h"

namespace overbend {

/// Returns `{kind, cases, quantities, findings}` of a study with results in `folder`. Values are in SI; `unit` and
/// `factor` give the unit shown. HttpError 404 if there are no results.
Json study_json(const RunInfo& study, const std::filesystem::path& folder);

/// Files of a study: summary for scripts, table, and page (empty: none).
struct StudyFiles {
  const char *summary, *table, *page;
};
StudyFiles study_files(const RunInfo& study);

}  // namespace overbend
