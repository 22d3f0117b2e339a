#include "study/goal_seek/seek.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/interruption.h"
#include "base/shown_unit.h"
#include "resultfiles/summary/named_results.h"
#include "study/stages/stage_choice.h"

namespace overbend {
namespace {

/// Value of a condition or of the objective.
std::optional<double> shown_value(const SeekPoint& point, const SeekGoal& goal) {
  if (!goal.is) return named_result(point.summary, goal.result);
  return decisive_value(point, {goal.result, goal.unit, *goal.is, goal.wanted});
}

double off(const SeekGoal& goal) {
  const double away = goal.reached.value_or(0.0) - goal.wanted;
  const double size = std::max(std::abs(goal.wanted), 1e-12);
  if (goal.is == SeekRelation::at_most) return std::max(away, 0.0) / size;
  if (goal.is == SeekRelation::at_least) return std::max(-away, 0.0) / size;
  return std::abs(away) / size;
}

bool close(double a, double b, double range) {
  return std::abs(a - b) <= 1e-6 * range;
}

}  // namespace

std::vector<double> goal_values(const SeekPoint& point, const std::string& result) {
  const ResultName name = parsed_result_name(result);
  if (name.function == ResultFunction::none) return named_values(point.summary, name.path);
  const std::optional<double> value = named_result(point.summary, result);
  return value ? std::vector<double>{*value} : std::vector<double>{};
}

std::optional<double> decisive_value(const SeekPoint& point, const SeekCondition& condition) {
  const std::vector<double> values = goal_values(point, condition.result);
  if (values.empty()) return std::nullopt;
  if (condition.relation == SeekRelation::at_most) return *std::max_element(values.begin(), values.end());
  if (condition.relation == SeekRelation::at_least) return *std::min_element(values.begin(), values.end());
  return *std::max_element(values.begin(), values.end(), [&](double a, double b) {
    return std::abs(a - condition.value) < std::abs(b - condition.value);
  });
}

SeekResults started_results(const SeekModel& model, const SeekDescription& seek) {
  SeekResults results;
  results.unknowns = model.unknowns();
  for (const SeekCondition& condition : seek.until) {
    results.goals.push_back(
        {.result = condition.result, .unit = condition.unit, .is = condition.relation, .wanted = condition.value});
  }
  if (!seek.minimise.empty()) {
    results.goals.push_back({.result = seek.minimise, .unit = result_unit(seek.minimise).value_or("1"), .is = {}});
  }
  return results;
}

void add_path(const SeekHistory& history, SeekResults& results) {
  results.evaluations = static_cast<int>(history.points().size());
  for (const SeekPoint& point : history.points()) {
    if (point.probe) continue;
    SeekStep step{point.values, {}, point.failure};
    for (const SeekGoal& goal : results.goals) {
      const std::optional<double> value = point.solved() ? shown_value(point, goal) : std::nullopt;
      if (value) step.results.push_back(*value);
    }
    if (step.results.size() < results.goals.size()) step.results.clear();
    results.path.push_back(std::move(step));
  }
}

void add_answer(const SeekPoint& point, SeekResults& results) {
  for (std::size_t i = 0; i < results.unknowns.size(); ++i) {
    SeekUnknown& unknown = results.unknowns[i];
    const double range = unknown.to - unknown.from;
    unknown.answer = point.values[i];
    unknown.found = results.found;
    unknown.at_bound = close(unknown.answer, unknown.from, range) || close(unknown.answer, unknown.to, range);
  }
  for (SeekGoal& goal : results.goals) {
    goal.reached = shown_value(point, goal);
    if (goal.is) results.residual = std::max(results.residual, off(goal));
  }
}

std::vector<YamlChange> answer_changes(const Description& description, const SeekDescription& wanted,
                                       const SeekResults& results) {
  std::vector<double> values;
  for (const SeekUnknown& unknown : results.unknowns) values.push_back(unknown.answer);
  return SeekModel(description, wanted).changes(values);
}

namespace {

/// Compares the answer, which was reached from neighbouring models, with its statics from scratch: a different
/// equilibrium must be known before the barge is set up by it.
void compare_with_statics(const SeekModel& model, SeekOutcome& outcome) {
  SeekResults& results = outcome.results;
  constexpr double kSame = 0.02;  // relative to the largest reaction: other meshes change it by 0.1 %
  constexpr const char* kReaction = "static.largest_reaction.value";
  std::vector<double> values;
  for (const SeekUnknown& unknown : results.unknowns) values.push_back(unknown.answer);
  const SeekPoint found = model.solve(values, outcome.start ? &*outcome.start : nullptr);
  const SeekPoint alone = model.solve(values, nullptr);
  if (!found.solved() || !alone.solved()) return;
  const std::optional<double> found_reaction = named_result(found.summary, kReaction),
                              cold_reaction = named_result(alone.summary, kReaction);
  if (!found_reaction || !cold_reaction) return;
  if (std::abs(*found_reaction - *cold_reaction) <= kSame * *found_reaction) return;
  results.remarks.push_back(
      fmt::format("solved from scratch, the model with the answer has another equilibrium, with {} as largest "
                  "reaction of a roller instead of {}: it has several, which differ in the rollers that carry load",
                  shown(*cold_reaction, "N", 1), shown(*found_reaction, "N", 1)));
}

}  // namespace

SeekOutcome seek(const Description& description, const SeekDescription& wanted, const std::function<bool()>& stop) {
  const auto start = std::chrono::steady_clock::now();
  const InterruptionScope scope(stop);
  const SeekModel model(description, wanted, stop);
  const bool is_single = model.unknowns().size() == 1 && wanted.until.size() == 1 && wanted.minimise.empty();
  SeekOutcome outcome = is_single ? seek_one(model, wanted.until.front()) : seek_many(model, wanted);
  if (is_lay_operation(description.operation.type) && model.stages() == nullptr) {
    outcome.results.remarks.push_back(no_stage_finding(description, false).message);
  }
  if (outcome.results.found && model.stages() == nullptr) compare_with_statics(model, outcome);
  outcome.results.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

}  // namespace overbend
