/// What the cases of a study gave, as the page shows it.
#pragma once

#include <filesystem>

#include "serve/http/http.h"
#include "serve/runs/run_info.h"

namespace overbend {

/// `{kind, cases, quantities, warnings}` of a study that has results in `folder`. Values are SI; `unit` and `factor`
/// say in what they are shown. HttpFault 404 where there is nothing.
Json study_json(const RunInfo& study, const std::filesystem::path& folder);

/// Its files: what scripts read, the table, and the page that shows it (empty: there is none).
struct StudyFiles {
  const char *summary, *table, *page;
};
StudyFiles study_files(const RunInfo& study);

}  // namespace overbend
