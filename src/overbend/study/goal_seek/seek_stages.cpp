#include "study/goal_seek/seek_stages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

#include "base/ranges.h"
#include "base/result_path.h"
#include "model/lay_stage.h"
#include "modelfile/yaml/yaml_edit.h"
#include "modelfile/yaml/yaml_path.h"
#include "resultfiles/static/case_summary.h"
#include "resultfiles/summary/named_results.h"
#include "study/stages/lay_operation.h"

namespace overbend {
namespace {

constexpr std::string_view kStages = "operation.stages";

using Stages = std::vector<LayStageDescription>;

std::string stage_name(const Stages& stages, std::size_t index) {
  return stages[index].name.empty() ? "stage " + std::to_string(index + 1) : stages[index].name;
}

/// Stage that a key belongs to.
std::optional<std::size_t> stage_of_key(const std::string& path) {
  if (!path.starts_with(kStages)) return std::nullopt;
  const auto index = leading_index(path.substr(kStages.size()));
  return index ? std::optional(index->first) : std::nullopt;
}

/// Line whose length at a stage is the key.
std::optional<std::string> line_of_length(const std::string& path) {
  constexpr std::string_view kLengths = "].lengths.";
  const std::size_t found = path.find(kLengths);
  if (!stage_of_key(path) || found == std::string::npos) return std::nullopt;
  return path.substr(found + kLengths.size());
}

/// Last stage that a result belongs to.
std::size_t last_stage(const Stages& stages, const std::string& result) {
  const auto parts = split_result_path(parsed_result_name(result).path);
  std::size_t last = 0;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const bool every = !parts || parts->size() < 3 || parts->front().text != "operation";
    if (every || chooses_item((*parts)[2].text, i, stage_name(stages, i))) last = i;
  }
  return last;
}

/// Values of a line along its nodes, and the name of the result that is their maximum.
struct Along {
  std::string_view result, name;
  double (*value)(const LiftedNode&);
};

constexpr std::array kAlong = {
    Along{"largest_bending_moment.value", "bending",
          [](const LiftedNode& node) { return std::hypot(node.sagging, node.sideways); }},
    Along{"largest_sagging_moment.value", "sagging", [](const LiftedNode& node) { return node.sagging; }},
    Along{"largest_hogging_moment.value", "hogging", [](const LiftedNode& node) { return -node.sagging; }},
    Along{"largest_bending_stress", "stress", [](const LiftedNode& node) { return node.stress; }},
};

Json stage_json(const StageResult& stage) {
  Json json = stage_summary_json(stage);
  for (const LiftedLine& line : stage.lay->lift->lines) {
    Json& along = json["lines"][line.name]["along"];
    for (const Along& quantity : kAlong) {
      Json& values = along[std::string(quantity.name)] = Json::array();
      for (const LiftedNode& node : line.nodes) values.push_back(quantity.value(node));
    }
  }
  return json;
}

std::runtime_error make_stage_error(const StageResult& stage) {
  return std::runtime_error(
      fmt::format("stage '{}': {}: {}", stage.stage.name, stage.failure->what, stage.failure->why));
}

/// Returns the check with the highest utilisation of all stages.
Json find_worst_check(const Json& stages) {
  Json worst;
  for (const Json& stage : stages) {
    const Json found = stage.value("/checks/worst"_json_pointer, Json());
    if (!found.is_object() || !found.contains("utilisation")) continue;
    if (worst.is_null() || found["utilisation"] > worst["utilisation"]) worst = found;
  }
  return worst;
}

/// Returns a mapping or list in one line.
std::string flow_text(const YamlNode& node) {
  if (node.kind == YamlNode::Kind::scalar) return yaml_scalar(node.text);
  std::string text;
  for (const YamlNode& item : node.items) text += (text.empty() ? "" : ", ") + flow_text(item);
  for (const YamlEntry& entry : node.entries) {
    text += (text.empty() ? "" : ", ") + yaml_scalar(entry.key) + ": " + flow_text(entry.value);
  }
  return node.kind == YamlNode::Kind::map ? "{" + text + "}" : "[" + text + "]";
}

}  // namespace

SeekStages::SeekStages(const Description& description, const SeekDescription& seek,
                       const std::vector<SeekUnknown>& unknowns)
    : lift_(description.operation.type == OperationType::lift) {
  const Stages stages = lay_stages(description);
  for (const SeekCondition& condition : seek.until) last_ = std::max(last_, last_stage(stages, condition.result));
  if (!seek.minimise.empty()) last_ = std::max(last_, last_stage(stages, seek.minimise));
  first_ = stages.size();
  for (const SeekUnknown& unknown : unknowns) {
    const std::optional<std::size_t> stage = stage_of_key(unknown.path);
    if (stage && *stage > last_) {
      throw std::invalid_argument(fmt::format("{} belongs to a stage after '{}', the last whose results are used",
                                              unknown.name, stage_name(stages, last_)));
    }
    first_ = std::min(first_, stage.value_or(0));
  }
  const bool others = ranges::any_of(unknowns, [](const SeekUnknown& u) { return !stage_of_key(u.path); });
  if (others || !lift_) {
    first_ = 0;
    return;
  }
  Lift lift(description);
  for (std::size_t i = 0; i < first_; ++i) {
    const StageResult stage = lift.next(stages);
    stages_.push_back(stage.lay ? stage_json(stage) : stage_summary_json(stage));
  }
  before_ = std::make_shared<const Lift>(lift);
}

Json SeekStages::solve(const Description& description) const {
  if (lift_) return solve_lift_stages(description);
  std::size_t done = 0;
  const OperationResults results =
      solve_operation(description, [&](const StageResult&, std::size_t) { return ++done <= last_; });
  for (const StageResult& stage : results.stages) {
    if (stage.failure) throw make_stage_error(stage);
  }
  return operation_summary_json(results);
}

Json SeekStages::solve_lift_stages(const Description& description) const {
  Lift lift = before_ ? *before_ : Lift(description);
  Json stages = stages_;
  for (std::size_t i = first_; i <= last_; ++i) {
    const StageResult stage = lift.next(description.operation.lay.stages);
    if (stage.failure) throw make_stage_error(stage);
    stages.push_back(stage_json(stage));
  }
  Json summary = {{"checks", {{"worst", find_worst_check(stages)}}}};
  summary["operation"]["stages"] = std::move(stages);
  return summary;
}

std::string SeekStages::max_along(const std::string& result) const {
  const ResultName name = parsed_result_name(result);
  const bool is_maximum = name.function == ResultFunction::none || name.function == ResultFunction::maximum;
  for (const Along& quantity : kAlong) {
    if (!before_ || !is_maximum || !name.path.ends_with("." + std::string(quantity.result))) continue;
    return name.path.substr(0, name.path.size() - quantity.result.size()) + "along." + std::string(quantity.name) +
           "[*]";
  }
  return "";
}

bool is_slack_length(const Json& summary, const std::string& path) {
  const std::optional<std::string> line = line_of_length(path);
  if (!line) return false;
  const Json& davits = summary["operation"]["stages"][*stage_of_key(path)]["davits"];
  return davits.contains(*line) && davits[*line]["tension_upper"] == 0.0;
}

std::optional<double> kept_length(const Description& description, const std::string& path) {
  const std::optional<std::string> line = line_of_length(path);
  if (!line) return std::nullopt;
  const Stages& stages = description.operation.lay.stages;
  for (std::size_t i = std::min(*stage_of_key(path), stages.size()); i-- > 0;) {
    const auto length = ranges::find(stages[i].lengths, *line, &LineValue::line);
    if (length != stages[i].lengths.end()) return length->value;
    if (ranges::find(stages[i].tensions, *line, &LineValue::line) != stages[i].tensions.end()) return std::nullopt;
  }
  const auto line_description = ranges::find(description.lines, *line, &FreeLineDescription::name);
  if (line_description == description.lines.end()) return std::nullopt;
  return nominal_position(description).lengths[static_cast<std::size_t>(line_description - description.lines.begin())];
}

std::vector<std::string> stage_lines(const Description& answer, const std::vector<SeekUnknown>& unknowns) {
  std::set<std::size_t> stages;
  for (const SeekUnknown& unknown : unknowns) {
    if (const std::optional<std::size_t> stage = stage_of_key(unknown.path)) stages.insert(*stage);
  }
  Diagnostics none;  // the text was parsed without errors before
  const std::optional<YamlNode> tree = parse_yaml(answer.source_text, answer.source_file, none);
  std::vector<std::string> lines;
  for (const std::size_t stage : stages) {
    std::string rest;
    const std::vector<YamlSpot> spots = follow_path(*tree, fmt::format("{}[{}]", kStages, stage), rest);
    lines.push_back("- " + flow_text(*spots.back().node));
  }
  return lines;
}

}  // namespace overbend
