#include "study/campaign/study_extremes.h"

#include <algorithm>
#include <map>

#include "study/run/non_stationary.h"
#include "study/run/seeds_gather.h"

namespace overbend {
namespace {

/// Whether `word` is in a name as one of its parts, between points, brackets and underscores.
bool has_word(const std::string& name, const std::string& word) {
  const auto parts = [](char c) { return std::string("._()[]/ ").find(c) != std::string::npos; };
  for (std::size_t at = name.find(word); at != std::string::npos; at = name.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || parts(name[at - 1])) && (end == name.size() || parts(name[end]))) return true;
  }
  return false;
}

bool changed(const std::vector<const StudyCase*>& group) {
  return std::ranges::any_of(
      group, [](const StudyCase* one) { return has_code(one->findings, FindingCode::record_not_stationary); });
}

StudyExtreme extreme_of(const std::vector<const StudyCase*>& group, std::size_t output, bool largest, double duration) {
  StudyExtreme extreme;
  extreme.group = group.front()->group;
  extreme.output = output;
  extreme.largest = largest;
  std::vector<double> values;
  for (const StudyCase* one : group) values.push_back(*one->values[output]);
  extreme.runs = static_cast<int>(values.size());
  const SeedStatistics s = seed_statistics(values, largest ? SeedExtreme::largest : SeedExtreme::smallest, duration);
  extreme.mean = s.mean;
  extreme.std = s.std;
  extreme.worst = largest ? s.max : s.min;
  extreme.enough = s.enough && !changed(group);
  extreme.gumbel = {s.estimate, s.low, s.high};
  return extreme;
}

/// Peaks of every case of a group; nothing where one has none.
std::vector<std::vector<HistoryPeaks>> group_peaks(const std::vector<const StudyCase*>& group,
                                                   const PeaksOfCase& peaks) {
  std::vector<std::vector<HistoryPeaks>> all;
  if (!peaks || changed(group)) return all;
  for (const StudyCase* one : group) {
    all.push_back(peaks(*one));
    if (all.back().empty()) return {};
  }
  return all;
}

void add_group(StudyResults& results, const std::vector<const StudyCase*>& group, double duration,
               const PeaksOfCase& peaks) {
  const std::vector<std::vector<HistoryPeaks>> seen = group_peaks(group, peaks);
  for (std::size_t i = 0; i < results.outputs.size(); ++i) {
    const std::optional<bool> largest = looks_for_largest(results.outputs[i].name);
    if (!largest || results.outputs[i].text) continue;
    const bool everywhere =
        std::ranges::all_of(group, [&](const StudyCase* one) { return one->values[i].has_value(); });
    if (!everywhere) continue;
    StudyExtreme extreme = extreme_of(group, i, *largest, duration);
    if (!seen.empty()) {
      if (const auto fit = acer_of_result(seen, results.outputs[i].name)) {
        extreme.acer = StudyEstimate{fit->estimate.value, fit->estimate.low, fit->estimate.high};
      }
    }
    results.extremes.push_back(extreme);
  }
}

}  // namespace

std::optional<bool> looks_for_largest(const std::string& output) {
  const auto any = [&](std::initializer_list<const char*> words) {
    return std::ranges::any_of(words, [&](const char* word) { return has_word(output, word); });
  };
  if (any({"min", "smallest", "least"})) return false;
  if (any({"max", "largest", "utilisation"})) return true;
  if (output == "dynamic.top_tension") return true;  // stands for its largest value
  return std::nullopt;
}

void fill_extremes(StudyResults& results, double duration, const PeaksOfCase& peaks) {
  results.extremes.clear();
  std::map<std::size_t, std::vector<const StudyCase*>> groups;
  for (const StudyCase& one : results.cases) {
    if (one.state == StudyCaseState::done && one.seed) groups[one.group].push_back(&one);
  }
  for (const auto& [number, group] : groups) {
    if (group.size() >= 2) add_group(results, group, duration, peaks);
  }
}

}  // namespace overbend
