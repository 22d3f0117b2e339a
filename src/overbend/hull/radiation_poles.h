/// Decay rates and frequencies of a retardation function from its samples.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace overbend {

/// The block Hankel matrix of a kernel's samples, decomposed once, from which poles of every order follow [kung1978,
/// kristiansen2005].
class HankelRealization {
 public:
  /// `kernel`: symmetric m x m samples at 0, interval, 2 interval ..., an odd number; orders up to `most` will be
  /// asked.
  HankelRealization(const std::vector<Eigen::MatrixXd>& kernel, double interval, int most);

  /// Poles [1/s] of the realization of this order with imaginary part 0 or more, one of each conjugate pair. Those
  /// beyond 0.95 of Nyquist's frequency are dropped, slower decay than `slowest` [1/s] is made so.
  std::vector<std::complex<double>> poles(int order, double slowest) const;

 private:
  double interval_;
  Eigen::MatrixXd transition_;  ///< State matrix over one interval; leading blocks are those of lower orders.
};

/// Functions of frequency that a sum over common poles shall represent.
struct FrequencyResponse {
  std::vector<double> omega;  ///< [rad/s]
  Eigen::MatrixXcd values;    ///< Column by column a function, at each frequency.
  Eigen::MatrixXd weights;    ///< Of each value in least squares.
};

/// One round of vector fitting [gustavsen1999]: poles nearer to those of the response. Unstable ones are mirrored.
std::vector<std::complex<double>> relocate_poles(const FrequencyResponse& response,
                                                 const std::vector<std::complex<double>>& poles, double slowest);

}  // namespace overbend
