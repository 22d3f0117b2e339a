/// One key, one condition: the whole interval is scanned.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "base/units.h"
#include "numerics/root_scan.h"
#include "report/studies/seek_texts.h"
#include "study/goal_seek/seek.h"

namespace overbend {
namespace {

constexpr double kSlopeStep = 1e-4;  // of the bounds, in both directions

/// Names of the supports in contact.
std::vector<std::string> carrying(const SeekPoint& point) {
  std::vector<std::string> names;
  const Json supports = point.summary.value("/static/supports"_json_pointer, Json::array());
  for (const Json& support : supports) {
    if (support["reaction"].get<double>() > 0.0) names.push_back(support["name"].get<std::string>());
  }
  return names;
}

std::vector<std::string> without(const std::vector<std::string>& names, const std::vector<std::string>& others) {
  std::vector<std::string> left;
  std::copy_if(names.begin(), names.end(), std::back_inserter(left),
               [&](const std::string& name) { return std::find(others.begin(), others.end(), name) == others.end(); });
  return left;
}

/// Describes the changes of contact when the key rises across the jump.
std::string change_of_contact(const SeekPoint& below, const SeekPoint& above) {
  const std::vector<std::string> before = carrying(below), after = carrying(above);
  const std::vector<std::string> gone = without(before, after), come = without(after, before);
  std::vector<std::string> changes;
  if (!gone.empty()) {
    changes.push_back(join_items(gone, "and") + (gone.size() > 1 ? " lose contact" : " loses contact"));
  }
  if (!come.empty()) {
    changes.push_back(join_items(come, "and") + (come.size() > 1 ? " come into contact" : " comes into contact"));
  }
  return join_items(changes, "and");
}

class OneKey {
 public:
  OneKey(const SeekModel& model, const SeekCondition& condition)
      : condition_(condition),
        history_(model),
        results_(started_results(model, {{}, {condition}, {}})),
        unknown_(model.unknowns().front()) {}

  SeekOutcome run() {
    int evaluated = 0;
    const ScannedFunction f = [this, &evaluated](double x) {
      history_.set_warm_start_source(evaluated++ <
                                     ScanSettings{}.points);  // brackets are refined from the points of the grid
      return off(x);
    };
    results_.goals[0].before = decisive_value(history_.at({unknown_.before}), condition_);
    require_one_value();
    ScanSettings settings;
    settings.both_ends = inequality();  // the answer lies on the side where the limit is kept
    const RootScan scan = scan_roots(f, unknown_.from, unknown_.to, settings);
    results_.monotone = is_monotone(scan);
    add_jumps(scan);
    const std::vector<double> answers = find_answers(scan);
    results_.found = !answers.empty();
    if (results_.found) {
      results_.others.assign(answers.begin() + 1, answers.end());
      add_slope(answers.front());
      add_answer(history_.at({answers.front()}), results_);
      remark();
    } else {
      results_.why = no_answer_reason(results_, find_scan_range(scan));
    }
    add_path(history_, results_);
    SeekOutcome outcome{std::move(results_), {}};
    if (outcome.results.found) outcome.start = history_.at({answers.front()}).solution;
    return outcome;
  }

 private:
  bool inequality() const { return condition_.relation != SeekRelation::equals; }
  bool holds(double off) const { return condition_.relation == SeekRelation::at_most ? off <= 0.0 : off >= 0.0; }

  /// Result minus required value.
  std::optional<double> off(double x) {
    const SeekPoint& point = history_.at({x});
    if (!point.solved()) return std::nullopt;
    const std::optional<double> value = decisive_value(point, condition_);
    return value ? std::optional(*value - condition_.value) : std::nullopt;
  }

  void require_one_value() {
    const SeekPoint& point = history_.points().front();
    if (inequality() || !point.solved() || goal_values(point, condition_.result).size() < 2) return;
    throw SeekError(condition_.result + " has several values, which one key cannot all make equal to the target; " +
                    "vary several keys, or choose one item");
  }

  void add_jumps(const RootScan& scan) {
    for (const Crossing& c : scan.crossings) {
      if (!c.jump) continue;
      results_.jumps.push_back({0.5 * (c.low + c.high), c.at_low + condition_.value, c.at_high + condition_.value,
                                change_of_contact(history_.at({c.low}), history_.at({c.high}))});
    }
  }

  /// Returns the answers in the order of reporting: for `equals` the nearest to the model's own value first, for a
  /// limit the minimum value of the key that meets it.
  std::vector<double> find_answers(const RootScan& scan) const {
    std::vector<double> answers;
    if (inequality()) {
      const auto first = std::find_if(scan.points.begin(), scan.points.end(),
                                      [&](const ScannedPoint& p) { return p.value && holds(*p.value); });
      if (first != scan.points.end()) answers.push_back(first->x);
      return answers;
    }
    for (const Crossing& c : scan.crossings) {
      if (!c.jump) answers.push_back(c.nearest());
    }
    std::stable_sort(answers.begin(), answers.end(),
                     [&](double a, double b) { return std::abs(a - unknown_.before) < std::abs(b - unknown_.before); });
    return answers;
  }

  void add_slope(double answer) {
    const double h = kSlopeStep * (unknown_.to - unknown_.from);
    const double low = std::max(answer - h, unknown_.from), high = std::min(answer + h, unknown_.to);
    const std::optional<double> at_low = off(low), at_high = off(high);
    if (at_low && at_high) results_.goals[0].slope = {(*at_high - *at_low) / (high - low)};
  }

  void remark() {
    if (inequality() && results_.unknowns[0].at_bound) {
      results_.remarks.push_back("the limit is already met at the lower bound of " + unknown_.name);
    }
    if (inequality() && !results_.monotone.value_or(true)) {
      results_.remarks.push_back(condition_.result +
                                 " is not monotonic between the bounds: the limit may be exceeded again above " +
                                 quantity_text(results_.unknowns[0].answer, unknown_));
    }
    if (!results_.others.empty()) {
      results_.remarks.push_back(fmt::format("there are {} answers; the one nearest to the model's own value is taken",
                                             results_.others.size() + 1));
    }
  }

  /// Minimum and maximum value reached, and the values without an equilibrium.
  ScanSummary find_scan_range(const RootScan& scan) const {
    ScanSummary range;
    for (const ScannedPoint& point : scan.points) {
      if (!point.value) {
        range.gaps.push_back(point.x);
        continue;
      }
      const double value = *point.value + condition_.value;
      range.minimum = std::min(range.minimum.value_or(value), value);
      range.maximum = std::max(range.maximum.value_or(value), value);
    }
    for (const SeekPoint& point : history_.points()) {
      if (range.failure.empty()) range.failure = point.failure;
    }
    return range;
  }

  SeekCondition condition_;
  SeekHistory history_;
  SeekResults results_;
  SeekUnknown unknown_;
};

}  // namespace

SeekOutcome seek_one(const SeekModel& model, const SeekCondition& condition) {
  return OneKey(model, condition).run();
}

}  // namespace overbend
