#include "io/dynamic_writer.h"

#include "io/check_tables.h"
#include "io/finite_check.h"
#include "io/results_writer.h"

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
