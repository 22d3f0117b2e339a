/// Several keys, several conditions or something to minimise.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "numerics/bounded_search.h"
#include "report/studies/seek_words.h"
#include "resultfiles/summary/named_results.h"
#include "study/goal_seek/seek.h"
#include "study/goal_seek/seek_places.h"

namespace overbend {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kDifference = 1e-5;      // of the bounds: below what opens a contact, above the rounding of statics
constexpr double kConditions = 1e-6;      // relative to the value wanted
constexpr double kGap = 0.02;             // [m] a gap that counts as much as the mean reaction missing
constexpr double kLengthLikeZero = 1e-2;  // [m], [rad] the least such scale of a stage
constexpr double kLikeZero = 1e-2;        // of the first value: scale of a condition whose wanted value is zero
constexpr double kSettledAlong = 1e-5;    // of what is largest along a line, whose derivatives are those of its peaks
constexpr std::size_t kMeets = 10, kFollowed = 3;  // places over the bounds: to meet conditions, to minimise from
constexpr double kSamePlace = 0.01;                // of the bounds
constexpr std::size_t kBegins = 4;                 // best places over the bounds, from which the search begins again

double mean_size(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += std::abs(value);
  return sum / static_cast<double>(std::max<std::size_t>(values.size(), 1));
}

VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

/// Where a search led, with the derivatives there.
struct Ending {
  SearchEnd search;
  SearchSlopes slopes;
};

/// A place over the bounds that has an equilibrium.
struct Place {
  VectorXd x;
  double violation, aim;
};

class ManyKeys {
 public:
  ManyKeys(const SeekModel& model, const SeekDescription& seek)
      : seek_(seek), history_(model), results_(started_results(model, seek)) {
    const ResultName name = parsed_result_name(seek.minimise);
    spread_ = name.function == ResultFunction::spread;
    aim_path_ = name.path;
    if (model.stages() != nullptr) along_ = model.stages()->largest_along(seek.minimise);
  }

  SeekOutcome run() {
    own_ = scaled_start();
    const VectorXd begin = first_that_stands();
    const SeekPoint& first = history_.at(values_at(begin));
    if (!set_scales(first)) return none(first);
    std::optional<Ending> end = search_from(begin);
    if (!end) return none(first);
    if (looks_everywhere()) {
      search_where_conditions_hold(*end);
    } else if (!end->search.met) {
      search_over_bounds(*end);
    }
    return told(*end);
  }

 private:
  std::optional<Ending> search_from(const VectorXd& begin) {
    SearchProblem problem;
    problem.start = begin;
    problem.linear_aim = linear_aim();
    problem.tolerance = kConditions;
    if (!along_.empty()) problem.settled = kSettledAlong;
    problem.values = [this](const VectorXd& x) { return values(history_.at(values_at(x))); };
    problem.slopes = [this](const VectorXd& x, const SearchValues& at) { return slopes(x, at); };
    last_slopes_ = {};
    std::optional<SearchEnd> end = bounded_search(problem);
    if (!end) return std::nullopt;
    return Ending{std::move(*end), last_slopes_};
  }

  /// Models of a lift are solved in milliseconds. Davits that are slack on the way have no derivatives, and the largest
  /// moment has several optima: all that the bounds allow is looked over.
  bool looks_everywhere() const {
    const SeekStages* stages = history_.model().stages();
    return stages != nullptr && stages->are_quick() && !seek_.minimise.empty();
  }

  /// The model's own values, or where these have no equilibrium the nearest place that has one.
  VectorXd first_that_stands() {
    if (history_.at(values_at(own_)).solved()) return own_;
    for (const VectorXd& x : places_within_bounds(own_)) {
      if (!history_.at(values_at(x)).solved()) continue;
      results_.remarks.emplace_back(
          "with the model's own values there is no equilibrium; the search began from other values within the bounds");
      return x;
    }
    return own_;
  }

  /// A search by derivatives ends where no small change of the keys betters the conditions, such as the clearance of a
  /// box on which the pipe lies: that they cannot be met within the bounds does not follow. So these are looked over,
  /// and the search begins again from the best places. `end`: the best so far.
  void search_over_bounds(Ending& end) {
    to_own_ = seek_.minimise.empty();
    search_from_all(best_places(kBegins), end);
  }

  void search_from_all(const std::vector<Place>& places, Ending& end) {
    const bool met_before = end.search.met;
    begun_again_ = places.size();
    for (const Place& place : places) {
      std::optional<Ending> other = search_from(place.x);
      if (other && better(other->search, end.search)) end = std::move(*other);
    }
    if (end.search.met && !met_before) {
      results_.remarks.emplace_back(
          "from the model's own values no small change leads to the answer, which was found from other values within "
          "the bounds");
    }
  }

  /// From places over the bounds the conditions are met first; what is minimised is followed from the best of those.
  void search_where_conditions_hold(Ending& end) {
    std::vector<Place> met;
    for (const Place& place : best_places(kMeets)) {
      conditions_only_ = true;
      std::optional<Ending> there = search_from(place.x);
      conditions_only_ = false;
      if (!there) continue;
      if (there->search.met) {
        add_place(there->search.x, met);
      } else if (!end.search.met && there->search.violation < end.search.violation) {
        end = std::move(*there);  // the nearest so far
      }
    }
    std::ranges::stable_sort(met, {}, &Place::aim);
    if (met.size() > kFollowed) met.resize(kFollowed);
    search_from_all(met, end);
    if (met.empty()) begun_again_ = std::min(kMeets, looked_at_ - without_values_);
  }

  /// Where the conditions are met, unless that is known.
  void add_place(const VectorXd& x, std::vector<Place>& met) {
    const auto same = [&](const Place& other) { return (other.x - x).cwiseAbs().maxCoeff() < kSamePlace; };
    if (std::ranges::none_of(met, same)) met.push_back({x, 0.0, aim_of(values(history_.at(values_at(x))).value())});
  }

  /// Those at which the conditions hold, the least aim first; without any of them those nearest to it.
  std::vector<Place> best_places(std::size_t most) {
    std::vector<Place> places;
    looked_at_ = 0;
    for (const VectorXd& x : places_within_bounds(own_)) {
      ++looked_at_;
      const std::optional<SearchValues> there = values(history_.at(values_at(x)));
      if (there) places.push_back({x, std::max(violation_of(*there), kConditions), aim_of(*there)});
    }
    without_values_ = looked_at_ - places.size();
    std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
      return a.violation != b.violation ? a.violation < b.violation : a.aim < b.aim;
    });
    if (places.size() > most) places.resize(most);
    return places;
  }

  bool better(const SearchEnd& a, const SearchEnd& b) const {
    if (a.met != b.met) return a.met;
    return a.met ? aim_of(a.values) < aim_of(b.values) : a.violation < b.violation;
  }

  bool linear_aim() const { return !spread_ && !to_own_; }

  double aim_of(const SearchValues& at) const {
    if (at.aim.size() == 0) return 0.0;
    return linear_aim() ? at.aim.maxCoeff() : at.aim.squaredNorm();
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

  /// Sizes of the conditions and of the aim. False where the model has no equilibrium or a result does not apply.
  bool set_scales(const SeekPoint& first) {
    if (!first.solved()) return false;
    for (std::size_t i = 0; i < seek_.until.size(); ++i) {
      const std::vector<double> at_first = goal_values(first, seek_.until[i].result);
      if (at_first.empty()) return does_not_apply(seek_.until[i].result);
      const double wanted = std::abs(seek_.until[i].value);
      scales_.push_back(wanted > 0.0 ? wanted : std::max(kLikeZero * mean_size(at_first), like_zero(i)));
      results_.goals[i].before = decisive_value(first, seek_.until[i]);
    }
    if (seek_.minimise.empty()) return true;
    const std::vector<double> aims = aim_values(first);
    if (aims.empty()) return does_not_apply(seek_.minimise);
    aim_scale_ = std::max(along_.empty() ? mean_size(aims) : *std::ranges::max_element(aims), 1e-12);
    results_.goals.back().before = named_result(first.summary, seek_.minimise);
    return true;
  }

  /// The least scale of a condition whose wanted value is zero: the model may have just that already.
  double like_zero(std::size_t condition) const {
    const std::string& unit = seek_.until[condition].unit;
    const bool stages = history_.model().stages() != nullptr;
    return stages && (unit == "m" || unit == "rad") ? kLengthLikeZero : 1e-12;
  }

  bool does_not_apply(const std::string& result) {
    results_.why = result + " does not apply to this model";
    return false;
  }

  /// Of a spread every value, of what is largest along lines those of all nodes, otherwise the one.
  std::vector<double> aim_values(const SeekPoint& point) const {
    if (!along_.empty()) return named_values(point.summary, along_);
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

  /// Way from the model's own values, in parts of the bounds.
  VectorXd from_own(const SeekPoint& point) const {
    VectorXd way(own_.size());
    for (Index i = 0; i < way.size(); ++i) way(i) = scaled(point.values[static_cast<std::size_t>(i)], i) - own_(i);
    return way;
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
    if (to_own_) told.aim = from_own(point);
    if (seek_.minimise.empty() || conditions_only_) return told;
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
    if (!first.solved()) results_.why = "the model to start from has no equilibrium: " + first.failure;
    tell_path(history_, results_);
    return {std::move(results_), {}};
  }

  SeekOutcome told(const Ending& end) {
    const SeekPoint& point = history_.at(values_at(end.search.x));
    results_.found = end.search.met;
    tell_answer(point, results_);
    results_.residual = end.search.violation;  // in the scales of the conditions, of those wanted to be zero as well
    tell_slopes(end.slopes, end.search.values);
    if (!end.search.met) results_.why = why_not();
    if (!end.search.settled) {
      results_.remarks.emplace_back("the search ended before it settled: a better answer may be close by");
    }
    remark_slack_lines(point);
    for (const SeekUnknown& unknown : results_.unknowns) {
      if (!unknown.at_bound) continue;
      results_.remarks.push_back(unknown.name + " is at its bound, " + quantity_words(unknown.answer, unknown));
    }
    tell_path(history_, results_);
    return {std::move(results_), point.solution};
  }

  /// Lengths that any longer one may take the place of.
  void remark_slack_lines(const SeekPoint& point) {
    for (const SeekUnknown& unknown : results_.unknowns) {
      if (!results_.found || !is_slack_length(point.summary, unknown.path)) continue;
      results_.remarks.push_back(
          unknown.name +
          " is that of a slack line, which bears nothing: a longer one does as well (at_least on "
          "its tension keeps it taut)");
    }
  }

  /// Of the conditions with one value, and of a single value minimised.
  void tell_slopes(const SearchSlopes& slopes, const SearchValues& values) {
    if (slopes.equal.cols() == 0) return;
    Index equal = 0, least = 0;
    for (std::size_t i = 0; i < seek_.until.size(); ++i) {
      const SeekCondition& condition = seek_.until[i];
      const bool is_equal = condition.relation == SeekRelation::equals;
      const double sign = condition.relation == SeekRelation::at_most ? -1.0 : 1.0;
      const std::size_t count = goal_values(history_.points().front(), condition.result).size();
      if (count == 1) {
        put_slope(results_.goals[i],
                  sign * scales_[i] * (is_equal ? slopes.equal.row(equal) : slopes.least.row(least)));
      }
      (is_equal ? equal : least) += static_cast<Index>(count);
    }
    if (seek_.minimise.empty() || spread_ || values.aim.size() == 0) return;
    Index largest = 0;
    values.aim.maxCoeff(&largest);
    put_slope(results_.goals.back(), aim_scale_ * slopes.aim.row(largest));
  }

  void put_slope(SeekGoal& goal, const VectorXd& row) const {
    for (Index i = 0; i < row.size(); ++i) {
      const SeekUnknown& u = results_.unknowns[static_cast<std::size_t>(i)];
      goal.slope.push_back(row(i) / (u.to - u.from));
    }
  }

  std::string why_not() const {
    std::string why = fmt::format(
        "no values within the bounds were found with which all conditions hold: neither from the model's own values "
        "nor "
        "from the {} best of {} places over the bounds (corners, middle and Latin hypercube",
        begun_again_, looked_at_);
    if (without_values_ > 0) why += fmt::format("; {} of them have no equilibrium", without_values_);
    why += "); at the nearest place found";
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
  std::string along_;             ///< See SeekStages::largest_along.
  VectorXd own_;                  ///< The model's own values, scaled.
  bool to_own_ = false;           ///< The aim is the least change of the keys: where the search begins elsewhere.
  bool conditions_only_ = false;  ///< Nothing is minimised.
  SearchSlopes last_slopes_;
  std::size_t looked_at_ = 0, without_values_ = 0, begun_again_ = 0;  ///< Places over the bounds.
};

}  // namespace

SeekOutcome seek_many(const SeekModel& model, const SeekDescription& seek) {
  return ManyKeys(model, seek).run();
}

}  // namespace overbend
