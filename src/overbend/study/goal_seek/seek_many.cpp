/// Search with several keys, several conditions or an objective.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/ranges.h"
#include "numerics/bounded_search.h"
#include "report/studies/seek_texts.h"
#include "resultfiles/summary/named_results.h"
#include "study/goal_seek/seek.h"
#include "study/goal_seek/seek_start_points.h"

namespace overbend {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kDifference = 1e-5;      // difference step, of the bounds: no contact opens, and above the rounding of
                                          // statics
constexpr double kConditions = 1e-6;      // tolerance relative to the required value
constexpr double kGap = 0.02;             // gap [m] that counts as much as the missing mean reaction
constexpr double kMinLengthScale = 1e-2;  // minimum scale [m], [rad] of a condition of a stage with the required value
                                          // zero
constexpr double kZeroTargetScale = 1e-2;  // scale of a condition with the required value zero, relative to the first
                                           // value
constexpr double kSettledAlong = 1e-5;     // relative to the maximum along a line, whose derivatives are those of its
                                           // peaks
constexpr std::size_t kMeetStarts = 10,
                      kFollowed = 3;  // points within the bounds: to meet conditions, to minimise from
constexpr double kSamePlace = 0.01;   // distance of equal points, of the bounds
constexpr std::size_t kRestarts = 4;  // best points within the bounds from which the search is restarted

double mean_size(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += std::abs(value);
  return sum / static_cast<double>(std::max<std::size_t>(values.size(), 1));
}

VectorXd to_vector(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

/// End of a search, with the derivatives there.
struct Ending {
  SearchResult search;
  SearchSlopes slopes;
};

/// A point within the bounds that has an equilibrium.
struct Place {
  VectorXd x;
  double violation, objective;
};

class ManyKeys {
 public:
  ManyKeys(const SeekModel& model, const SeekDescription& seek)
      : seek_(seek), history_(model), results_(started_results(model, seek)) {
    const ResultName name = parsed_result_name(seek.minimise);
    spread_ = name.function == ResultFunction::spread;
    aim_path_ = name.path;
    if (model.stages() != nullptr) along_ = model.stages()->max_along(seek.minimise);
  }

  SeekOutcome run() {
    own_ = scaled_start();
    const VectorXd begin = find_start_point();
    const SeekPoint& first = history_.at(values_at(begin));
    if (!set_scales(first)) return none(first);
    std::optional<Ending> end = search_from(begin);
    if (!end) return none(first);
    if (samples_all_points()) {
      search_where_conditions_hold(*end);
    } else if (!end->search.met) {
      search_over_bounds(*end);
    }
    return make_outcome(*end);
  }

 private:
  std::optional<Ending> search_from(const VectorXd& begin) {
    SearchProblem problem;
    problem.start = begin;
    problem.linear_objective = linear_objective();
    problem.tolerance = kConditions;
    if (!along_.empty()) problem.settled = kSettledAlong;
    problem.values = [this](const VectorXd& x) { return values(history_.at(values_at(x))); };
    problem.slopes = [this](const VectorXd& x, const SearchValues& values_here) { return slopes(x, values_here); };
    last_slopes_ = {};
    std::optional<SearchResult> end = bounded_search(problem);
    if (!end) return std::nullopt;
    return Ending{std::move(*end), last_slopes_};
  }

  /// Models of a lift are solved in milliseconds. Davits that are slack during the search have no derivatives, and the
  /// maximum moment has several optima: the whole region within the bounds is sampled.
  bool samples_all_points() const {
    const SeekStages* stages = history_.model().stages();
    return stages != nullptr && stages->are_quick() && !seek_.minimise.empty();
  }

  /// Returns the model's own values, or the nearest point that has an equilibrium.
  VectorXd find_start_point() {
    if (history_.at(values_at(own_)).solved()) return own_;
    for (const VectorXd& x : start_points_within_bounds(own_)) {
      if (!history_.at(values_at(x)).solved()) continue;
      results_.remarks.emplace_back(
          "the model's own values have no equilibrium; the search started from other values within the bounds");
      return x;
    }
    return own_;
  }

  /// A gradient search ends where no small change of the keys improves the conditions, such as the clearance of a box
  /// on which the pipe lies: conditions may still be met elsewhere within the bounds. These are therefore sampled, and
  /// the search is restarted from the best points. `end`: the best so far.
  void search_over_bounds(Ending& end) {
    to_own_ = seek_.minimise.empty();
    search_from_all(best_places(kRestarts), end);
  }

  void search_from_all(const std::vector<Place>& places, Ending& end) {
    const bool met_before = end.search.met;
    restarts_ = places.size();
    for (const Place& place : places) {
      std::optional<Ending> candidate = search_from(place.x);
      if (candidate && better(candidate->search, end.search)) end = std::move(*candidate);
    }
    if (end.search.met && !met_before) {
      results_.remarks.emplace_back(
          "the search from the model's own values did not reach the answer, which was found from other values within "
          "the bounds");
    }
  }

  /// First meets the conditions from points within the bounds, then minimises from the best of those.
  void search_where_conditions_hold(Ending& end) {
    std::vector<Place> met;
    for (const Place& place : best_places(kMeetStarts)) {
      conditions_only_ = true;
      std::optional<Ending> candidate = search_from(place.x);
      conditions_only_ = false;
      if (!candidate) continue;
      if (candidate->search.met) {
        add_place(candidate->search.x, met);
      } else if (!end.search.met && candidate->search.violation < end.search.violation) {
        end = std::move(*candidate);  // the nearest so far
      }
    }
    ranges::stable_sort(met, {}, &Place::objective);
    if (met.size() > kFollowed) met.resize(kFollowed);
    search_from_all(met, end);
    if (met.empty()) restarts_ = std::min(kMeetStarts, sampled_points_ - without_values_);
  }

  /// Adds a point at which the conditions are met, unless it is known.
  void add_place(const VectorXd& x, std::vector<Place>& met) {
    const auto same = [&](const Place& known) { return (known.x - x).cwiseAbs().maxCoeff() < kSamePlace; };
    if (ranges::none_of(met, same)) {
      met.push_back({x, 0.0, objective_value(values(history_.at(values_at(x))).value())});
    }
  }

  /// Returns the points at which the conditions hold, with the lowest objective first; without any, those nearest to
  /// it.
  std::vector<Place> best_places(std::size_t max_count) {
    std::vector<Place> places;
    sampled_points_ = 0;
    for (const VectorXd& x : start_points_within_bounds(own_)) {
      ++sampled_points_;
      const std::optional<SearchValues> values_there = values(history_.at(values_at(x)));
      if (values_there) {
        places.push_back({x, std::max(compute_violation(*values_there), kConditions), objective_value(*values_there)});
      }
    }
    without_values_ = sampled_points_ - places.size();
    std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
      return a.violation != b.violation ? a.violation < b.violation : a.objective < b.objective;
    });
    if (places.size() > max_count) places.resize(max_count);
    return places;
  }

  bool better(const SearchResult& a, const SearchResult& b) const {
    if (a.met != b.met) return a.met;
    return a.met ? objective_value(a.values) < objective_value(b.values) : a.violation < b.violation;
  }

  bool linear_objective() const { return !spread_ && !to_own_; }

  double objective_value(const SearchValues& values) const {
    if (values.objective.size() == 0) return 0.0;
    return linear_objective() ? values.objective.maxCoeff() : values.objective.squaredNorm();
  }

  double scaled(double value, Index i) const {
    const SeekUnknown& u = results_.unknowns[static_cast<std::size_t>(i)];
    return (value - u.from) / (u.to - u.from);
  }

  VectorXd scaled_start() const {
    VectorXd x(static_cast<Index>(results_.unknowns.size()));
    for (Index i = 0; i < x.size(); ++i) {
      x(i) = std::clamp(scaled(results_.unknowns[static_cast<std::size_t>(i)].before, i), 0.0, 1.0);
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

  /// Sets the scales of the conditions and of the objective. False if the model has no equilibrium or a result does not
  /// apply.
  bool set_scales(const SeekPoint& first) {
    if (!first.solved()) return false;
    for (std::size_t i = 0; i < seek_.until.size(); ++i) {
      const std::vector<double> at_first = goal_values(first, seek_.until[i].result);
      if (at_first.empty()) return does_not_apply(seek_.until[i].result);
      const double wanted = std::abs(seek_.until[i].value);
      scales_.push_back(wanted > 0.0 ? wanted : std::max(kZeroTargetScale * mean_size(at_first), zero_target_scale(i)));
      results_.goals[i].before = decisive_value(first, seek_.until[i]);
    }
    if (seek_.minimise.empty()) return true;
    const std::vector<double> aims = aim_values(first);
    if (aims.empty()) return does_not_apply(seek_.minimise);
    aim_scale_ = std::max(along_.empty() ? mean_size(aims) : *ranges::max_element(aims), 1e-12);
    results_.goals.back().before = named_result(first.summary, seek_.minimise);
    return true;
  }

  /// Minimum scale of a condition whose required value is zero: the model may already meet it exactly.
  double zero_target_scale(std::size_t condition) const {
    const std::string& unit = seek_.until[condition].unit;
    const bool stages = history_.model().stages() != nullptr;
    return stages && (unit == "m" || unit == "rad") ? kMinLengthScale : 1e-12;
  }

  bool does_not_apply(const std::string& result) {
    results_.why = result + " does not apply to this model";
    return false;
  }

  /// Values of the objective: all values of a spread, those of all nodes for a maximum along lines, otherwise one.
  std::vector<double> aim_values(const SeekPoint& point) const {
    if (!along_.empty()) return named_values(point.summary, along_);
    return spread_ ? with_gaps(point, named_values(point.summary, aim_path_)) : goal_values(point, seek_.minimise);
  }

  /// Replaces zero reactions of supports by the negative gap: a reaction of zero would not show the search in which
  /// direction its support has to move.
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

  /// Change from the model's own values, in parts of the bounds.
  VectorXd from_own(const SeekPoint& point) const {
    VectorXd change(own_.size());
    for (Index i = 0; i < change.size(); ++i) {
      change(i) = scaled(point.values[static_cast<std::size_t>(i)], i) - own_(i);
    }
    return change;
  }

  std::optional<SearchValues> values(const SeekPoint& point) const {
    if (!point.solved()) return std::nullopt;
    std::vector<double> equal, inequality;
    for (std::size_t i = 0; i < seek_.until.size(); ++i) {
      const SeekCondition& condition = seek_.until[i];
      const std::vector<double> found = goal_values(point, condition.result);
      if (found.empty()) return std::nullopt;
      for (const double value : found) {
        const double off = (value - condition.value) / scales_[i];
        if (condition.relation == SeekRelation::equals) equal.push_back(off);
        if (condition.relation == SeekRelation::at_most) inequality.push_back(-off);
        if (condition.relation == SeekRelation::at_least) inequality.push_back(off);
      }
    }
    SearchValues point_values{to_vector(equal), to_vector(inequality), {}};
    if (to_own_) point_values.objective = from_own(point);
    if (seek_.minimise.empty() || conditions_only_) return point_values;
    const std::vector<double> aims = aim_values(point);
    if (aims.empty()) return std::nullopt;
    point_values.objective = to_vector(aims) / aim_scale_;
    if (spread_) {
      point_values.objective = ((point_values.objective.array() - point_values.objective.mean()) /
                                std::sqrt(static_cast<double>(aims.size())))
                                   .matrix();
    }
    return point_values;
  }

  /// Derivatives by differences. All points start from the present equilibrium, also this point itself again, so that
  /// they have the same mesh. A key at its upper bound is moved down.
  SearchSlopes slopes(const VectorXd& x, const SearchValues& values_at_x) {
    std::vector<std::vector<double>> asked = {values_at(x)};
    std::vector<double> steps;
    for (Index i = 0; i < x.size(); ++i) {
      steps.push_back(x(i) + kDifference > 1.0 ? -kDifference : kDifference);
      VectorXd moved = x;
      moved(i) += steps.back();
      asked.push_back(values_at(moved));
    }
    const std::vector<const SeekPoint*> points = history_.at_all(asked, values_at(x));
    const SearchValues reference = values(*points.front()).value_or(values_at_x);
    SearchSlopes gradients{MatrixXd::Zero(values_at_x.equal.size(), x.size()),
                           MatrixXd::Zero(values_at_x.inequality.size(), x.size()),
                           MatrixXd::Zero(values_at_x.objective.size(), x.size())};
    for (Index i = 0; i < x.size(); ++i) {
      const std::optional<SearchValues> moved = values(*points[static_cast<std::size_t>(i) + 1]);
      if (!moved) continue;  // without a value the key stays unchanged
      const double step = steps[static_cast<std::size_t>(i)];
      gradients.equal.col(i) = (moved->equal - reference.equal) / step;
      gradients.inequality.col(i) = (moved->inequality - reference.inequality) / step;
      gradients.objective.col(i) = (moved->objective - reference.objective) / step;
    }
    last_slopes_ = gradients;
    return gradients;
  }

  SeekOutcome none(const SeekPoint& first) {
    if (!first.solved()) results_.why = "the model to start from has no equilibrium: " + first.failure;
    add_path(history_, results_);
    return {std::move(results_), {}};
  }

  SeekOutcome make_outcome(const Ending& end) {
    const SeekPoint& point = history_.at(values_at(end.search.x));
    results_.found = end.search.met;
    add_answer(point, results_);
    results_.residual = end.search.violation;  // in the scales of the conditions, also of those with the required value
                                               // zero
    add_slopes(end.slopes, end.search.values);
    if (!end.search.met) results_.why = make_failure_reason();
    if (!end.search.settled) {
      results_.remarks.emplace_back("the search ended before it converged: there may be a better answer nearby");
    }
    remark_slack_lines(point);
    for (const SeekUnknown& unknown : results_.unknowns) {
      if (!unknown.at_bound) continue;
      results_.remarks.push_back(unknown.name + " is at its bound, " + quantity_text(unknown.answer, unknown));
    }
    add_path(history_, results_);
    return {std::move(results_), point.solution};
  }

  /// Remarks on lengths of slack lines, for which any longer length is equivalent.
  void remark_slack_lines(const SeekPoint& point) {
    for (const SeekUnknown& unknown : results_.unknowns) {
      if (!results_.found || !is_slack_length(point.summary, unknown.path)) continue;
      results_.remarks.push_back(
          unknown.name +
          " is the length of a slack line without load: any longer one is equivalent (at_least on "
          "its tension keeps it taut)");
    }
  }

  /// Fills the slopes of conditions with one value, and of a single value that is minimised.
  void add_slopes(const SearchSlopes& slopes, const SearchValues& values) {
    if (slopes.equal.cols() == 0) return;
    Index equal = 0, inequality = 0;
    for (std::size_t i = 0; i < seek_.until.size(); ++i) {
      const SeekCondition& condition = seek_.until[i];
      const bool is_equal = condition.relation == SeekRelation::equals;
      const double sign = condition.relation == SeekRelation::at_most ? -1.0 : 1.0;
      const std::size_t count = goal_values(history_.points().front(), condition.result).size();
      if (count == 1) {
        put_slope(results_.goals[i],
                  sign * scales_[i] * (is_equal ? slopes.equal.row(equal) : slopes.inequality.row(inequality)));
      }
      (is_equal ? equal : inequality) += static_cast<Index>(count);
    }
    if (seek_.minimise.empty() || spread_ || values.objective.size() == 0) return;
    Index max_index = 0;
    values.objective.maxCoeff(&max_index);
    put_slope(results_.goals.back(), aim_scale_ * slopes.objective.row(max_index));
  }

  void put_slope(SeekGoal& goal, const VectorXd& row) const {
    for (Index i = 0; i < row.size(); ++i) {
      const SeekUnknown& u = results_.unknowns[static_cast<std::size_t>(i)];
      goal.slope.push_back(row(i) / (u.to - u.from));
    }
  }

  std::string make_failure_reason() const {
    std::string why = fmt::format(
        "no values within the bounds meet all conditions: the search started from the model's own values and "
        "from the {} best of {} points within the bounds (corners, middle and Latin hypercube",
        restarts_, sampled_points_);
    if (without_values_ > 0) why += fmt::format("; {} of them have no equilibrium", without_values_);
    why += "); at the nearest point found";
    for (const SeekGoal& goal : results_.goals) {
      if (!goal.is || !goal.reached) continue;
      why += fmt::format(", {} is {} and should be {}", goal.result, goal_value_text(*goal.reached, goal),
                         goal_text(goal));
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
  std::string along_;             ///< See SeekStages::max_along.
  VectorXd own_;                  ///< The model's own values, scaled.
  bool to_own_ = false;           ///< The objective is the minimum change of the keys: used when the search starts
                                  ///< elsewhere.
  bool conditions_only_ = false;  ///< Nothing is minimised.
  SearchSlopes last_slopes_;
  std::size_t sampled_points_ = 0, without_values_ = 0, restarts_ = 0;  ///< Numbers of points within the bounds.
};

}  // namespace

SeekOutcome seek_many(const SeekModel& model, const SeekDescription& seek) {
  return ManyKeys(model, seek).run();
}

}  // namespace overbend
