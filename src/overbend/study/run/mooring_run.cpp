#include "study/run/mooring_run.h"

#include "report/report.h"
#include "resultfiles/moored/mooring_writer.h"
#include "runstore/staged_folder.h"

namespace overbend {

void write_mooring_run(const MooringResults& results, const Description& description,
                       const std::filesystem::path& folder) {
  StagedFolder staged(folder);
  write_mooring_files(results, description, staged.path());
  write_report(results, description.source_text, staged.path() / "report.html");
  staged.commit("summary.json");
}

}  // namespace overbend
