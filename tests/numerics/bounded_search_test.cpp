#include "numerics/bounded_search.h"

#include <gtest/gtest.h>

#include <cmath>

namespace overbend {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

VectorXd of(std::initializer_list<double> values) {
  VectorXd v(static_cast<Eigen::Index>(values.size()));
  Eigen::Index i = 0;
  for (const double value : values) v(i++) = value;
  return v;
}

/// Derivatives by central differences.
SearchProblem with_slopes(SearchProblem problem) {
  problem.slopes = [values = problem.values](const VectorXd& x, const SearchValues& search_values) {
    SearchSlopes slopes{MatrixXd(search_values.equal.size(), x.size()),
                        MatrixXd(search_values.inequality.size(), x.size()),
                        MatrixXd(search_values.objective.size(), x.size())};
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const VectorXd h = VectorXd::Unit(x.size(), i) * 1e-6;
      const SearchValues a = *values(x + h), b = *values(x - h);
      slopes.equal.col(i) = (a.equal - b.equal) / 2e-6;
      slopes.inequality.col(i) = (a.inequality - b.inequality) / 2e-6;
      slopes.objective.col(i) = (a.objective - b.objective) / 2e-6;
    }
    return slopes;
  };
  return problem;
}

TEST(bounded_search, meets_as_many_equations_as_there_are_unknowns) {
  SearchProblem problem;
  problem.start = of({0.9, 0.1});
  problem.values = [](const VectorXd& x) {
    return SearchValues{of({x(0) * x(0) + x(1) * x(1) - 0.25, x(1) - x(0) * x(0)}), {}, {}};
  };
  const SearchResult end = bounded_search(with_slopes(problem)).value();
  EXPECT_TRUE(end.met);
  // y + y^2 = 1/4
  const double y = 0.5 * (std::sqrt(2.0) - 1.0);
  EXPECT_NEAR(end.x(1), y, 1e-6);
  EXPECT_NEAR(end.x(0), std::sqrt(y), 1e-6);
}

/// If unknowns are scaled by wide bounds, a step that closes a condition may be shorter than any that is worth
/// taking for an aim.
TEST(bounded_search, closes_a_condition_however_short_the_last_step_is) {
  SearchProblem problem;
  problem.start = of({0.3 + 4e-7});
  problem.values = [](const VectorXd& x) { return SearchValues{of({1e4 * (x(0) * x(0) - 0.09)}), {}, {}}; };
  const SearchResult end = bounded_search(with_slopes(problem)).value();
  EXPECT_TRUE(end.met) << end.violation;
  EXPECT_NEAR(end.x(0), 0.3, 1e-9);
}

TEST(bounded_search, takes_the_shortest_way_where_unknowns_are_left_over) {
  SearchProblem problem;
  problem.start = of({0.2, 0.2});
  problem.values = [](const VectorXd& x) { return SearchValues{of({x(0) + 3.0 * x(1) - 1.8}), {}, {}}; };
  const SearchResult end = bounded_search(with_slopes(problem)).value();
  EXPECT_TRUE(end.met);
  EXPECT_NEAR(end.x(0), 0.3, 1e-6);  // foot of the perpendicular from the start
  EXPECT_NEAR(end.x(1), 0.5, 1e-6);
}

TEST(bounded_search, stops_at_bounds_and_says_that_a_condition_is_out_of_reach) {
  SearchProblem problem;
  problem.start = of({0.5});
  problem.values = [](const VectorXd& x) { return SearchValues{of({x(0) - 1.5}), {}, {}}; };
  const SearchResult end = bounded_search(with_slopes(problem)).value();
  EXPECT_FALSE(end.met);
  EXPECT_NEAR(end.x(0), 1.0, 1e-6);
  EXPECT_NEAR(end.violation, 0.5, 1e-6);
}

TEST(bounded_search, keeps_conditions_while_it_minimises_a_value) {
  // The lowest point of a slope over a disc: Lagrange gives (0.5, 0.5) - 0.3 (1, 2) / sqrt 5.
  SearchProblem problem;
  problem.start = of({0.5, 0.5});
  problem.linear_objective = true;
  problem.settled = 1e-7;
  problem.steps = 60;
  problem.values = [](const VectorXd& x) {
    return SearchValues{{}, of({0.09 - (x - Vector2d(0.5, 0.5)).squaredNorm()}), of({x(0) + 2.0 * x(1)})};
  };
  const SearchResult end = bounded_search(with_slopes(problem)).value();
  EXPECT_TRUE(end.met);
  EXPECT_NEAR(end.values.objective(0), 1.5 - 0.3 * std::sqrt(5.0),
              2e-5);  // flat along the rim: the value is what settles
}

TEST(bounded_search, finds_the_least_squares_on_an_equation) {
  // Nearest of the line x + y = 0.8 to (0.1, 0.3): (0.3, 0.5).
  SearchProblem problem;
  problem.start = of({0.9, 0.9});
  problem.values = [](const VectorXd& x) {
    return SearchValues{of({x(0) + x(1) - 0.8}), {}, of({x(0) - 0.1, x(1) - 0.3})};
  };
  const SearchResult end = bounded_search(with_slopes(problem)).value();
  EXPECT_TRUE(end.met);
  EXPECT_NEAR(end.x(0), 0.3, 1e-6);
  EXPECT_NEAR(end.x(1), 0.5, 1e-6);
}

TEST(bounded_search, goes_around_where_there_are_no_values) {
  SearchProblem problem;
  problem.start = of({0.1});
  problem.values = [](const VectorXd& x) -> std::optional<SearchValues> {
    if (x(0) > 0.6) return std::nullopt;
    return SearchValues{of({x(0) * x(0) - 0.25}), {}, {}};
  };
  const SearchResult end = bounded_search(with_slopes(problem)).value();
  EXPECT_TRUE(end.met);
  EXPECT_NEAR(end.x(0), 0.5, 1e-6);
}

/// Charalambous and Bandler (1976), problem 2: the largest of three functions is least where two of them meet.
TEST(bounded_search, makes_the_largest_of_several_values_small) {
  SearchProblem problem;
  problem.linear_objective = true;
  problem.settled = 1e-8;
  problem.values = [](const VectorXd& x) {
    const double a = 2.0 * x(0), b = 2.0 * x(1);
    const double first = a * a + std::pow(b, 4), second = 2.0 * std::exp(b - a),
                 third = (2.0 - a) * (2.0 - a) + (2.0 - b) * (2.0 - b);
    return SearchValues{{}, {}, of({first, second, third})};
  };
  for (const auto& start : {of({0.5, 0.05}), of({0.9, 0.9}), of({0.1, 0.6})}) {
    problem.start = start;
    const SearchResult end = bounded_search(with_slopes(problem)).value();
    EXPECT_NEAR(end.values.objective.maxCoeff(), 1.952224, 1e-5);
    EXPECT_NEAR(2.0 * end.x(0), 1.139038, 1e-2);
    EXPECT_NEAR(2.0 * end.x(1), 0.899560, 1e-2);
  }
}

/// On the circle x^2 + y^2 = 1/4 the larger of the two coordinates is least where they are the same.
TEST(bounded_search, makes_the_largest_of_several_values_small_under_a_condition) {
  SearchProblem problem;
  problem.linear_objective = true;
  problem.settled = 1e-8;
  problem.values = [](const VectorXd& x) {
    return SearchValues{of({x(0) * x(0) + x(1) * x(1) - 0.25}), {}, of({x(0), 0.0, x(1)})};
  };
  problem.start = of({0.48, 0.1});
  const SearchResult end = bounded_search(with_slopes(problem)).value();
  EXPECT_TRUE(end.met);
  EXPECT_NEAR(end.x(0), std::sqrt(0.125), 1e-6);
  EXPECT_NEAR(end.x(1), std::sqrt(0.125), 1e-6);
}

}  // namespace
}  // namespace overbend
