#include "study/goal_seek/seek_model.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/ranges.h"
#include "base/require.h"
#include "base/result_path.h"
#include "base/threads.h"
#include "base/units.h"
#include "model/description/seek_operations.h"
#include "modelfile/fields/seek_values.h"
#include "modelfile/reading/yaml_reader.h"
#include "modelfile/yaml/chosen_keys.h"
#include "modelfile/yaml/yaml_path.h"
#include "study/run/prepared_case.h"

namespace overbend {
namespace {

/// Present value of a key: from the model text, or its default.
std::optional<double> present_value(const Description& model, const YamlNode& tree, const std::string& path,
                                    const Field& row) {
  std::string rest;
  const std::vector<YamlSpot> spots = follow_path(tree, path, rest);
  const std::string text = rest.empty() ? spots.back().node->text : row.fallback;
  if (text.empty()) return kept_length(model, path);
  const ScalarReading reading = read_row_value(text, row);
  return reading.value ? std::optional(reading.value->number) : std::nullopt;
}

SeekUnknown make_unknown(const Description& model, const SeekVariable& variable, const ChosenKey& key,
                         const YamlNode& tree) {
  const Field* row = varied_row(variable.key);
  require(row != nullptr, "a checked seek varies keys of the table");
  const std::optional<double> present = present_value(model, tree, key.path, *row);
  SeekUnknown unknown{.path = key.path, .name = key.name, .unit = variable.unit, .show = variable.show};
  if (variable.within) {
    if (!present) throw SeekError(key.name + " has no value in the model, which `within` needs; give from and to");
    unknown.from = std::max(*present - *variable.within, row->range.low);
    unknown.to = std::min(*present + *variable.within, row->range.high);
  } else {
    unknown.from = variable.from.value_or(0.0);
    unknown.to = variable.to.value_or(1.0);
  }
  unknown.before = present.value_or(0.5 * (unknown.from + unknown.to));
  return unknown;
}

YamlNode parsed(const Description& description) {
  Diagnostics diagnostics;
  std::optional<YamlNode> tree = parse_yaml(description.source_text, description.source_file, diagnostics);
  if (!tree || diagnostics.has_errors()) throw SeekError("the text of the model cannot be parsed again");
  return std::move(*tree);
}

/// Squared distance, with the keys in parts of their bounds.
double distance(const std::vector<SeekUnknown>& unknowns, const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const double part = (a[i] - b[i]) / (unknowns[i].to - unknowns[i].from);
    sum += part * part;
  }
  return sum;
}

}  // namespace

SeekModel::SeekModel(const Description& description, const SeekDescription& seek, std::function<bool()> stop)
    : base_(description), tree_(parsed(description)), stop_(std::move(stop)) {
  for (const SeekVariable& variable : seek.vary) {
    for (const ChosenKey& key : chosen_keys(tree_, split_result_path(variable.key).value())) {
      unknowns_.push_back(make_unknown(base_, variable, key, tree_));
    }
  }
  if (unknowns_.empty()) throw SeekError("the keys to vary match no item of the model");
  if (!is_seek_over_stages(base_.operation.type)) {
    base_.operation = {};  // used neither by statics nor by the search
    return;
  }
  try {
    stages_.emplace(base_, seek, unknowns_);
  } catch (const std::invalid_argument& error) {
    throw SeekError(error.what());
  }
}

std::vector<YamlChange> SeekModel::changes(const std::vector<double>& values, int digits) const {
  std::vector<YamlChange> list;
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    const SeekUnknown& unknown = unknowns_[i];
    const std::string text = unknown.show.empty() ? format_number(values[i], digits)
                                                  : format_quantity(values[i], unknown.unit, unknown.show, digits);
    list.push_back({unknown.path, YamlChange::Kind::scalar, text});
  }
  return list;
}

/// Edits the parsed tree if possible; edits and reads the text if a key is missing or the files of the hull may no
/// longer fit.
Description SeekModel::described(const std::vector<double>& values) const {
  const std::vector<YamlChange> list = changes(values, 17);
  const bool files =
      base_.vessel.coupled && ranges::any_of(list, [](const YamlChange& c) { return c.path.starts_with("vessel"); });
  YamlNode tree = tree_;
  ModelReading reading = !files && edit_tree(tree, list)
                             ? read_statics_inputs(tree, base_.source_file)
                             : read_model_text(edit_yaml(base_.source_text, list), base_.source_file);
  if (!reading.description) {
    const std::vector<std::string> errors = reading.diagnostics.lines(Severity::error);
    throw std::runtime_error(errors.empty() ? "the model cannot be read" : errors.front());
  }
  if (!files && reading.description->vessel.coupled) reading.description->vessel.coupled = base_.vessel.coupled;
  if (!stages_) reading.description->operation = {};
  return std::move(*reading.description);
}

SeekPoint SeekModel::solve(const std::vector<double>& values, const StaticSolution* start) const {
  SeekPoint point{.values = values, .summary = {}, .solution = {}, .failure = {}};
  try {
    if (stages_) {
      point.summary = stages_->solve(described(values));
      return point;
    }
    Model model = build_model(described(values));
    StaticRun found = run_statics(model, start);
    if (found.failure && start != nullptr) found = run_statics(model);  // the start may have been too far away
    if (found.failure) {
      point.failure = failure_line(*found.failure);
    } else {
      point.summary = static_summary_json(*found.results);
      point.solution = std::move(found.solution);
    }
  } catch (const std::runtime_error& error) {
    point.failure = error.what();
  }
  return point;
}

const SeekPoint* SeekHistory::nearest(const std::vector<double>& values) const {
  const SeekPoint* best = nullptr;
  double min_distance = std::numeric_limits<double>::infinity();
  for (const SeekPoint& point : points_) {
    const double far = distance(model_.unknowns(), point.values, values);
    if (point.solution && point.serves && far < min_distance) {
      best = &point;
      min_distance = far;
    }
  }
  return best;
}

const SeekPoint& SeekHistory::at(const std::vector<double>& values) {
  for (const SeekPoint& point : points_) {
    if (point.values == values) return point;
  }
  model_.throw_if_cancelled();
  const SeekPoint* start = nearest(values);
  SeekPoint& point = points_.emplace_back(model_.solve(values, start != nullptr ? &*start->solution : nullptr));
  point.serves = serve_;
  return point;
}

std::vector<const SeekPoint*> SeekHistory::at_all(const std::vector<std::vector<double>>& values,
                                                  const std::vector<double>& around) {
  model_.throw_if_cancelled();
  const SeekPoint* start = nearest(around);
  const StaticSolution* from = start != nullptr ? &*start->solution : nullptr;
  std::vector<const SeekPoint*> all;
  std::vector<SeekPoint*> open;
  for (const std::vector<double>& point_values : values) {
    open.push_back(
        &points_.emplace_back(SeekPoint{.values = point_values, .summary = {}, .solution = {}, .failure = {}}));
    all.push_back(open.back());
  }
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < open.size(); i = next++) {
      *open[i] = model_.solve(open[i]->values, from);
      open[i]->probe = true;
      open[i]->serves = false;
    }
  };
  work_in_threads(useful_threads(0, open.size()), work);
  return all;
}

}  // namespace overbend
