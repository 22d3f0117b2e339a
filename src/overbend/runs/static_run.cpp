#include "runs/static_run.h"

#include "io/results_writer.h"
#include "io/staged_folder.h"
#include "report/report.h"

namespace overbend {

void write_static_run(const StaticResults& results, const Description& description,
                      const std::filesystem::path& folder) {
  StagedFolder staged(folder);
  write_static_files(results, description, staged.path());
  write_report(results, description.source_text, staged.path() / "report.html");
  staged.commit("summary.json");
}

}  // namespace overbend
