#include "report/studies/study_shape.h"
#include "base/ranges.h"
#include "results/verdict_order.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace overbend {
namespace {

/// A group while its cases are added: `mean` holds sums.
struct GroupAccumulator {
  StudyGroup group;
  std::vector<int> counts;  ///< Number of values of every output.
};

void add_values(GroupAccumulator& growing, const StudyCase& study_case) {
  StudyGroup& group = growing.group;
  for (std::size_t i = 0; i < group.mean.size() && i < study_case.values.size(); ++i) {
    if (!study_case.values[i]) continue;
    const double value = *study_case.values[i];
    group.mean[i] = group.mean[i].value_or(0.0) + value;  // their sum so far
    ++growing.counts[i];
    group.low[i] = std::min(group.low[i].value_or(value), value);
    group.high[i] = std::max(group.high[i].value_or(value), value);
  }
}

void add_case(GroupAccumulator& growing, const StudyCase& study_case) {
  StudyGroup& group = growing.group;
  if (study_case.state == StudyCaseState::open) ++group.open;
  if (study_case.state == StudyCaseState::failed) ++group.failed;
  if (study_case.state != StudyCaseState::done) return;
  ++group.done;
  group.verdict = std::max(group.verdict, study_case.verdict, less_severe);
  if (study_case.utilisation && (!group.utilisation || *study_case.utilisation > *group.utilisation)) {
    group.utilisation = study_case.utilisation;
    group.governing = study_case.governing;
  }
  add_values(growing, study_case);
}

int differing(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b,
              const std::vector<std::size_t>& axes) {
  return static_cast<int>(
      ranges::count_if(axes, [&](std::size_t axis) { return axis < a.size() && a[axis] != b[axis]; }));
}

std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  ranges::sort(order, [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
  std::vector<double> out(values.size());
  for (std::size_t from = 0; from < order.size();) {
    std::size_t to = from;
    while (to < order.size() && values[order[to]] == values[order[from]]) ++to;
    for (std::size_t i = from; i < to; ++i) out[order[i]] = 0.5 * static_cast<double>(from + to - 1);
    from = to;
  }
  return out;
}

}  // namespace

std::vector<StudyGroup> study_groups(const StudyResults& results) {
  std::map<std::size_t, GroupAccumulator> by_number;
  for (const StudyCase& study_case : results.cases) {
    GroupAccumulator& growing = by_number[study_case.group];
    StudyGroup& group = growing.group;
    if (group.first == nullptr) {
      group.group = study_case.group;
      group.first = &study_case;
      group.verdict = VerdictKind::passed;
      group.mean.resize(results.outputs.size());
      group.low = group.high = group.mean;
      growing.counts.resize(results.outputs.size());
    }
    add_case(growing, study_case);
  }
  std::vector<StudyGroup> groups;
  for (auto& [number, growing] : by_number) {
    StudyGroup& group = growing.group;
    if (group.done == 0 || group.failed > 0 || group.open > 0) group.verdict = VerdictKind::not_judged;
    for (std::size_t i = 0; i < group.mean.size(); ++i) {
      if (group.mean[i]) *group.mean[i] /= growing.counts[i];
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

std::vector<std::size_t> free_axes(const StudyResults& results) {
  std::vector<std::size_t> axes;
  for (std::size_t i = 0; i < results.inputs.size(); ++i) {
    const StudyInput& input = results.inputs[i];
    if (!input.sampled && input.with.empty() && input.value_texts.size() > 1) axes.push_back(i);
  }
  return axes;
}

std::optional<std::size_t> base_group(const StudyResults& results, const std::vector<StudyGroup>& groups) {
  const std::vector<std::size_t> axes = free_axes(results);
  if (axes.size() < 2) return std::nullopt;
  std::size_t all = 1;
  for (const std::size_t axis : axes) all *= results.inputs[axis].value_texts.size();
  if (groups.size() < 3 || groups.size() >= all) return std::nullopt;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const bool base = ranges::all_of(groups, [&](const StudyGroup& group) {
      return differing(groups[i].first->value_indices, group.first->value_indices, axes) <= 1;
    });
    if (base) return i;
  }
  return std::nullopt;
}

StudyShape study_shape(const StudyResults& results) {
  const bool sampled = ranges::any_of(results.inputs, [](const StudyInput& input) { return input.sampled; });
  if (sampled) return StudyShape::sample;
  const std::size_t axes = free_axes(results).size();
  if (axes == 0) return StudyShape::single;
  if (axes == 1) return StudyShape::curves;
  return base_group(results, study_groups(results)) ? StudyShape::one_at_a_time : StudyShape::maps;
}

std::optional<double> rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size() || a.size() < 3) return std::nullopt;
  const std::vector<double> ra = ranks(a), rb = ranks(b);
  const double mean = 0.5 * static_cast<double>(a.size() - 1);
  double aa = 0.0, bb = 0.0, ab = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    aa += (ra[i] - mean) * (ra[i] - mean);
    bb += (rb[i] - mean) * (rb[i] - mean);
    ab += (ra[i] - mean) * (rb[i] - mean);
  }
  if (!(aa > 0.0) || !(bb > 0.0)) return std::nullopt;
  return ab / std::sqrt(aa * bb);
}

}  // namespace overbend
