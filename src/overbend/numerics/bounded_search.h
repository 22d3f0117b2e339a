/// A few unknowns within bounds, conditions that hold, and what is to be as small as they allow.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace overbend {

/// What the unknowns lead to.
struct SearchValues {
  Eigen::VectorXd equal;  ///< To be zero.
  Eigen::VectorXd least;  ///< Not to be below zero.
  Eigen::VectorXd aim;    ///< Their sum of squares is to be small; with `linear_aim` the largest of them.
};

/// Derivatives of these, a column per unknown.
struct SearchSlopes {
  Eigen::MatrixXd equal, least, aim;
};

struct SearchProblem {
  Eigen::VectorXd start;    ///< Unknowns are scaled: each lies between 0 and 1.
  bool linear_aim = false;  ///< The largest value of `aim` counts, its curvature is not known.
  /// Nothing where the unknowns have no values.
  std::function<std::optional<SearchValues>(const Eigen::VectorXd&)> values;
  std::function<SearchSlopes(const Eigen::VectorXd&, const SearchValues&)> slopes;
  double tolerance = 1e-6;  ///< Of the conditions, in their own scale.
  double settled = 1e-3;    ///< Relative gain of the aim, or length of a step, that ends the search.
  int steps = 30;           ///< At most.
};

/// Largest violation of the conditions, in their own scale.
double violation_of(const SearchValues& values);

struct SearchEnd {
  Eigen::VectorXd x;
  SearchValues values;
  double violation = 0.0;  ///< Largest of the conditions.
  bool met = false;        ///< Every condition holds.
  bool settled = false;    ///< No step makes it better; false: the steps ran out.
  int steps = 0;
};

/// Sequential quadratic programming with a trust region (Nocedal & Wright 2006, chapter 18): every step solves the
/// linearised conditions within the bounds for the least of the aim's quadratic model, by Gauss-Newton for squares and
/// with Broyden's, Fletcher's, Goldfarb's and Shanno's update for a linear aim; it is shortened until the sum of aim
/// and weighted violations falls. Of several values the largest is made small as a further unknown that none of them
/// exceeds; neighbours in their order are taken for values of a curve, of which the peaks bound the step. Without an
/// aim the step is the shortest that meets the conditions. Nothing where the start has no values.
std::optional<SearchEnd> bounded_search(const SearchProblem& problem);

}  // namespace overbend
