#include "study/cases/study_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/require.h"
#include "base/units.h"
#include "modelfile/fields/seek_values.h"
#include "modelfile/schema/scalar_row.h"
#include "study/sampling/latin_hypercube.h"

namespace overbend {
namespace {

constexpr int kDrawnDigits = 9;  ///< Of a drawn value as the model has it.

StudyInput input_of(const StudyAxis& axis) {
  StudyInput input{axis.key, {}, {}, axis.with, false, axis.values, {}};
  const Field* row = scalar_row(axis.key);
  require(row != nullptr, "an axis has a key of the table");
  const bool numeric =
      row->kind == FieldKind::quantity || row->kind == FieldKind::number || row->kind == FieldKind::integer;
  if (!numeric) return input;
  input.unit = unit_of(*row);
  input.show = row->kind == FieldKind::quantity ? row->show : "";
  for (const std::string& text : axis.values) {
    const ScalarReading reading = read_value_of(text, *row);
    require(reading.value.has_value(), "values of an axis were checked");
    input.values.push_back(row->kind == FieldKind::integer ? static_cast<double>(reading.value->integer)
                                                           : reading.value->number);
  }
  return input;
}

StudyInput input_of(const SampledKey& key) {
  return {key.key, key.unit, key.show, {}, true, {}, {}};
}

std::size_t leader(const std::vector<StudyAxis>& axes, std::size_t axis) {
  while (!axes[axis].with.empty()) {
    const auto other = std::ranges::find(axes, axes[axis].with, &StudyAxis::key);
    require(other != axes.end(), "an axis changes together with one that there is");
    axis = static_cast<std::size_t>(other - axes.begin());
  }
  return axis;
}

}  // namespace

StudyCases::StudyCases(const StudyDescription& study) : seeds_(study.seeds) {
  for (std::size_t i = 0; i < study.axes.size(); ++i) {
    inputs_.push_back(input_of(study.axes[i]));
    leads_.push_back(leader(study.axes, i));
    if (leads_.back() == i) count_ *= study.axes[i].values.size();
  }
  if (study.sample) {
    for (const SampledKey& key : study.sample->keys) inputs_.push_back(input_of(key));
    for (const std::vector<double>& draw : latin_hypercube(*study.sample)) {
      std::vector<std::string>& words = drawn_words_.emplace_back();
      std::vector<double>& numbers = drawn_.emplace_back();
      for (std::size_t k = 0; k < draw.size(); ++k) {
        const SampledKey& key = study.sample->keys[k];
        words.push_back(key.show.empty() ? format_number(draw[k], kDrawnDigits)
                                         : format_quantity(draw[k], key.unit, key.show, kDrawnDigits));
        // As the model reads its words; a draw that the key refuses fails its case and stands as it was drawn.
        const ScalarReading reading = read_value_of(words.back(), *scalar_row(key.key));
        numbers.push_back(reading.value ? reading.value->number : draw[k]);
      }
    }
    count_ *= drawn_.size();
  }
  count_ *= seeds();
}

std::vector<std::size_t> StudyCases::anchors(std::size_t number) const {
  constexpr std::size_t kBlock = 8;
  if (!drawn_.empty() || leads_.empty()) return {};
  std::size_t values = 1;
  for (std::size_t i = leads_.size(); i-- > 0 && values == 1;) {
    if (leads_[i] == i) values = inputs_[i].words.size();
  }
  const std::size_t group = number / seeds(), at = group % values, block = at / kBlock;
  std::vector<std::size_t> list;
  const auto add = [&](std::size_t of) {
    list.push_back((group - at + std::min(of * kBlock + kBlock / 2, values - 1)) * seeds());
  };
  add(block);
  if (block > 0) add(block - 1);
  if ((block + 1) * kBlock < values) add(block + 1);
  return list;
}

std::vector<std::size_t> StudyCases::indices(std::size_t group) const {
  std::vector<std::size_t> at(leads_.size() + 1, 0);
  if (!drawn_.empty()) {
    at.back() = group % drawn_.size();
    group /= drawn_.size();
  }
  for (std::size_t i = leads_.size(); i-- > 0;) {
    if (leads_[i] != i) continue;
    at[i] = group % inputs_[i].words.size();
    group /= inputs_[i].words.size();
  }
  for (std::size_t i = 0; i < leads_.size(); ++i) at[i] = at[leads_[i]];
  return at;
}

StudyCase StudyCases::at(std::size_t number) const {
  StudyCase one;
  one.number = number;
  one.group = number / seeds();
  one.folder = case_folder(number);
  std::vector<std::size_t> at = indices(one.group);
  for (std::size_t i = 0; i < leads_.size(); ++i) {
    one.words.push_back(inputs_[i].words[at[i]]);
    one.inputs.push_back(inputs_[i].values.empty() ? std::numeric_limits<double>::quiet_NaN()
                                                   : inputs_[i].values[at[i]]);
  }
  for (std::size_t k = leads_.size(); k < inputs_.size(); ++k) {
    one.words.push_back(drawn_words_[at.back()][k - leads_.size()]);
    one.inputs.push_back(drawn_[at.back()][k - leads_.size()]);
  }
  at.pop_back();
  one.at = std::move(at);
  if (!seeds_.empty()) one.seed = seeds_[number % seeds_.size()];
  return one;
}

CaseQuestion StudyCases::question(std::size_t number) const {
  StudyCase one = at(number);
  CaseQuestion question;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    question.keys.push_back({inputs_[i].key, std::move(one.words[i])});
  }
  question.seed = one.seed;
  return question;
}

std::string case_folder(std::size_t number) {
  constexpr std::size_t kInFolder = 1000;
  return fmt::format("cases/{:04}/{:09}", number / kInFolder, number);
}

}  // namespace overbend
