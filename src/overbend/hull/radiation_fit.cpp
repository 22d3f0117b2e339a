#include "hull/radiation_fit.h"

#include <algorithm>
#include <cmath>

#include "base/dense_algebra.h"
#include "base/interruption.h"
#include "hull/radiation_poles.h"
#include "numerics/constrained_least_squares.h"

namespace overbend {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMaxPassivityRounds = 40;
constexpr int kRelocations = 10;
/// Threshold and weight of low damping at low frequencies: a wrong sign there would affect the slow motions of a moored
/// hull.
constexpr double kSmallAtLowFrequency = 0.05, kLowWeight = 100.0;
constexpr double kKernelWeight = 0.1;  ///< Weight of a sample of K relative to one of B.
/// Damping required by an inequality, share of the maximum; less towards zero frequency, where there is none. Below
/// kNegative another inequality is added; above kPassive the fit is passive but for rounding.
constexpr double kRequiredDamping = 1e-6, kNegative = -2e-7, kPassive = -1e-6;

/// Entries of a symmetric m x m matrix, row by row of its upper triangle.
struct Pair {
  Index i, j;
};
std::vector<Pair> make_pairs(Index m) {
  std::vector<Pair> pairs;
  for (Index i = 0; i < m; ++i) {
    for (Index j = i; j < m; ++j) {
      pairs.push_back({i, j});
    }
  }
  return pairs;
}

/// Number of real coefficients of an entry: Re and Im of the residue of a complex pole, the residue of a real one.
Index coefficient_count(const std::vector<Complex>& poles) {
  Index count = 0;
  for (const Complex& pole : poles) {
    count += pole.imag() > 0.0 ? 2 : 1;
  }
  return count;
}

/// Transform of Re(c exp(p t)) at omega for c = 1 and c = i.
Complex real_part_transform(Complex pole, Complex c, double omega) {
  const Complex s(0.0, omega);
  return 0.5 * (c / (s - pole) + std::conj(c) / (s - std::conj(pole)));
}

/// Damping of unit coefficients at omega.
Eigen::RowVectorXd damping_row(const std::vector<Complex>& poles, double omega) {
  Eigen::RowVectorXd row(coefficient_count(poles));
  Index k = 0;
  for (const Complex& pole : poles) {
    row(k++) = real_part_transform(pole, 1.0, omega).real();
    if (pole.imag() > 0.0) {
      row(k++) = real_part_transform(pole, Complex(0.0, 1.0), omega).real();
    }
  }
  return row;
}

/// Kernel of unit coefficients at a time.
Eigen::RowVectorXd kernel_row(const std::vector<Complex>& poles, double time) {
  Eigen::RowVectorXd row(coefficient_count(poles));
  Index k = 0;
  for (const Complex& pole : poles) {
    const Complex value = std::exp(pole * time);
    row(k++) = value.real();
    if (pole.imag() > 0.0) {
      row(k++) = -value.imag();
    }
  }
  return row;
}

/// Maximum damping of each mode.
VectorXd damping_peaks(const FitTarget& target) {
  VectorXd peaks = VectorXd::Zero(target.damping[0].rows());
  for (const MatrixXd& b : target.damping) {
    peaks = peaks.cwiseMax(b.diagonal().cwiseAbs());
  }
  return peaks;
}

/// Weights of an entry's values by frequency: relative to the peaks, higher at low-frequency motions where the damping
/// is small compared with its peak.
VectorXd entry_weights(const FitTarget& target, const VectorXd& peaks, const Pair& pair) {
  double peak = 0.0, low = 0.0;
  for (std::size_t k = 0; k < target.omega.size(); ++k) {
    const double b = std::abs(target.damping[k](pair.i, pair.j));
    peak = std::max(peak, b);
    low = target.omega[k] <= target.low_to ? std::max(low, b) : low;
  }
  VectorXd weights =
      VectorXd::Constant(static_cast<Index>(target.omega.size()), 1.0 / std::sqrt(peaks(pair.i) * peaks(pair.j)));
  for (std::size_t k = 0; k < target.omega.size() && low < kSmallAtLowFrequency * peak; ++k) {
    weights(static_cast<Index>(k)) *= target.omega[k] <= target.low_to ? kLowWeight : 1.0;
  }
  return weights;
}

/// Least-squares problem of one group: the same rows for every entry except for weights; unknowns that keep B(0) = 0.
class ResidueProblem {
 public:
  ResidueProblem(const FitTarget& target, const std::vector<Complex>& poles)
      : target_(target), poles_(poles), peaks_(damping_peaks(target)), pairs_(make_pairs(peaks_.size())) {
    find_free_directions();
    set_rows();
    for (std::size_t e = 0; e < pairs_.size(); ++e) {
      reduce(e);
    }
    passive_rows_.resize(0, unknowns());
  }

  GroupFit solve() const {
    MatrixXd rows = MatrixXd::Zero(unknowns(), unknowns());
    VectorXd wanted(unknowns());
    for (std::size_t e = 0; e < pairs_.size(); ++e) {
      rows.block(first_unknown(e), first_unknown(e), free_.cols(), free_.cols()) = triangles_[e];
      wanted.segment(first_unknown(e), free_.cols()) = reduced_[e];
    }
    return make_fit(inequality_least_squares(rows, wanted, passive_rows_, passive_wanted_));
  }

  /// Checks for negative damping: sets the fit's minimum and adds an inequality for every dip. Returns false if it is
  /// passive.
  bool add_passivity_inequalities(GroupFit& fit) {
    const VectorXd scale = peaks_.cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const auto& omega = target_.checked_omega;
    std::vector<double> min_damping(omega.size());
    std::vector<VectorXd> direction(omega.size());
    for (std::size_t k = 0; k < omega.size(); ++k) {
      const MatrixXd damping = scale.asDiagonal() * kernel_transform(fit, omega[k]).real() * scale.asDiagonal();
      const SymmetricModes modes = symmetric_modes(damping);
      min_damping[k] = modes.values(0);
      direction[k] = scale.cwiseProduct(modes.vectors.col(0));
    }
    const std::size_t worst =
        static_cast<std::size_t>(std::min_element(min_damping.begin(), min_damping.end()) - min_damping.begin());
    fit.min_fitted_damping = min_damping[worst];
    fit.min_fitted_damping_omega = omega[worst];
    for (std::size_t k = 0; k < omega.size(); ++k) {
      const double before = k > 0 ? min_damping[k - 1] : 0.0, behind = k + 1 < omega.size() ? min_damping[k + 1] : 0.0;
      if (min_damping[k] < kNegative && min_damping[k] <= before && min_damping[k] <= behind) {
        add_passive_row(omega[k], direction[k]);
      }
    }
    return min_damping[worst] < kPassive;
  }

 private:
  Index unknowns() const { return static_cast<Index>(pairs_.size()) * free_.cols(); }
  Index first_unknown(std::size_t e) const { return static_cast<Index>(e) * free_.cols(); }

  /// Coefficients = free_ * unknowns spans all coefficients with zero damping at zero frequency.
  void find_free_directions() { free_ = directions_across(damping_row(poles_, 0.0).transpose()); }

  void set_rows() {
    const auto frequencies = static_cast<Index>(target_.omega.size()),
               times = static_cast<Index>(target_.kernel.size());
    damping_rows_.resize(frequencies, free_.cols());
    kernel_rows_.resize(times, free_.cols());
    for (Index k = 0; k < frequencies; ++k) {
      damping_rows_.row(k) = damping_row(poles_, target_.omega[static_cast<std::size_t>(k)]) * free_;
    }
    for (Index k = 0; k < times; ++k) {
      kernel_rows_.row(k) = kernel_row(poles_, static_cast<double>(k) * target_.interval) * free_;
    }
  }

  /// Reduces all rows of one entry to a triangle and a right-hand side.
  void reduce(std::size_t e) {
    const Pair& pair = pairs_[e];
    const Index frequencies = damping_rows_.rows(), times = kernel_rows_.rows();
    const VectorXd weights = entry_weights(target_, peaks_, pair);
    MatrixXd rows(frequencies + times, free_.cols() + 1);
    for (Index k = 0; k < frequencies; ++k) {
      const double wanted = target_.damping[static_cast<std::size_t>(k)](pair.i, pair.j);
      rows.row(k) << weights(k) * damping_rows_.row(k), weights(k) * wanted;
    }
    for (Index k = 0; k < times; ++k) {
      const double wanted = target_.kernel[static_cast<std::size_t>(k)](pair.i, pair.j);
      rows.row(frequencies + k) << kKernelWeight * kernel_rows_.row(k), kKernelWeight * wanted;
    }
    const MatrixXd triangle = qr_triangle(rows);
    triangles_.push_back(triangle.topLeftCorner(free_.cols(), free_.cols()));
    reduced_.push_back(triangle.topRightCorner(free_.cols(), 1));
  }

  void add_passive_row(double omega, const VectorXd& direction) {
    const Eigen::RowVectorXd damping = damping_row(poles_, omega) * free_;
    passive_rows_.conservativeResize(passive_rows_.rows() + 1, Eigen::NoChange);
    passive_wanted_.conservativeResize(passive_rows_.rows());
    for (std::size_t e = 0; e < pairs_.size(); ++e) {
      const auto [i, j] = pairs_[e];
      const double share = (i == j ? 1.0 : 2.0) * direction(i) * direction(j);
      passive_rows_.block(passive_rows_.rows() - 1, first_unknown(e), 1, free_.cols()) = share * damping;
    }
    passive_wanted_(passive_rows_.rows() - 1) = kRequiredDamping * std::pow(std::min(1.0, omega / target_.low_to), 4);
  }

  GroupFit make_fit(const VectorXd& unknown) const {
    GroupFit fit;
    fit.poles = poles_;
    fit.residues.assign(poles_.size(), Eigen::MatrixXcd::Zero(peaks_.size(), peaks_.size()));
    for (std::size_t e = 0; e < pairs_.size(); ++e) {
      const auto [i, j] = pairs_[e];
      const VectorXd coefficients = free_ * unknown.segment(first_unknown(e), free_.cols());
      Index k = 0;
      for (std::size_t p = 0; p < poles_.size(); ++p) {
        const double re = coefficients(k++), im = poles_[p].imag() > 0.0 ? coefficients(k++) : 0.0;
        fit.residues[p](i, j) = fit.residues[p](j, i) = Complex(re, im);
      }
    }
    return fit;
  }

  const FitTarget& target_;
  const std::vector<Complex>& poles_;
  VectorXd peaks_;
  std::vector<Pair> pairs_;
  MatrixXd free_, damping_rows_, kernel_rows_;
  std::vector<MatrixXd> triangles_;
  std::vector<VectorXd> reduced_;
  MatrixXd passive_rows_;
  VectorXd passive_wanted_;
};

}  // namespace

Eigen::MatrixXcd kernel_transform(const GroupFit& fit, double omega) {
  const Complex s(0.0, omega);
  Eigen::MatrixXcd sum = Eigen::MatrixXcd::Zero(fit.residues[0].rows(), fit.residues[0].cols());
  for (std::size_t p = 0; p < fit.poles.size(); ++p) {
    sum += 0.5 * (fit.residues[p] / (s - fit.poles[p]) + fit.residues[p].conjugate() / (s - std::conj(fit.poles[p])));
  }
  return sum;
}

std::vector<Complex> improve_poles(const FitTarget& target, std::vector<Complex> poles, double slowest) {
  const VectorXd peaks = damping_peaks(target);
  const std::vector<Pair> pairs = make_pairs(peaks.size());
  FrequencyResponse response;
  response.omega = target.omega;
  response.values.resize(static_cast<Index>(target.omega.size()), static_cast<Index>(pairs.size()));
  response.weights.resize(response.values.rows(), response.values.cols());
  for (std::size_t e = 0; e < pairs.size(); ++e) {
    const auto [i, j] = pairs[e];
    response.weights.col(static_cast<Index>(e)) = entry_weights(target, peaks, pairs[e]);
    for (std::size_t k = 0; k < target.omega.size(); ++k) {
      response.values(static_cast<Index>(k), static_cast<Index>(e)) =
          Complex(target.damping[k](i, j), target.omega[k] * target.mass[k](i, j));
    }
  }
  for (int round = 0; round < kRelocations && !poles.empty(); ++round) {
    check_interruption();
    poles = relocate_poles(response, poles, slowest);
  }
  return poles;
}

GroupFit fit_residues(const FitTarget& target, const std::vector<Complex>& poles) {
  ResidueProblem problem(target, poles);
  GroupFit fit = problem.solve();
  int rounds = 0;
  while (problem.add_passivity_inequalities(fit) && rounds < kMaxPassivityRounds) {
    check_interruption();
    fit = problem.solve();
    fit.rounds = ++rounds;
  }
  return fit;
}

}  // namespace overbend
