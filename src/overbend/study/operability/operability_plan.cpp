#include "study/operability/operability_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "base/require.h"
#include "base/units.h"

namespace overbend {
namespace {

constexpr int kDigits = 9;  ///< Of a value as the model has it.

/// The input that is crossed and takes this one along, itself mostly.
const StudyInput& leader(const std::vector<StudyInput>& inputs, const StudyInput& input) {
  const StudyInput* lead = &input;
  while (!lead->with.empty()) {
    const auto other = std::ranges::find(inputs, lead->with, &StudyInput::key);
    require(other != inputs.end(), "an axis changes together with one that there is");
    lead = &*other;
  }
  return *lead;
}

}  // namespace

std::vector<double> searched_values(double least, double largest, double step) {
  constexpr double kSlack = 1e-6;  // of a step: bounds and step come from decimal text
  std::vector<double> values;
  for (int i = 0; least + i * step < largest - kSlack * step; ++i) values.push_back(least + i * step);
  values.push_back(largest);
  return values;
}

OperabilityPlan::OperabilityPlan(const StudyDescription& study) : seeds_(study.seeds) {
  const OperabilityDescription& wanted = *study.operability;
  const std::vector<StudyInput> inputs = StudyCases(study).inputs();
  for (const StudyInput& input : inputs) {
    const StudyInput& lead = leader(inputs, input);
    if (lead.key == wanted.over) {
      require(input.key == wanted.over, "nothing changes together with the key that is searched");
      over_ = input;
    } else if (&lead == &input) {
      axes_.push_back(input);
      auto& group = together_.emplace_back();
      for (const StudyInput& other : inputs) {
        if (&leader(inputs, other) == &lead) group.push_back(other);
      }
    }
  }
  require(!over_.values.empty(), "the axis that is searched has numbers");
  const auto [least, largest] = std::ranges::minmax(over_.values);
  values_ = searched_values(least, largest, wanted.resolution);
  for (const StudyInput& axis : axes_) grid_.axes.push_back(axis.words.size());
  grid_.values = values_.size();
  grid_.seeds = std::max<std::size_t>(1, seeds_.size());
}

std::size_t OperabilityPlan::cells() const {
  return std::accumulate(grid_.axes.begin(), grid_.axes.end(), std::size_t{1}, std::multiplies<>());
}

std::vector<std::size_t> OperabilityPlan::at(std::size_t cell) const {
  std::vector<std::size_t> at(axes_.size());
  for (std::size_t i = axes_.size(); i-- > 0;) {
    at[i] = cell % grid_.axes[i];
    cell /= grid_.axes[i];
  }
  return at;
}

std::string OperabilityPlan::value_words(std::size_t value) const {
  if (over_.show.empty()) return format_number(values_.at(value), kDigits);
  return format_quantity(values_.at(value), over_.unit, over_.show, kDigits);
}

CaseQuestion OperabilityPlan::question(std::size_t cell, std::size_t value, std::size_t seed) const {
  CaseQuestion question;
  const std::vector<std::size_t> place = at(cell);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    for (const StudyInput& input : together_[i]) question.keys.push_back({input.key, input.words.at(place[i])});
  }
  question.keys.push_back({over_.key, value_words(value)});
  if (!seeds_.empty()) question.seed = seeds_.at(seed);
  return question;
}

std::string OperabilityPlan::folder(std::size_t cell, std::size_t value, std::size_t seed) const {
  const std::string name = fmt::format("trials/{:04}/{:03}", cell, value);
  return seeds_.empty() ? name : name + fmt::format("-seed-{}", seeds_.at(seed));
}

}  // namespace overbend
