#include "study/campaign/study_units.h"

#include <set>

#include "study/campaign/study_folder.h"
#include "study/operability/operability_study.h"

namespace overbend {
namespace {

StudyUnits chains(const CaseBase& base, const std::filesystem::path& folder) {
  const OperabilityPlan plan(base.study());
  const OperabilityResults results = run_operability(base, {.folder = folder, .threads = 1, .gather = true});
  std::set<std::size_t> open;
  for (std::size_t i = 0; i < results.cells.size(); ++i) {
    if (!results.cells[i].decided) open.insert(chain_of_cell(plan.grid(), i));
  }
  return {operability_chains(plan.grid()), {open.begin(), open.end()}, {}};
}

}  // namespace

StudyUnits study_units(const CaseBase& base, const std::filesystem::path& folder) {
  if (base.study().operability) return chains(base, folder);
  StudyUnits units;
  units.count = StudyCases(base.study()).count();
  for (std::size_t i = 0; i < units.count; ++i) {
    const StudyCaseState state = recorded_state(folder, i);
    if (state == StudyCaseState::open) units.open.push_back(i);
    if (state == StudyCaseState::failed) units.failed.push_back(i);
  }
  return units;
}

}  // namespace overbend
