#include "numerics/bordered_system.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "support/allocation_count.h"
#include "support/isas.h"

namespace overbend {
namespace {

/// A bordered system, the same as a dense matrix, and right-hand sides in the order lines, border.
struct Twin {
  BorderedSystem system;
  std::vector<BorderedLine> lines;
  int unknowns = 0;
  Eigen::MatrixXd matrix;
  Eigen::VectorXd rhs;

  int first_line_unknown(int line) const {
    int first = 0;
    for (int i = 0; i < line; ++i) {
      first += 6 * lines[static_cast<std::size_t>(i)].nodes;
    }
    return first;
  }
  int border() const { return first_line_unknown(static_cast<int>(lines.size())); }
};

using Normal = std::normal_distribution<double>;

void add_random_blocks(Twin& twin, int line, int first, std::mt19937_64& generator) {
  Normal normal;
  const int nodes = twin.lines[static_cast<std::size_t>(line)].nodes;
  BlockTridiagonal& blocks = twin.system.line(line);
  for (int n = first; n < nodes; ++n) {
    const int index = twin.first_line_unknown(line) + 6 * n;
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {  // heavy across the diagonal, so that rows are exchanged
        blocks.diag(n)[i * kRowWidth + j] = twin.matrix(index + i, index + j) =
            normal(generator) + (i + j == 5 ? 9.0 : 0.0);
        if (n + 1 < nodes) {
          blocks.upper(n)[i * kRowWidth + j] = twin.matrix(index + i, index + 6 + j) = normal(generator);
          blocks.lower(n)[i * kRowWidth + j] = twin.matrix(index + 6 + i, index + j) = normal(generator);
        }
      }
    }
  }
}

/// Border rows at about one node in four from `first` on, columns and rows at nodes of their own.
void add_random_border(Twin& twin, int line, int first, std::mt19937_64& generator) {
  Normal normal;
  const BorderedLine& shape = twin.lines[static_cast<std::size_t>(line)];
  const int start = twin.first_line_unknown(line);
  for (int n = first; n < shape.nodes; ++n) {
    for (int i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < shape.unknowns.size(); ++j) {
        const int column = twin.border() + shape.unknowns[j];
        const std::size_t entry = static_cast<std::size_t>(i * twin.system.stride(line)) + j;
        if (n % 4 == 1) {
          twin.matrix(start + 6 * n + i, column) = twin.system.columns(line, n)[entry] = normal(generator);
        }
        if (n % 4 == 3 || n == shape.nodes - 1) {
          twin.matrix(column, start + 6 * n + i) = twin.system.rows(line, n)[entry] = normal(generator);
        }
      }
    }
  }
}

Twin random_twin(const std::vector<BorderedLine>& lines, int unknowns, Isa isa, unsigned seed = 5) {
  std::mt19937_64 generator(seed);
  Normal normal;
  Twin twin{BorderedSystem(lines, unknowns, isa), lines, unknowns, {}, {}};
  const int size = twin.border() + unknowns;
  twin.matrix.setZero(size, size);
  twin.rhs = Eigen::VectorXd::NullaryExpr(size, [&] { return normal(generator); });
  for (int i = 0; i < static_cast<int>(lines.size()); ++i) {
    add_random_blocks(twin, i, 0, generator);
    add_random_border(twin, i, 0, generator);
  }
  for (int i = 0; i < unknowns; ++i) {
    for (int j = 0; j < unknowns; ++j) {
      twin.system.corner(i, j) = twin.matrix(twin.border() + i, twin.border() + j) = normal(generator);
    }
  }
  return twin;
}

std::vector<int> all_of(int unknowns) {
  std::vector<int> all(static_cast<std::size_t>(unknowns));
  for (int i = 0; i < unknowns; ++i) {
    all[static_cast<std::size_t>(i)] = i;
  }
  return all;
}

/// Pointers to the parts of a vector that belong to the lines.
std::vector<double*> parts(const Twin& twin, Eigen::VectorXd& x) {
  std::vector<double*> parts;
  for (int i = 0; i < static_cast<int>(twin.lines.size()); ++i) {
    parts.push_back(x.data() + twin.first_line_unknown(i));
  }
  return parts;
}

Eigen::VectorXd solved(Twin& twin, const Eigen::VectorXd& rhs) {
  Eigen::VectorXd x = rhs;
  twin.system.solve(parts(twin, x), x.data() + twin.border());
  return x;
}

void expect_as_dense(const Twin& twin, const Eigen::VectorXd& x, const Eigen::VectorXd& rhs) {
  const Eigen::VectorXd expected = twin.matrix.fullPivLu().solve(rhs);
  EXPECT_LT((x - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.cwiseAbs().maxCoeff());  // rounding
}

class bordered_system_of_any_width : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(bordered_system, bordered_system_of_any_width,
                         ::testing::Values(0, 1, 2, 6, 7, 8, 9, 16, 17, 40), ::testing::PrintToStringParamName());

TEST_P(bordered_system_of_any_width, solves_what_a_dense_solver_solves_on_every_instruction_set) {
  for (const Isa isa : available_isas()) {
    Twin twin = random_twin({{30, all_of(GetParam())}}, GetParam(), isa);
    ASSERT_TRUE(twin.system.factor().solved());
    expect_as_dense(twin, solved(twin, twin.rhs), twin.rhs);
    const Eigen::VectorXd second = Eigen::VectorXd::LinSpaced(twin.rhs.size(), -1.0, 2.0);
    expect_as_dense(twin, solved(twin, second), second);
  }
}

TEST_P(bordered_system_of_any_width, factors_and_solves_in_one) {
  for (const Isa isa : available_isas()) {
    Twin twin = random_twin({{30, all_of(GetParam())}}, GetParam(), isa);
    Eigen::VectorXd x = twin.rhs;
    ASSERT_TRUE(twin.system.factor_and_solve(parts(twin, x), x.data() + twin.border()).solved());
    expect_as_dense(twin, x, twin.rhs);
    const Eigen::VectorXd second = Eigen::VectorXd::LinSpaced(twin.rhs.size(), -1.0, 2.0);
    expect_as_dense(twin, solved(twin, second), second);  // the factors serve on
  }
}

/// A pipe, mooring lines down to one of a single node, one that knows no shared unknown; each touches its own.
std::vector<BorderedLine> lines_of_a_barge() {
  return {{60, {0, 1, 2, 3, 4, 5, 6}}, {20, {0, 1, 2, 3, 4, 5, 7}}, {1, {2, 8}}, {2, {}}, {7, {0, 1, 2, 3, 4, 5, 9}}};
}

TEST(bordered_system, couples_lines_of_very_different_lengths) {
  for (const Isa isa : available_isas()) {
    Twin twin = random_twin(lines_of_a_barge(), 10, isa);
    ASSERT_TRUE(twin.system.factor().solved());
    expect_as_dense(twin, solved(twin, twin.rhs), twin.rhs);
  }
}

TEST(bordered_system, factors_one_line_anew_from_where_it_changed_to_the_same_bits) {
  for (const Isa isa : available_isas()) {
    Twin twin = random_twin(lines_of_a_barge(), 10, isa);
    ASSERT_TRUE(twin.system.factor().solved());
    for (const int line : {0, 4}) {  // changed and changed back
      constexpr int kFirst = 3;
      for (const unsigned seed : {77U, 5U}) {
        Twin second_twin = random_twin(lines_of_a_barge(), 10, isa, seed);
        const int index = twin.first_line_unknown(line) + 6 * kFirst,
                  rest = 6 * (twin.lines[static_cast<std::size_t>(line)].nodes - kFirst);
        twin.matrix.block(index, index, rest, rest) = second_twin.matrix.block(index, index, rest, rest);
        twin.system.line(line).copy_from(second_twin.system.line(line), kFirst);
        ASSERT_TRUE(twin.system.factor_line(line, kFirst).solved());
        ASSERT_EQ(twin.system.close(), -1);
        expect_as_dense(twin, solved(twin, twin.rhs), twin.rhs);
      }
    }
    Twin fresh = random_twin(lines_of_a_barge(), 10, isa);
    ASSERT_TRUE(fresh.system.factor().solved());
    EXPECT_EQ(solved(twin, twin.rhs), solved(fresh, twin.rhs));
  }
}

TEST(bordered_system, solves_a_new_border_with_the_factors_it_has) {
  Twin twin = random_twin(lines_of_a_barge(), 10, best_isa());
  ASSERT_TRUE(twin.system.factor().solved());
  twin.system.clear_border(0);
  twin.matrix.topRightCorner(360, 10).setZero();
  twin.matrix.bottomLeftCorner(10, 360).setZero();
  std::mt19937_64 generator(9);
  add_random_border(twin, 0, 50, generator);
  twin.system.factor_border(0);
  ASSERT_EQ(twin.system.close(), -1);
  expect_as_dense(twin, solved(twin, twin.rhs), twin.rhs);
}

TEST(bordered_system, does_not_depend_on_the_order_of_assembly) {
  const auto solution = [](bool backwards) {
    Twin twin = random_twin({{30, all_of(6)}}, 6, best_isa());
    twin.system.clear_border(0);
    for (int k = 0; k < 30; ++k) {
      const int node = backwards ? 29 - k : k;
      for (int i = 0; i < 36; ++i) {
        const int entry = i / 6 * twin.system.stride(0) + i % 6;
        twin.system.columns(0, node)[entry] = std::sin(1.0 + node + 7.0 * i);
        twin.system.rows(0, node)[entry] = std::cos(2.0 + node + 5.0 * i);
      }
    }
    EXPECT_TRUE(twin.system.factor().solved());
    return solved(twin, twin.rhs);
  };
  EXPECT_EQ(solution(false), solution(true));
}

TEST(bordered_system, leaves_a_held_unknown_out) {
  Twin twin = random_twin({{12, all_of(3)}, {5, {1}}}, 3, best_isa());
  twin.system.hold(1, true);
  const int held = twin.border() + 1;
  twin.matrix.row(held).setZero();
  twin.matrix.col(held).setZero();
  twin.matrix(held, held) = 1.0;
  ASSERT_TRUE(twin.system.factor().solved());
  const Eigen::VectorXd x = solved(twin, twin.rhs);
  Eigen::VectorXd rhs = twin.rhs;
  rhs(held) = 0.0;
  expect_as_dense(twin, x, rhs);
  EXPECT_EQ(x(held), 0.0);
}

TEST(bordered_system, a_border_of_zeros_leaves_the_lines_to_themselves) {
  Twin twin = random_twin({{30, all_of(6)}}, 6, best_isa());
  twin.system.clear_border(0);
  Eigen::VectorXd alone = twin.rhs;
  Twin line = random_twin({{30, all_of(6)}}, 6, best_isa());
  ASSERT_TRUE(refactor(line.system.line(0), 0).solved());
  resolve(line.system.line(0), alone.data());
  ASSERT_TRUE(twin.system.factor().solved());
  EXPECT_EQ(solved(twin, twin.rhs).head(180), alone.head(180));
}

TEST(bordered_system, names_the_line_and_node_without_pivot) {
  Twin twin = random_twin(lines_of_a_barge(), 10, best_isa());
  for (int j = 0; j < kRowWidth; ++j) {  // node 3 of line 1 loses an equation
    twin.system.line(1).diag(3)[2 * kRowWidth + j] = 0.0;
    twin.system.line(1).upper(3)[2 * kRowWidth + j] = 0.0;
    twin.system.line(1).lower(2)[2 * kRowWidth + j] = 0.0;
  }
  const BorderedReport report = twin.system.factor();
  EXPECT_FALSE(report.solved());
  EXPECT_EQ(report.singular_line, 1);
  EXPECT_EQ(report.singular_node, 3);
}

TEST(bordered_system, names_the_shared_unknown_that_nothing_holds) {
  Twin twin = random_twin({{12, {0, 1}}}, 3, best_isa());  // no line touches unknown 2
  for (int i = 0; i < 3; ++i) {
    twin.system.corner(i, 2) = twin.system.corner(2, i) = 0.0;
  }
  EXPECT_EQ(twin.system.factor().singular_unknown, 2);
}

TEST(bordered_system, a_body_held_by_nothing_but_rounding_is_singular) {
  // A node on a spring of 1e9 N/m to a body that nothing else holds: the Schur complement is 1e9 - 1e9.
  BorderedSystem system({{1, {0}}}, 1);
  for (int i = 0; i < 6; ++i) {
    system.line(0).diag(0)[i * kRowWidth + i] = 1e9 / 3.0;
  }
  system.columns(0, 0)[0] = system.rows(0, 0)[0] = -1e9 / 3.0;
  system.corner(0, 0) = 1e9 / 3.0;
  EXPECT_EQ(system.factor().singular_unknown, 0);
}

TEST(bordered_system, does_not_mind_mixed_units) {
  Twin twin = random_twin({{12, all_of(4)}}, 4, best_isa());
  const Eigen::Vector4d unit(1.0, 1e9, 1e-7, 1e4);
  for (int j = 0; j < 4; ++j) {
    for (int n = 0; n < 12; ++n) {
      for (int i = 0; i < 6; ++i) {
        twin.system.columns(0, n)[i * twin.system.stride(0) + j] *= unit(j);
        twin.system.rows(0, n)[i * twin.system.stride(0) + j] *= unit(j);
      }
    }
    for (int i = 0; i < 4; ++i) {
      twin.system.corner(i, j) *= unit(i) * unit(j);
    }
  }
  ASSERT_TRUE(twin.system.factor().solved());
  Eigen::VectorXd rhs = twin.rhs;
  rhs.tail(4).array() *= unit.array();
  Eigen::VectorXd x = solved(twin, rhs);
  x.tail(4).array() *= unit.array();
  expect_as_dense(twin, x, twin.rhs);
}

TEST(bordered_system, counts_negative_blocks_and_the_sign_of_the_border) {
  BorderedSystem system({{3, {0}}, {2, {0}}}, 1);
  for (int line = 0; line < 2; ++line) {
    for (int n = 0; n < system.line(line).nodes(); ++n) {
      for (int i = 0; i < 6; ++i) {
        system.line(line).diag(n)[i * kRowWidth + i] = n == 1 && i == 0 ? -2.0 : 2.0;
      }
    }
  }
  system.corner(0, 0) = -1.0;
  const BorderedReport report = system.factor();
  EXPECT_EQ(report.negative_blocks, 2);
  EXPECT_TRUE(report.negative_border);
}

TEST(bordered_system, asks_for_no_memory_once_it_is_made) {
  Twin twin = random_twin(lines_of_a_barge(), 10, best_isa());
  const BorderedSystem assembled = twin.system;
  Eigen::VectorXd x = twin.rhs;
  const std::vector<double*> lines = parts(twin, x);
  const long before = testing::allocation_count();
  for (int i = 0; i < 2; ++i) {
    twin.system.set_zero();
    for (int line = 0; line < twin.system.lines(); ++line) {
      twin.system.line(line).copy_from(assembled.line(line), 0);
    }
    twin.system.columns(0, 7)[0] = twin.system.rows(0, 9)[0] = 1.0;
    for (int j = 0; j < 10; ++j) {
      twin.system.corner(j, j) = 1.0;
    }
    const bool solved = twin.system.factor().solved();
    twin.system.solve(lines, x.data() + twin.border());
    EXPECT_TRUE(solved);
  }
  EXPECT_EQ(testing::allocation_count() - before, 0);
}

TEST(bordered_system, adds_the_border_of_an_element_to_both_of_its_nodes) {
  BorderedSystem system({{4, {0, 1}}}, 2);
  Eigen::Matrix<double, 12, 2> b;
  for (int i = 0; i < 24; ++i) {
    b(i / 2, i % 2) = i;
  }
  add_border_columns(system, 0, 1, b);
  add_border_rows(system, 0, 1, b.transpose());
  EXPECT_EQ(system.columns(0, 1)[3 * system.stride(0) + 1], b(3, 1));
  EXPECT_EQ(system.columns(0, 2)[5 * system.stride(0)], b(11, 0));
  EXPECT_EQ(system.rows(0, 2)[5 * system.stride(0)], b(11, 0));
}

}  // namespace
}  // namespace overbend
