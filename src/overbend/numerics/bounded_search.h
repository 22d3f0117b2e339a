/// Bound-constrained nonlinear programming (SQP) for a few unknowns.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace overbend {

/// Values of constraints and objective for given unknowns.
struct SearchValues {
  Eigen::VectorXd equal;       ///< Equality constraints: zero when met.
  Eigen::VectorXd inequality;  ///< Inequality constraints: not below zero when met.
  Eigen::VectorXd objective;   ///< Objective: the sum of squares is minimised, with `linear_objective` the maximum.
};

/// Derivatives of SearchValues, a column per unknown.
struct SearchSlopes {
  Eigen::MatrixXd equal, inequality, objective;
};

struct SearchProblem {
  Eigen::VectorXd start;          ///< Initial unknowns, scaled: each lies between 0 and 1.
  bool linear_objective = false;  ///< True to minimise the maximum of `aim`, whose curvature is unknown.
  /// Returns the values, or nothing where the unknowns have none.
  std::function<std::optional<SearchValues>(const Eigen::VectorXd&)> values;
  std::function<SearchSlopes(const Eigen::VectorXd&, const SearchValues&)> slopes;
  double tolerance = 1e-6;  ///< Tolerance of the constraints, in their own scale.
  double settled = 1e-3;    ///< Relative gain of the objective, or length of a step, that ends the search.
  int steps = 30;           ///< Maximum number of steps.
};

/// Returns the maximum violation of the constraints, in their own scale.
double compute_violation(const SearchValues& values);

struct SearchResult {
  Eigen::VectorXd x;
  SearchValues values;
  double violation = 0.0;  ///< Maximum violation of the constraints.
  bool met = false;        ///< True if every constraint is met.
  bool settled = false;    ///< True if no step improves the result; false if the steps ran out.
  int steps = 0;
};

/// Sequential quadratic programming with a trust region (Nocedal & Wright 2006, chapter 18): every step minimises the
/// quadratic model of the objective subject to linearised constraints and bounds, by Gauss-Newton for squares and with
/// the Broyden-Fletcher-Goldfarb-Shanno update for a linear objective; it is shortened until the sum of objective and
/// weighted violations decreases. The maximum of several values is minimised as an additional unknown that bounds all
/// of them; values adjacent in order are taken as samples of a curve, whose peaks bound the step. Without an objective
/// the step is the shortest one that meets the constraints. Returns nothing if the start has no values.
std::optional<SearchResult> bounded_search(const SearchProblem& problem);

}  // namespace overbend
