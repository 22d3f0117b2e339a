/// Retardation functions of a group of coupled modes as sums of decaying exponentials that radiate, never feed.
#pragma once

#include <complex>
#include <vector>

#include <Eigen/Core>

namespace overbend {

/// What one group of m coupled modes is fitted to, scaled: kernel and damping have peaks of about one on the diagonal.
struct FitTarget {
  double interval = 0.0;                 ///< Of the kernel's samples [s].
  std::vector<Eigen::MatrixXd> kernel;   ///< m x m, symmetric, an odd number of samples; / sqrt(K_ii(0) K_jj(0)).
  std::vector<double> omega;             ///< Ascending, above zero; far beyond the peak of the damping [rad/s].
  std::vector<Eigen::MatrixXd> damping;  ///< m x m, in the units of `kernel` times s.
  /// A - A_inf, in the units of `damping` times s.
  std::vector<Eigen::MatrixXd> mass;
  double low_to = 0.0;                ///< Up to here frequencies are those of slow motions [rad/s].
  std::vector<double> checked_omega;  ///< Where passivity is asked for [rad/s].
};

/// K(t) = sum of Re(residue exp(pole t)).
struct GroupFit {
  std::vector<std::complex<double>> poles;
  std::vector<Eigen::MatrixXcd> residues;  ///< Symmetric m x m.
  int rounds = 0;                          ///< That passivity took.
  /// Smallest eigenvalue of the fitted damping, share of the largest damping of each mode, and where.
  double least_damping = 0.0, least_damping_omega = 0.0;
};

/// Poles nearer to the target's by rounds of vector fitting on damping and added mass.
std::vector<std::complex<double>> improve_poles(const FitTarget& target, std::vector<std::complex<double>> poles,
                                                double slowest);

/// Residues for given poles: least squares on damping and kernel with no damping at zero frequency; then under
/// inequalities that ask for positive damping along the eigenvectors where it was negative, up to 40 rounds.
GroupFit fit_residues(const FitTarget& target, const std::vector<std::complex<double>>& poles);

/// Transform of the fitted kernel, integral of K exp(-i omega t): damping + i omega (A - A_inf).
Eigen::MatrixXcd transform_of(const GroupFit& fit, double omega);

}  // namespace overbend
