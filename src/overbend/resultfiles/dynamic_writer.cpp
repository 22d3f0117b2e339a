#include "resultfiles/dynamic_writer.h"

#include "resultfiles/check_tables.h"
#include "resultfiles/finite_check.h"
#include "resultfiles/results_writer.h"
#include "runstore/append_file.h"

namespace overbend {

void write_dynamic_files(const StaticResults& statics, const DynamicResults& dynamics, const RunStore& store,
                         const Description& description, const std::filesystem::path& folder) {
  require_finite(statics);
  require_finite(dynamics);
  write_dynamic_hdf5(statics, dynamics, store, description, folder / "results.h5");
  write_text(folder / "pipe.csv", dynamic_pipe_table(statics, dynamics));
  write_text(folder / "supports.csv", dynamic_supports_table(statics, dynamics));
  write_text(folder / "impacts.csv", impacts_table(dynamics));
  write_text(folder / "checks.csv", checks_table(dynamics.checks));
  write_text(folder / "summary.json", dynamic_summary(statics, dynamics));
}

}  // namespace overbend
