/// Several keys, several conditions or something to minimise.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "numerics/bounded_search.h"
#include "report/seek_words.h"
#include "resultfiles/named_results.h"
#include "study/seek.h"

namespace overbend {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kDifference = 1e-5;  // of the bounds: below what opens a contact, above the rounding of statics
constexpr double kConditions = 1e-6;  // relative to the value wanted
constexpr double kGap = 0.02;         // [m] a gap that counts as much as the mean reaction missing
constexpr double kLikeZero = 1e-2;    // of the first value: scale of a condition whose wanted value is zero

double mean_size(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += std::abs(value);
  return sum / static_cast<double>(std::max<std::size_t>(values.size(), 1));
}

VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

class ManyKeys {
 public:
  ManyKeys(const SeekModel& model, const SeekDescription& seek)
      : seek_(seek), history_(model), results_(started_results(model, seek)) {
    const ResultName name = parsed_result_name(seek.minimise);
    spread_ = name.function == ResultFunction::spread;
    aim_path_ = name.path;
  }

  SeekOutcome run() {
    SearchProblem problem;
    problem.start = scaled_start();
    problem.linear_aim = !spread_;
    problem.tolerance = kConditions;
    const SeekPoint& first = history_.at(values_at(problem.start));
    if (!set_scales(first)) return none(first);
    problem.values = [this](const VectorXd& x) { return values(history_.at(values_at(x))); };
    problem.slopes = [this](const VectorXd& x, const SearchValues& at) { return slopes(x, at); };
    const std::optional<SearchEnd> end = bounded_search(problem);
    if (!end) return none(first);
    return told(*end);
  }

 private:
  VectorXd scaled_start() const {
    VectorXd x(static_cast<Index>(results_.unknowns.size()));
    for (Index i = 0; i < x.size(); ++i) {
      const SeekUnknown& u = results_.unknowns[static_cast<std::size_t>(i)];
      x(i) = std::clamp((u.before - u.from) / (u.to - u.from), 0.0, 1.0);
    }
    return x;
  }

  std::vector<double> values_at(const VectorXd& x) const {
    std::vector<double> values;
    for (Index i = 0; i < x.size(); ++i) {
      const SeekUnknown& u = results_.unknowns[static_cast<std::size_t>(i)];
      values.push_back(u.from + x(i) * (u.to - u.from));
    }
    return values;
  }

  /// Sizes of the conditions and of the aim. False where the model has no equilibrium or a result does not apply.
  bool set_scales(const SeekPoint& first) {
    if (!first.solved()) return false;
    for (std::size_t i = 0; i < seek_.until.size(); ++i) {
      const std::vector<double> at_first = goal_values(first, seek_.until[i].result);
      if (at_first.empty()) return false;
      const double wanted = std::abs(seek_.until[i].value);
      scales_.push_back(wanted > 0.0 ? wanted : std::max(kLikeZero * mean_size(at_first), 1e-12));
      results_.goals[i].before = decisive_value(first, seek_.until[i]);
    }
    if (seek_.minimise.empty()) return true;
    const std::vector<double> aims = aim_values(first);
    if (aims.empty()) return false;
    aim_scale_ = std::max(mean_size(aims), 1e-12);
    results_.goals.back().before = named_result(first.summary, seek_.minimise);
    return true;
  }

  /// Of a spread every value, otherwise the one.
  std::vector<double> aim_values(const SeekPoint& point) const {
    return spread_ ? with_gaps(point, named_values(point.summary, aim_path_)) : goal_values(point, seek_.minimise);
  }

  /// Reactions of supports go on below zero by the gap where there is no contact: a reaction of zero would not tell the
  /// search which way its support has to move.
  std::vector<double> with_gaps(const SeekPoint& point, std::vector<double> values) const {
    const std::string reaction = ".reaction";
    if (!aim_path_.ends_with(reaction)) return values;
    const std::string supports = aim_path_.substr(0, aim_path_.size() - reaction.size());
    const std::vector<double> gaps = named_values(point.summary, supports + ".separation");
    if (gaps.size() != values.size()) return values;
    const double per_gap = mean_size(values) / kGap;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] == 0.0) values[i] = -per_gap * std::max(gaps[i], 0.0);
    }
    return values;
  }

  std::optional<SearchValues> values(const SeekPoint& point) const {
    if (!point.solved()) return std::nullopt;
    std::vector<double> equal, least;
    for (std::size_t i = 0; i < seek_.until.size(); ++i) {
      const SeekCondition& condition = seek_.until[i];
      const std::vector<double> found = goal_values(point, condition.result);
      if (found.empty()) return std::nullopt;
      for (const double value : found) {
        const double off = (value - condition.value) / scales_[i];
        if (condition.relation == SeekRelation::equals) equal.push_back(off);
        if (condition.relation == SeekRelation::at_most) least.push_back(-off);
        if (condition.relation == SeekRelation::at_least) least.push_back(off);
      }
    }
    SearchValues told{vector_of(equal), vector_of(least), {}};
    if (seek_.minimise.empty()) return told;
    const std::vector<double> aims = aim_values(point);
    if (aims.empty()) return std::nullopt;
    told.aim = vector_of(aims) / aim_scale_;
    if (spread_) {
      told.aim = ((told.aim.array() - told.aim.mean()) / std::sqrt(static_cast<double>(aims.size()))).matrix();
    }
    return told;
  }

  /// Derivatives by differences. All start from the equilibrium at hand, once more that itself, so that they stand on
  /// one mesh. A key at its upper bound is moved down.
  SearchSlopes slopes(const VectorXd& x, const SearchValues& at) {
    std::vector<std::vector<double>> asked = {values_at(x)};
    std::vector<double> steps;
    for (Index i = 0; i < x.size(); ++i) {
      steps.push_back(x(i) + kDifference > 1.0 ? -kDifference : kDifference);
      VectorXd moved = x;
      moved(i) += steps.back();
      asked.push_back(values_at(moved));
    }
    const std::vector<const SeekPoint*> points = history_.at_all(asked, values_at(x));
    const SearchValues here = values(*points.front()).value_or(at);
    SearchSlopes told{MatrixXd::Zero(at.equal.size(), x.size()), MatrixXd::Zero(at.least.size(), x.size()),
                      MatrixXd::Zero(at.aim.size(), x.size())};
    for (Index i = 0; i < x.size(); ++i) {
      const std::optional<SearchValues> there = values(*points[static_cast<std::size_t>(i) + 1]);
      if (!there) continue;  // nothing is known of this key here: it stays where it is
      const double step = steps[static_cast<std::size_t>(i)];
      told.equal.col(i) = (there->equal - here.equal) / step;
      told.least.col(i) = (there->least - here.least) / step;
      told.aim.col(i) = (there->aim - here.aim) / step;
    }
    last_slopes_ = told;
    return told;
  }

  SeekOutcome none(const SeekPoint& first) {
    results_.why = first.solved() ? "a result that is asked for does not apply to this model"
                                  : "the model to start from has no equilibrium: " + first.failure;
    tell_path(history_, results_);
    return {std::move(results_), {}};
  }

  SeekOutcome told(const SearchEnd& end) {
    const SeekPoint& point = history_.at(values_at(end.x));
    results_.found = end.met;
    tell_answer(point, results_);
    tell_slopes();
    if (!end.met) results_.why = why_not();
    if (!end.settled) results_.remarks.push_back("the search ended before it settled: a better answer may be close by");
    for (const SeekUnknown& unknown : results_.unknowns) {
      if (!unknown.at_bound) continue;
      results_.remarks.push_back(unknown.name + " is at its bound, " + quantity_words(unknown.answer, unknown));
    }
    tell_path(history_, results_);
    return {std::move(results_), point.solution};
  }

  /// Of the conditions with one value, and of a single value minimised.
  void tell_slopes() {
    if (last_slopes_.equal.cols() == 0) return;
    Index equal = 0, least = 0;
    for (std::size_t i = 0; i < seek_.until.size(); ++i) {
      const SeekCondition& condition = seek_.until[i];
      const bool is_equal = condition.relation == SeekRelation::equals;
      const double sign = condition.relation == SeekRelation::at_most ? -1.0 : 1.0;
      const std::size_t count = goal_values(history_.points().front(), condition.result).size();
      if (count == 1) {
        put_slope(results_.goals[i],
                  sign * scales_[i] * (is_equal ? last_slopes_.equal.row(equal) : last_slopes_.least.row(least)));
      }
      (is_equal ? equal : least) += static_cast<Index>(count);
    }
    if (!seek_.minimise.empty() && !spread_) put_slope(results_.goals.back(), aim_scale_ * last_slopes_.aim.row(0));
  }

  void put_slope(SeekGoal& goal, const VectorXd& row) const {
    for (Index i = 0; i < row.size(); ++i) {
      const SeekUnknown& u = results_.unknowns[static_cast<std::size_t>(i)];
      goal.slope.push_back(row(i) / (u.to - u.from));
    }
  }

  std::string why_not() const {
    std::string why = "the conditions cannot all be met within the bounds; at the nearest place found";
    for (const SeekGoal& goal : results_.goals) {
      if (!goal.is || !goal.reached) continue;
      why += fmt::format(", {} is {} and should be {}", goal.result, result_words(*goal.reached, goal),
                         wanted_words(goal));
    }
    return why;
  }

  SeekDescription seek_;
  SeekHistory history_;
  SeekResults results_;
  std::vector<double> scales_;
  double aim_scale_ = 1.0;
  bool spread_ = false;
  std::string aim_path_;
  SearchSlopes last_slopes_;
};

}  // namespace

SeekOutcome seek_many(const SeekModel& model, const SeekDescription& seek) {
  return ManyKeys(model, seek).run();
}

}  // namespace overbend
