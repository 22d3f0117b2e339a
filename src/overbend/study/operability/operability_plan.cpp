#include "study/operability/operability_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "base/ranges.h"
#include "base/require.h"
#include "base/units.h"

namespace overbend {
namespace {

constexpr int kDigits = 9;  ///< Number of digits of a value in the model.

/// Returns the crossed input that this one varies with; usually itself.
const StudyInput& find_lead(const std::vector<StudyInput>& inputs, const StudyInput& input) {
  const StudyInput* lead = &input;
  while (!lead->with.empty()) {
    const auto next_lead = ranges::find(inputs, lead->with, &StudyInput::key);
    require(next_lead != inputs.end(), "an axis varies with an existing axis");
    lead = &*next_lead;
  }
  return *lead;
}

}  // namespace

std::vector<double> searched_values(double from, double to, double step) {
  constexpr double kSlack = 1e-6;  // of a step: bounds and step come from decimal text
  std::vector<double> values;
  for (int i = 0; from + i * step < to - kSlack * step; ++i) values.push_back(from + i * step);
  values.push_back(to);
  return values;
}

OperabilityPlan::OperabilityPlan(const StudyDescription& study) : seeds_(study.seeds) {
  const OperabilityDescription& wanted = *study.operability;
  const std::vector<StudyInput> inputs = StudyCases(study).inputs();
  for (const StudyInput& input : inputs) {
    const StudyInput& lead = find_lead(inputs, input);
    if (lead.key == wanted.over) {
      require(input.key == wanted.over, "no axis varies with the searched key");
      over_ = input;
    } else if (&lead == &input) {
      axes_.push_back(input);
      auto& group = together_.emplace_back();
      for (const StudyInput& member : inputs) {
        if (&find_lead(inputs, member) == &lead) group.push_back(member);
      }
    }
  }
  require(!over_.values.empty(), "the searched axis is numeric");
  const auto [min, max] = ranges::minmax(over_.values);
  values_ = searched_values(min, max, wanted.resolution);
  for (const StudyInput& axis : axes_) grid_.axes.push_back(axis.value_texts.size());
  grid_.values = values_.size();
  grid_.seeds = std::max<std::size_t>(1, seeds_.size());
}

std::size_t OperabilityPlan::cells() const {
  return std::accumulate(grid_.axes.begin(), grid_.axes.end(), std::size_t{1}, std::multiplies<>());
}

std::vector<std::size_t> OperabilityPlan::at(std::size_t cell) const {
  std::vector<std::size_t> indices(axes_.size());
  for (std::size_t i = axes_.size(); i-- > 0;) {
    indices[i] = cell % grid_.axes[i];
    cell /= grid_.axes[i];
  }
  return indices;
}

std::string OperabilityPlan::value_text(std::size_t value) const {
  if (over_.show.empty()) return format_number(values_.at(value), kDigits);
  return format_quantity(values_.at(value), over_.unit, over_.show, kDigits);
}

CaseInput OperabilityPlan::question(std::size_t cell, std::size_t value, std::size_t seed) const {
  CaseInput question;
  const std::vector<std::size_t> place = at(cell);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    for (const StudyInput& input : together_[i]) question.keys.push_back({input.key, input.value_texts.at(place[i])});
  }
  question.keys.push_back({over_.key, value_text(value)});
  if (!seeds_.empty()) question.seed = seeds_.at(seed);
  return question;
}

std::string OperabilityPlan::folder(std::size_t cell, std::size_t value, std::size_t seed) const {
  const std::string name = fmt::format("trials/{:04}/{:03}", cell, value);
  return seeds_.empty() ? name : name + fmt::format("-seed-{}", seeds_.at(seed));
}

}  // namespace overbend
