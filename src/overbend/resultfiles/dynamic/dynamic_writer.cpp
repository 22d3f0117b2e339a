#include "resultfiles/dynamic/dynamic_writer.h"

#include "resultfiles/dynamic/fatigue_files.h"
#include "resultfiles/lines/lines_files.h"
#include "resultfiles/static/finite_check.h"
#include "resultfiles/static/rechecked_hdf5.h"
#include "resultfiles/static/results_writer.h"
#include "runstore/append_file.h"

namespace overbend {

namespace {

void write_pipe_tables(const StaticResults& statics, const DynamicResults& dynamics,
                       const std::filesystem::path& folder) {
  write_text(folder / "pipe.csv", dynamic_pipe_table(statics, dynamics));
  write_text(folder / "supports.csv", dynamic_supports_table(statics, dynamics));
  write_text(folder / "impacts.csv", impacts_table(dynamics));
  if (dynamics.fatigue) write_text(folder / "fatigue.csv", fatigue_table(dynamics));
}

void write_tables(const StaticResults& statics, const DynamicResults& dynamics, const std::filesystem::path& folder) {
  if (statics.has_pipe()) write_pipe_tables(statics, dynamics, folder);
  if (statics.has_pipe() || !dynamics.checks.rows.empty()) write_check_tables(dynamics.checks, folder);
  write_mooring_tables(statics, dynamics.moorings, folder);
  if (!statics.lines.empty()) write_text(folder / "lines.csv", lines_table(statics.lines, dynamics.lines));
  write_text(folder / "summary.json", dynamic_summary(statics, dynamics));
}

}  // namespace

void write_dynamic_files(const StaticResults& statics, const DynamicResults& dynamics, const RunStore& store,
                         const Description& description, const std::filesystem::path& folder) {
  require_finite(statics);
  require_finite(dynamics);
  write_dynamic_hdf5(statics, dynamics, store, description, folder / "results.h5");
  write_tables(statics, dynamics, folder);
}

void write_rechecked_files(const StaticResults& statics, const DynamicResults& dynamics,
                           const std::filesystem::path& from, const Description& description,
                           const std::filesystem::path& folder) {
  require_finite(statics);
  require_finite(dynamics);
  copy_rechecked(from, folder / "results.h5", statics, dynamics, description);
  write_tables(statics, dynamics, folder);
}

}  // namespace overbend
