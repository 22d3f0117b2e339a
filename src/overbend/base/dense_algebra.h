/// Decompositions of small dense matrices, by Eigen. Its templates are instantiated only here: each instantiation costs
/// seconds of compile time.
#pragma once

#include <Eigen/Core>

namespace overbend {

/// Returns an x that minimises |a x - b| (QR with column pivoting, Golub & Van Loan 2013, section 5.5); one of many if
/// the columns are linearly dependent. `a` is m x n with m >= n, `b` m long.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Returns the shortest x that minimises |a x - b|; `a` of any shape (complete orthogonal decomposition, ibid.).
Eigen::VectorXd min_norm_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Returns the upper triangle of the orthogonal factorisation Q R of m x n `rows`: min(m, n) x n, zero below the
/// diagonal. The signs of its rows are arbitrary. With a right-hand side as last column it represents all rows of a
/// least-squares problem.
Eigen::MatrixXd qr_triangle(const Eigen::MatrixXd& rows);

/// Returns n - 1 orthonormal vectors orthogonal to `v`, which is n long: n x (n - 1).
Eigen::MatrixXd directions_across(const Eigen::VectorXd& v);

/// Returns the upper triangle u of a positive definite symmetric matrix u^T u (Cholesky).
Eigen::MatrixXd upper_root(const Eigen::MatrixXd& positive);

/// Eigenvalues in ascending order and, column by column, the eigenvectors.
struct SymmetricModes {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

/// Returns the modes of a symmetric matrix, of which the lower triangle is read; orthonormal vectors.
SymmetricModes symmetric_modes(const Eigen::MatrixXd& matrix);

/// Solves stiffness v = value mass v, both symmetric and `mass` positive definite; vectors with v^T mass v = 1.
SymmetricModes symmetric_modes(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& mass);

/// Returns the eigenvalues of any square real matrix, unordered; complex ones are in conjugate pairs.
Eigen::VectorXcd compute_eigenvalues(const Eigen::MatrixXd& matrix);

}  // namespace overbend
