/// Decompositions of small dense matrices, by Eigen. Its templates are instantiated here alone: each of them costs the
/// compiler seconds, wherever it is used.
#pragma once

#include <Eigen/Core>

namespace overbend {

/// x with the least |a x - b| (QR with column pivoting, Golub & Van Loan 2013, section 5.5); where columns depend on
/// each other, one such x. `a` is m x n with m >= n, `b` m long.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Of all x with the least |a x - b| the shortest; `a` of any shape (complete orthogonal decomposition, ibid.).
Eigen::VectorXd shortest_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Upper triangle of the orthogonal factorisation Q R of m x n `rows`: min(m, n) x n, zero below the diagonal. Signs of
/// its rows are whichever. With a right-hand side as last column it stands for all rows of a least-squares problem.
Eigen::MatrixXd triangle_of(const Eigen::MatrixXd& rows);

/// n - 1 unit vectors across `v`, which is n long, and across each other: n x (n - 1).
Eigen::MatrixXd directions_across(const Eigen::VectorXd& v);

/// Upper triangle u of a positive definite symmetric matrix u^T u (Cholesky).
Eigen::MatrixXd upper_root(const Eigen::MatrixXd& positive);

/// Eigenvalues in rising order and, column by column, the vectors that go with them.
struct SymmetricModes {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

/// Of a symmetric matrix, whose lower triangle is read; vectors of length 1, across each other.
SymmetricModes symmetric_modes(const Eigen::MatrixXd& matrix);

/// stiffness v = value mass v, both symmetric and `mass` positive definite; vectors with v^T mass v = 1.
SymmetricModes symmetric_modes(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& mass);

/// Eigenvalues of any square real matrix, in no order; complex ones come in conjugate pairs.
Eigen::VectorXcd eigenvalues_of(const Eigen::MatrixXd& matrix);

}  // namespace overbend
