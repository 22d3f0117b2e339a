#include "base/dense_algebra.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>

namespace overbend {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd least_squares(const MatrixXd& a, const VectorXd& b) {
  return a.colPivHouseholderQr().solve(b);
}

VectorXd min_norm_solution(const MatrixXd& a, const VectorXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

MatrixXd qr_triangle(const MatrixXd& rows) {
  const Eigen::HouseholderQR<MatrixXd> qr(rows);
  return qr.matrixQR().topRows(std::min(rows.rows(), rows.cols())).triangularView<Eigen::Upper>();
}

MatrixXd directions_across(const VectorXd& v) {
  const Eigen::HouseholderQR<MatrixXd> qr{MatrixXd(v)};
  const MatrixXd q = qr.householderQ();
  return q.rightCols(q.cols() - 1);
}

MatrixXd upper_root(const MatrixXd& positive) {
  return positive.llt().matrixU();
}

SymmetricModes symmetric_modes(const MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

SymmetricModes symmetric_modes(const MatrixXd& stiffness, const MatrixXd& mass) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(stiffness, mass);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXcd compute_eigenvalues(const MatrixXd& matrix) {
  return Eigen::EigenSolver<MatrixXd>(matrix, false).eigenvalues();
}

}  // namespace overbend
