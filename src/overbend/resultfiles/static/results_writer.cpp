#include "resultfiles/static/results_writer.h"

#include <span>

#include "resultfiles/lines/lines_files.h"
#include "resultfiles/moored/mooring_tables.h"
#include "resultfiles/moored/move_table.h"
#include "resultfiles/static/check_tables.h"
#include "resultfiles/static/finite_check.h"
#include "resultfiles/static/sensitivity_files.h"
#include "resultfiles/static/span_table.h"
#include "resultfiles/summary/summary_json.h"
#include "runstore/append_file.h"
#include "runstore/staged_folder.h"

namespace overbend {

namespace {

void write_pipe_tables(const StaticResults& results, const std::filesystem::path& folder) {
  write_text(folder / "pipe.csv", pipe_table(results));
  write_text(folder / "supports.csv", supports_table(results));
  if (results.bed) write_text(folder / "spans.csv", span_table(*results.bed));
}

}  // namespace

void write_check_tables(const CheckTable& checks, const std::filesystem::path& folder) {
  write_text(folder / "checks.csv", checks_table(checks));
  write_text(folder / "calculation_sheet.csv", calculation_sheet_table(checks));
}

void write_mooring_tables(const StaticResults& results, const std::vector<MooringLineDynamics>& in_time,
                          const std::filesystem::path& folder) {
  if (!results.moorings) return;
  write_text(folder / "moorings.csv", moorings_table(*results.moorings, in_time));
  if (!results.moorings->steps.empty()) write_text(folder / "pull_ahead.csv", move_table(*results.moorings));
}

void write_static_files(const StaticResults& results, const Description& description,
                        const std::filesystem::path& folder, const SensitivityResults* sensitivities) {
  require_finite(results);
  write_static_hdf5(results, description, folder / "results.h5", sensitivities);
  if (results.has_pipe()) write_pipe_tables(results, folder);
  if (results.has_pipe() || !results.checks.rows.empty()) write_check_tables(results.checks, folder);
  write_mooring_tables(results, {}, folder);
  if (!results.lines.empty()) write_text(folder / "lines.csv", lines_table(results.lines));
  Json summary = static_summary_json(results);
  if (sensitivities != nullptr) {
    write_text(folder / "sensitivities.csv", sensitivities_table(*sensitivities));
    summary["sensitivities"] = sensitivities_json(*sensitivities);
  }
  write_text(folder / "summary.json", summary_text(summary));
}

void write_static_results(const StaticResults& results, const Description& description,
                          const std::filesystem::path& dir) {
  require_finite(results);
  StagedFolder staged(dir);
  write_static_files(results, description, staged.path());
  staged.commit("summary.json");
}

}  // namespace overbend
