#include "hull/radiation_poles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/dense_algebra.h"

namespace overbend {
namespace {

/// Block Hankel matrix: blocks kernel[first + i + j].
Eigen::MatrixXd block_hankel(const std::vector<Eigen::MatrixXd>& kernel, Eigen::Index blocks, Eigen::Index first) {
  const Eigen::Index m = kernel[0].rows();
  Eigen::MatrixXd hankel(blocks * m, blocks * m);
  for (Eigen::Index i = 0; i < blocks; ++i) {
    for (Eigen::Index j = 0; j < blocks; ++j) {
      hankel.block(i * m, j * m, m, m) = kernel[static_cast<std::size_t>(first + i + j)];
    }
  }
  return hankel;
}

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Partial fractions of unit coefficients at each frequency: one of a real pole, two of a complex pair.
Eigen::MatrixXcd fractions(const std::vector<Complex>& poles, const std::vector<double>& omega) {
  std::vector<Eigen::VectorXcd> columns;
  const Complex i(0.0, 1.0);
  for (const Complex& pole : poles) {
    Eigen::VectorXcd first(static_cast<Index>(omega.size())), second(first.size());
    for (std::size_t k = 0; k < omega.size(); ++k) {
      const Complex direct = 1.0 / (i * omega[k] - pole), conjugate = 1.0 / (i * omega[k] - std::conj(pole));
      first(static_cast<Index>(k)) = pole.imag() > 0.0 ? direct + conjugate : direct;
      second(static_cast<Index>(k)) = i * direct - i * conjugate;
    }
    columns.push_back(first);
    if (pole.imag() > 0.0) {
      columns.push_back(second);
    }
  }
  Eigen::MatrixXcd result(static_cast<Index>(omega.size()), static_cast<Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) {
    result.col(static_cast<Index>(k)) = columns[k];
  }
  return result;
}

/// Real and imaginary parts as separate rows.
MatrixXd stacked(const Eigen::MatrixXcd& m) {
  MatrixXd result(2 * m.rows(), m.cols());
  result << m.real(), m.imag();
  return result;
}

/// Zeros of 1 + sum of coefficients times fractions.
Eigen::VectorXcd zeros(const std::vector<Complex>& poles, const VectorXd& coefficients) {
  MatrixXd a = MatrixXd::Zero(coefficients.size(), coefficients.size());
  VectorXd b = VectorXd::Zero(coefficients.size());
  Index k = 0;
  for (const Complex& pole : poles) {
    if (pole.imag() > 0.0) {
      a.block<2, 2>(k, k) << pole.real(), pole.imag(), -pole.imag(), pole.real();
      b(k) = 2.0;
      k += 2;
    } else {
      a(k, k) = pole.real();
      b(k++) = 1.0;
    }
  }
  return compute_eigenvalues(a - b * coefficients.transpose());
}

/// Separates real poles that were limited to the slowest decay, where their partial fractions would coincide and
/// rounding would decide: from the second on, each decays 1.5 times as fast as the previous one.
void separate_slowest(std::vector<Complex>& poles, double slowest) {
  constexpr double kApart = 1.5, kSame = 1.0 + 1e-9;
  double decay = slowest;
  for (Complex& pole : poles) {
    if (pole.imag() != 0.0 || -pole.real() > kSame * slowest) continue;
    pole = -decay;
    decay *= kApart;
  }
}

}  // namespace

// Symmetric samples make a symmetric matrix: its singular values and vectors are its eigenvalues and vectors with the
// sign moved to one side, H = U S V^T with V = U sign. The state matrix is S^-1/2 U^T H' V S^-1/2, with H' shifted by
// one.
HankelRealization::HankelRealization(const std::vector<Eigen::MatrixXd>& kernel, double interval, int max_order)
    : interval_(interval) {
  const auto blocks = static_cast<Eigen::Index>((kernel.size() - 1) / 2);
  const SymmetricModes modes = symmetric_modes(block_hankel(kernel, blocks, 0));
  const Eigen::VectorXd& values = modes.values;
  std::vector<Eigen::Index> order(static_cast<std::size_t>(values.size()));
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = static_cast<Eigen::Index>(i);
  }
  std::sort(order.begin(), order.end(),
            [&](Eigen::Index a, Eigen::Index b) { return std::abs(values(a)) > std::abs(values(b)); });
  const Eigen::Index count = std::min<Eigen::Index>(max_order, values.size());
  Eigen::MatrixXd left(values.size(), count), right(values.size(), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index index = order[static_cast<std::size_t>(k)];
    const double root = std::sqrt(std::abs(values(index)));
    const double inverse = root > 1e-12 * std::sqrt(std::abs(values(order[0]))) ? 1.0 / root : 0.0;
    left.col(k) = inverse * modes.vectors.col(index);
    right.col(k) = std::copysign(1.0, values(index)) * left.col(k);
  }
  transition_ = left.transpose() * block_hankel(kernel, blocks, 1) * right;
}

std::vector<std::complex<double>> HankelRealization::poles(int order, double slowest) const {
  const Eigen::Index n = std::min<Eigen::Index>(order, transition_.rows());
  const Eigen::VectorXcd values = compute_eigenvalues(transition_.topLeftCorner(n, n));
  const double nyquist = std::numbers::pi / interval_;
  std::vector<std::complex<double>> poles;
  for (Eigen::Index k = 0; k < n; ++k) {
    const std::complex<double> discrete = values(k);
    if (discrete.imag() < 0.0 || std::abs(discrete) < 1e-6) {
      continue;
    }
    const std::complex<double> pole = std::log(discrete) / interval_;
    if (pole.imag() < 0.95 * nyquist) {
      poles.emplace_back(std::min(pole.real(), -slowest), pole.imag());
    }
  }
  separate_slowest(poles, slowest);
  return poles;
}

std::vector<Complex> relocate_poles(const FrequencyResponse& response, const std::vector<Complex>& poles,
                                    double slowest) {
  const Eigen::MatrixXcd base = fractions(poles, response.omega);
  const Index n = base.cols(), functions = response.values.cols();
  MatrixXd rows(n * functions, n);
  VectorXd wanted(n * functions);
  for (Index e = 0; e < functions; ++e) {  // eliminate the function's own coefficients
    const auto weight = response.weights.col(e).asDiagonal();
    Eigen::MatrixXcd block(base.rows(), 2 * n + 1);
    block << weight * base, -(weight * (response.values.col(e).asDiagonal() * base)), weight * response.values.col(e);
    const MatrixXd triangle = qr_triangle(stacked(block));
    for (Index k = 0; k < n; ++k) {
      rows.row(e * n + k).setZero();
      rows.row(e * n + k).tail(n - k) = triangle.row(n + k).segment(n + k, n - k);
      wanted(e * n + k) = triangle(n + k, 2 * n);
    }
  }
  const VectorXd scale = rows.colwise().norm().cwiseMax(1e-300).cwiseInverse().transpose();
  const VectorXd coefficients = scale.cwiseProduct(least_squares(rows * scale.asDiagonal(), wanted));
  std::vector<Complex> moved;
  for (const Complex& zero : zeros(poles, coefficients)) {
    if (zero.imag() >= 0.0) {
      moved.emplace_back(std::min(-std::abs(zero.real()), -slowest), zero.imag());
    }
  }
  separate_slowest(moved, slowest);
  return moved;
}

}  // namespace overbend
