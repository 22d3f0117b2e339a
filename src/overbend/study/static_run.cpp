#include "study/static_run.h"

#include "checks/run_checks.h"
#include "report/report.h"
#include "resultfiles/results_writer.h"
#include "runstore/staged_folder.h"
#include "statics/recovery.h"

namespace overbend {

StaticResults checked_statics(const Model& model, const StaticSolution& solution) {
  StaticResults results = recover_statics(model, solution);
  fill_checks(model, results);
  return results;
}

void write_static_run(const StaticResults& results, const Description& description,
                      const std::filesystem::path& folder) {
  StagedFolder staged(folder);
  write_static_files(results, description, staged.path());
  write_report(results, description.source_text, staged.path() / "report.html");
  staged.commit("summary.json");
}

}  // namespace overbend
