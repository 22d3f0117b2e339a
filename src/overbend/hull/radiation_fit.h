/// Passive fit of the retardation functions of a group of coupled modes by sums of decaying exponentials.
#pragma once

#include <complex>
#include <vector>

#include <Eigen/Core>

namespace overbend {

/// Scaled target of the fit of one group of m coupled modes: kernel and damping have peaks of about one on the
/// diagonal.
struct FitTarget {
  double interval = 0.0;                 ///< Sample interval of the kernel [s].
  std::vector<Eigen::MatrixXd> kernel;   ///< m x m, symmetric, an odd number of samples; / sqrt(K_ii(0) K_jj(0)).
  std::vector<double> omega;             ///< Ascending, above zero; far beyond the peak of the damping [rad/s].
  std::vector<Eigen::MatrixXd> damping;  ///< m x m, in the units of `kernel` times s.
  /// A - A_inf, in the units of `damping` times s.
  std::vector<Eigen::MatrixXd> mass;
  double low_to = 0.0;                ///< Upper limit of the frequencies of low-frequency motions [rad/s].
  std::vector<double> checked_omega;  ///< Frequencies of the passivity check [rad/s].
};

/// K(t) = sum of Re(residue exp(pole t)).
struct GroupFit {
  std::vector<std::complex<double>> poles;
  std::vector<Eigen::MatrixXcd> residues;  ///< Symmetric m x m.
  int rounds = 0;                          ///< Number of passivity iterations.
  /// Minimum eigenvalue of the fitted damping, share of the maximum damping of each mode, and its frequency.
  double min_fitted_damping = 0.0, min_fitted_damping_omega = 0.0;
};

/// Returns poles closer to the target's by vector fitting iterations on damping and added mass.
std::vector<std::complex<double>> improve_poles(const FitTarget& target, std::vector<std::complex<double>> poles,
                                                double slowest);

/// Returns residues for given poles: least squares on damping and kernel with zero damping at zero frequency; then
/// under inequalities for positive damping along the eigenvectors where it was negative, in up to 40 iterations.
GroupFit fit_residues(const FitTarget& target, const std::vector<std::complex<double>>& poles);

/// Returns the transform of the fitted kernel, integral of K exp(-i omega t): damping + i omega (A - A_inf).
Eigen::MatrixXcd kernel_transform(const GroupFit& fit, double omega);

}  // namespace overbend
