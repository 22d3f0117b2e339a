#include "study/static_run.h"

#include <algorithm>
#include <iterator>

#include "checks/run_checks.h"
#include "report/report.h"
#include "resultfiles/results_writer.h"
#include "runstore/staged_folder.h"
#include "statics/recovery.h"
#include "statics/side_rollers.h"

namespace overbend {
namespace {

void add_missing(const std::vector<std::string>& sentences, std::vector<std::string>& list) {
  std::copy_if(sentences.begin(), sentences.end(), std::back_inserter(list), [&](const std::string& sentence) {
    return std::find(list.begin(), list.end(), sentence) == list.end();
  });
}

}  // namespace

StaticResults checked_statics(const Model& model, const LayOutcome& lay) {
  StaticResults results = recover_statics(model, *lay.solution);
  if (lay.moorings) {
    add_missing(lay.moorings->warnings, results.warnings);
    add_missing(lay.moorings->assumptions, results.assumptions);
    if (std::optional<std::string> warning = warn_of_side_rollers(model.description, results)) {
      results.warnings.push_back(std::move(*warning));
    }
    results.moorings = lay.moorings;
  }
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
