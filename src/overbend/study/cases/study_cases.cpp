#include "study/cases/study_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/ranges.h"
#include "base/require.h"
#include "base/units.h"
#include "modelfile/fields/seek_values.h"
#include "modelfile/schema/scalar_row.h"
#include "study/sampling/latin_hypercube.h"

namespace overbend {
namespace {

constexpr int kDrawnDigits = 9;  ///< Number of digits of a drawn value in the model.

StudyInput make_input(const StudyAxis& axis) {
  StudyInput input{axis.key, {}, {}, axis.with, false, axis.values, {}};
  const Field* row = scalar_row(axis.key);
  require(row != nullptr, "an axis has a key of the table");
  const bool numeric =
      row->kind == FieldKind::quantity || row->kind == FieldKind::number || row->kind == FieldKind::integer;
  if (!numeric) return input;
  input.unit = row_unit(*row);
  input.show = row->kind == FieldKind::quantity ? row->show : "";
  for (const std::string& text : axis.values) {
    const ScalarReading reading = read_row_value(text, *row);
    require(reading.value.has_value(), "values of an axis were checked");
    input.values.push_back(row->kind == FieldKind::integer ? static_cast<double>(reading.value->integer)
                                                           : reading.value->number);
  }
  return input;
}

StudyInput make_input(const SampledKey& key) {
  return {key.key, key.unit, key.show, {}, true, {}, {}};
}

std::size_t find_lead(const std::vector<StudyAxis>& axes, std::size_t axis) {
  while (!axes[axis].with.empty()) {
    const auto lead = ranges::find(axes, axes[axis].with, &StudyAxis::key);
    require(lead != axes.end(), "an axis varies with an existing axis");
    axis = static_cast<std::size_t>(lead - axes.begin());
  }
  return axis;
}

}  // namespace

StudyCases::StudyCases(const StudyDescription& study) : seeds_(study.seeds) {
  for (std::size_t i = 0; i < study.axes.size(); ++i) {
    inputs_.push_back(make_input(study.axes[i]));
    leads_.push_back(find_lead(study.axes, i));
    if (leads_.back() == i) count_ *= study.axes[i].values.size();
  }
  if (study.sample) {
    for (const SampledKey& key : study.sample->keys) inputs_.push_back(make_input(key));
    for (const std::vector<double>& draw : latin_hypercube(*study.sample)) {
      std::vector<std::string>& labels = drawn_texts_.emplace_back();
      std::vector<double>& numbers = drawn_.emplace_back();
      for (std::size_t k = 0; k < draw.size(); ++k) {
        const SampledKey& key = study.sample->keys[k];
        labels.push_back(key.show.empty() ? format_number(draw[k], kDrawnDigits)
                                          : format_quantity(draw[k], key.unit, key.show, kDrawnDigits));
        // As the model reads the text; a draw that the key rejects fails its case and is listed as drawn.
        const ScalarReading reading = read_row_value(labels.back(), *scalar_row(key.key));
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
    if (leads_[i] == i) values = inputs_[i].value_texts.size();
  }
  const std::size_t group = number / seeds(), index = group % values, block = index / kBlock;
  std::vector<std::size_t> list;
  const auto add = [&](std::size_t neighbour) {
    list.push_back((group - index + std::min(neighbour * kBlock + kBlock / 2, values - 1)) * seeds());
  };
  add(block);
  if (block > 0) add(block - 1);
  if ((block + 1) * kBlock < values) add(block + 1);
  return list;
}

std::vector<std::size_t> StudyCases::indices(std::size_t group) const {
  std::vector<std::size_t> index(leads_.size() + 1, 0);
  if (!drawn_.empty()) {
    index.back() = group % drawn_.size();
    group /= drawn_.size();
  }
  for (std::size_t i = leads_.size(); i-- > 0;) {
    if (leads_[i] != i) continue;
    index[i] = group % inputs_[i].value_texts.size();
    group /= inputs_[i].value_texts.size();
  }
  for (std::size_t i = 0; i < leads_.size(); ++i) index[i] = index[leads_[i]];
  return index;
}

StudyCase StudyCases::at(std::size_t number) const {
  StudyCase study_case;
  study_case.number = number;
  study_case.group = number / seeds();
  study_case.folder = case_folder(number);
  std::vector<std::size_t> index = indices(study_case.group);
  for (std::size_t i = 0; i < leads_.size(); ++i) {
    study_case.value_texts.push_back(inputs_[i].value_texts[index[i]]);
    study_case.inputs.push_back(inputs_[i].values.empty() ? std::numeric_limits<double>::quiet_NaN()
                                                          : inputs_[i].values[index[i]]);
  }
  for (std::size_t k = leads_.size(); k < inputs_.size(); ++k) {
    study_case.value_texts.push_back(drawn_texts_[index.back()][k - leads_.size()]);
    study_case.inputs.push_back(drawn_[index.back()][k - leads_.size()]);
  }
  index.pop_back();
  study_case.value_indices = std::move(index);
  if (!seeds_.empty()) study_case.seed = seeds_[number % seeds_.size()];
  return study_case;
}

CaseInput StudyCases::question(std::size_t number) const {
  StudyCase study_case = at(number);
  CaseInput question;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    question.keys.push_back({inputs_[i].key, std::move(study_case.value_texts[i])});
  }
  question.seed = study_case.seed;
  return question;
}

std::string case_folder(std::size_t number) {
  constexpr std::size_t kInFolder = 1000;
  return fmt::format("cases/{:04}/{:09}", number / kInFolder, number);
}

}  // namespace overbend
