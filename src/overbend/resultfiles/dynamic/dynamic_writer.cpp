#include "resultfiles/dynamic/dynamic_writer.h"

#include "resultfiles/dynamic/fatigue_files.h"
#include "resultfiles/moored/mooring_writer.h"
#include "resultfiles/moored/move_table.h"
#include "resultfiles/static/check_tables.h"
#include "resultfiles/static/finite_check.h"
#include "resultfiles/static/rechecked_hdf5.h"
#include "resultfiles/static/results_writer.h"
#include "runstore/append_file.h"

namespace overbend {

namespace {

/// Of a hull and its lines without a pipe.
void write_moored_tables(const MooringResults& statics, const DynamicResults& dynamics,
                         const std::filesystem::path& folder) {
  write_text(folder / "moorings.csv", moorings_table(statics, dynamics.moorings));
  if (!statics.steps.empty()) write_text(folder / "pull_ahead.csv", move_table(statics));
}

void write_pipe_tables(const StaticResults& statics, const DynamicResults& dynamics,
                       const std::filesystem::path& folder) {
  write_text(folder / "pipe.csv", dynamic_pipe_table(statics, dynamics));
  write_text(folder / "supports.csv", dynamic_supports_table(statics, dynamics));
  write_text(folder / "impacts.csv", impacts_table(dynamics));
  if (statics.moorings) write_text(folder / "moorings.csv", moorings_table(*statics.moorings, dynamics.moorings));
  if (dynamics.fatigue) write_text(folder / "fatigue.csv", fatigue_table(dynamics));
  write_text(folder / "checks.csv", checks_table(dynamics.checks));
  write_text(folder / "calculation_sheet.csv", calculation_sheet_table(dynamics.checks));
}

void write_tables(const StaticResults& statics, const DynamicResults& dynamics, const std::filesystem::path& folder) {
  if (statics.has_pipe()) {
    write_pipe_tables(statics, dynamics, folder);
  } else {
    write_moored_tables(*statics.moorings, dynamics, folder);
  }
  write_text(folder / "summary.json", dynamic_summary(statics, dynamics));
}

void require_results(const StaticResults& statics, const DynamicResults& dynamics) {
  if (statics.has_pipe()) {
    require_finite(statics);
  } else {
    require_finite(*statics.moorings);
  }
  require_finite(dynamics);
}

}  // namespace

void write_dynamic_files(const StaticResults& statics, const DynamicResults& dynamics, const RunStore& store,
                         const Description& description, const std::filesystem::path& folder) {
  require_results(statics, dynamics);
  write_dynamic_hdf5(statics, dynamics, store, description, folder / "results.h5");
  write_tables(statics, dynamics, folder);
}

void write_rechecked_files(const StaticResults& statics, const DynamicResults& dynamics,
                           const std::filesystem::path& from, const Description& description,
                           const std::filesystem::path& folder) {
  require_results(statics, dynamics);
  copy_rechecked(from, folder / "results.h5", statics, dynamics, description);
  write_tables(statics, dynamics, folder);
}

}  // namespace overbend
