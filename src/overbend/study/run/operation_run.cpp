#include "study/run/operation_run.h"

#include "report/stages/operation_report.h"
#include "resultfiles/stages/operation_writer.h"
#include "runstore/staged_folder.h"

namespace overbend {

void write_operation_run(const OperationResults& results, const Description& description,
                         const std::filesystem::path& folder) {
  StagedFolder staged(folder);
  write_operation_files(results, description, staged.path());
  write_operation_report(results, description.source_text, staged.path() / "report.html");
  staged.commit("summary.json");
}

}  // namespace overbend
