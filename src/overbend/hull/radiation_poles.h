/// Poles of a retardation function from its samples.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace overbend {

/// Block Hankel matrix of a kernel's samples, decomposed once, from which poles of any order follow [kung1978,
/// kristiansen2005].
class HankelRealization {
 public:
  /// `kernel`: symmetric m x m samples at 0, interval, 2 interval ..., an odd number; `max_order`: maximum order of
  /// later calls.
  HankelRealization(const std::vector<Eigen::MatrixXd>& kernel, double interval, int max_order);

  /// Returns the poles [1/s] of the realization of this order with imaginary part 0 or more, one of each conjugate
  /// pair. Poles beyond 0.95 of the Nyquist frequency are dropped, decay slower than `slowest` [1/s] is set to it.
  std::vector<std::complex<double>> poles(int order, double slowest) const;

 private:
  double interval_;
  Eigen::MatrixXd transition_;  ///< State matrix over one interval; leading blocks are those of lower orders.
};

/// Functions of frequency to be represented by a sum over common poles.
struct FrequencyResponse {
  std::vector<double> omega;  ///< [rad/s]
  Eigen::MatrixXcd values;    ///< One function per column, at each frequency.
  Eigen::MatrixXd weights;    ///< Least-squares weights of the values.
};

/// Returns poles closer to those of the response by one iteration of vector fitting [gustavsen1999]. Unstable poles are
/// mirrored.
std::vector<std::complex<double>> relocate_poles(const FrequencyResponse& response,
                                                 const std::vector<std::complex<double>>& poles, double slowest);

}  // namespace overbend
