#include "study/campaign/study_extremes.h"

#include <algorithm>
#include <map>

#include "base/ranges.h"
#include "study/run/non_stationary.h"
#include "study/run/seeds_gather.h"

namespace overbend {
namespace {

/// True if `word` is one of the parts of a name, separated by points, brackets and underscores.
bool has_word(const std::string& name, const std::string& word) {
  const auto parts = [](char c) { return std::string("._()[]/ ").find(c) != std::string::npos; };
  for (std::size_t found = name.find(word); found != std::string::npos; found = name.find(word, found + 1)) {
    const std::size_t end = found + word.size();
    if ((found == 0 || parts(name[found - 1])) && (end == name.size() || parts(name[end]))) return true;
  }
  return false;
}

bool has_non_stationary_case(const std::vector<const StudyCase*>& group) {
  return ranges::any_of(group, [](const StudyCase* study_case) {
    return has_code(study_case->findings, FindingCode::record_not_stationary);
  });
}

StudyExtreme make_extreme(const std::vector<const StudyCase*>& group, std::size_t output, bool is_maximum,
                          double duration) {
  StudyExtreme extreme;
  extreme.group = group.front()->group;
  extreme.output = output;
  extreme.is_maximum = is_maximum;
  std::vector<double> values;
  for (const StudyCase* study_case : group) values.push_back(*study_case->values[output]);
  extreme.runs = static_cast<int>(values.size());
  const SeedStatistics s = seed_statistics(values, is_maximum ? SeedExtreme::maximum : SeedExtreme::minimum, duration);
  extreme.mean = s.mean;
  extreme.std = s.std;
  extreme.worst = is_maximum ? s.max : s.min;
  extreme.enough = s.enough && !has_non_stationary_case(group);
  extreme.gumbel = {s.estimate, s.low, s.high};
  return extreme;
}

/// Peaks of every case of a group; empty if one has none.
std::vector<std::vector<HistoryPeaks>> group_peaks(const std::vector<const StudyCase*>& group,
                                                   const PeaksOfCase& peaks) {
  std::vector<std::vector<HistoryPeaks>> all;
  if (!peaks || has_non_stationary_case(group)) return all;
  for (const StudyCase* study_case : group) {
    all.push_back(peaks(*study_case));
    if (all.back().empty()) return {};
  }
  return all;
}

void add_group(StudyResults& results, const std::vector<const StudyCase*>& group, double duration,
               const PeaksOfCase& peaks) {
  const std::vector<std::vector<HistoryPeaks>> seen = group_peaks(group, peaks);
  for (std::size_t i = 0; i < results.outputs.size(); ++i) {
    const std::optional<bool> is_maximum = is_maximum_output(results.outputs[i].name);
    if (!is_maximum || results.outputs[i].text) continue;
    const bool everywhere =
        ranges::all_of(group, [&](const StudyCase* study_case) { return study_case->values[i].has_value(); });
    if (!everywhere) continue;
    StudyExtreme extreme = make_extreme(group, i, *is_maximum, duration);
    if (!seen.empty()) {
      if (const auto fit = fit_result_acer(seen, results.outputs[i].name)) {
        extreme.acer = StudyEstimate{fit->estimate.value, fit->estimate.low, fit->estimate.high};
      }
    }
    results.extremes.push_back(extreme);
  }
}

}  // namespace

std::optional<bool> is_maximum_output(const std::string& output) {
  const auto any = [&](std::initializer_list<const char*> candidates) {
    return ranges::any_of(candidates, [&](const char* word) { return has_word(output, word); });
  };
  if (any({"min", "smallest", "least"})) return false;
  if (any({"max", "largest", "utilisation"})) return true;
  if (output == "dynamic.top_tension") return true;  // stands for its maximum
  return std::nullopt;
}

void fill_extremes(StudyResults& results, double duration, const PeaksOfCase& peaks) {
  results.extremes.clear();
  std::map<std::size_t, std::vector<const StudyCase*>> groups;
  for (const StudyCase& study_case : results.cases) {
    if (study_case.state == StudyCaseState::done && study_case.seed) groups[study_case.group].push_back(&study_case);
  }
  for (const auto& [number, group] : groups) {
    if (group.size() >= 2) add_group(results, group, duration, peaks);
  }
}

}  // namespace overbend
