#include "hull/radiation_groups.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hull/radiation_poles.h"

namespace overbend {
namespace {

using Eigen::MatrixXd;

constexpr int kMinOrder = 6, kMaxOrder = 20;
/// Errors of damping and added mass at which the search for an order ends, errors that are acceptable, and negative
/// damping that may be compensated by constant damping.
constexpr double kGoodFit = 0.003, kFairFit = 0.01, kPassive = 1e-5;
/// Share of the maximum frequency below which errors are ignored: added mass of heave in finite depth grows like a
/// logarithm towards zero frequency, which a few exponentials cannot represent and no motion feels.
constexpr double kCheckedFrom = 0.03;
constexpr double kNoise = 1e-4;   ///< Relative to sqrt(max ii * max jj): weaker coupling is rounding of the panel code.
constexpr double kSilent = 1e-6;  ///< Relative to the strongest mode of its kind: weaker modes do not radiate.
/// Slowest decay relative to the typical frequency, and sample interval of the kernel over it: 0.03 1/s and 0.2 s for a
/// barge of 120 m.
constexpr double kSlowest = 0.0275, kInterval = 0.219;
constexpr int kKernelSamples = 401;

/// Maximum coupling of each pair.
Mat6 max_pair_damping(const HydrodynamicData& data) {
  Mat6 max_values = Mat6::Zero();
  for (const RadiationPoint& point : data.radiation) {
    max_values = max_values.cwiseMax((0.5 * (point.damping + point.damping.transpose())).cwiseAbs());
  }
  return max_values;
}

/// Rows and columns of a group, each divided by its unit.
MatrixXd part(const Mat6& matrix, const std::vector<int>& modes, const Eigen::VectorXd& unit) {
  const auto m = static_cast<Eigen::Index>(modes.size());
  MatrixXd result(m, m);
  for (Eigen::Index i = 0; i < m; ++i) {
    for (Eigen::Index j = 0; j < m; ++j) {
      result(i, j) = matrix(modes[static_cast<std::size_t>(i)], modes[static_cast<std::size_t>(j)]) / unit(i) / unit(j);
    }
  }
  return result;
}

/// Damping at any frequency of the spectrum, linear between its nodes.
Mat6 damping_at(const DampingSpectrum& spectrum, double omega) {
  const auto right = static_cast<std::size_t>(
      std::upper_bound(spectrum.omega.begin(), spectrum.omega.end() - 1, omega) - spectrum.omega.begin());
  const double share = (omega - spectrum.omega[right - 1]) / (spectrum.omega[right] - spectrum.omega[right - 1]);
  return (1.0 - share) * spectrum.damping[right - 1] + share * spectrum.damping[right];
}

/// Equal steps to 1.5 times the last frequency of the data, coarser ones to 4.5 times.
std::vector<double> fitted_frequencies(double last) {
  std::vector<double> omega;
  for (int k = 1; k <= 150; ++k) {
    omega.push_back(0.01 * last * k);
  }
  for (int k = 1; k <= 60; ++k) {
    omega.push_back(last * (1.5 + 0.05 * k));
  }
  return omega;
}

std::vector<double> checked_frequencies(double last) {
  std::vector<double> omega;
  for (int k = 1; k <= 440; ++k) {
    omega.push_back(last * 0.0025 * k);
  }
  for (int k = 1; k <= 160; ++k) {
    omega.push_back(last * 1.1 * std::pow(5.0, k / 160.0));
  }
  return omega;
}

FitTarget make_target(const RadiationSource& source, const std::vector<int>& modes, const Eigen::VectorXd& unit) {
  const DampingSpectrum& spectrum = source.spectrum;
  FitTarget target;
  target.interval = source.interval;
  for (const Mat6& k : source.kernel) {
    target.kernel.push_back(part(k, modes, unit));
  }
  target.omega = fitted_frequencies(spectrum.last);
  for (const double omega : target.omega) {
    target.damping.push_back(part(damping_at(spectrum, omega), modes, unit));
    target.mass.push_back(part(added_mass_above_infinite(spectrum, omega), modes, unit));
  }
  target.low_to = 0.114 * spectrum.last;
  target.checked_omega = checked_frequencies(spectrum.last);
  return target;
}

/// Spectrum of the kernel itself at the frequencies of the data, scaled as the target.
struct LaneMask {
  std::vector<double> omega;
  std::vector<MatrixXd> damping, mass_above_infinite;
  Eigen::VectorXd damping_peak, mass_peak;
};

LaneMask make_reference_spectrum(const DampingSpectrum& spectrum, const HydrodynamicData& data,
                                 const std::vector<int>& modes, const Eigen::VectorXd& unit) {
  LaneMask truth;
  truth.damping_peak = truth.mass_peak = Eigen::VectorXd::Zero(unit.size());
  for (const RadiationPoint& point : data.radiation) {
    const MatrixXd damping = part(damping_at(spectrum, point.omega), modes, unit);
    truth.damping_peak = truth.damping_peak.cwiseMax(damping.diagonal());
    truth.mass_peak = truth.mass_peak.cwiseMax(part(point.added_mass, modes, unit).diagonal());
    if (point.omega >= kCheckedFrom * spectrum.last) {
      truth.omega.push_back(point.omega);
      truth.damping.push_back(damping);
      truth.mass_above_infinite.push_back(part(added_mass_above_infinite(spectrum, point.omega), modes, unit));
    }
  }
  return truth;
}

/// Maximum error of damping and added mass, share of the peaks.
double max_fit_error(const GroupFit& fit, const LaneMask& truth) {
  double error = 0.0;
  for (std::size_t k = 0; k < truth.omega.size(); ++k) {
    const Eigen::MatrixXcd response = kernel_transform(fit, truth.omega[k]);
    for (Eigen::Index i = 0; i < response.rows(); ++i) {
      for (Eigen::Index j = i; j < response.cols(); ++j) {
        const double damping = response(i, j).real() - truth.damping[k](i, j);
        const double mass = response(i, j).imag() / truth.omega[k] - truth.mass_above_infinite[k](i, j);
        error = std::max({error, std::abs(damping) / std::sqrt(truth.damping_peak(i) * truth.damping_peak(j)),
                          std::abs(mass) / std::sqrt(truth.mass_peak(i) * truth.mass_peak(j))});
      }
    }
  }
  return error;
}

}  // namespace

RadiationSource radiation_source(const HydrodynamicData& data) {
  RadiationSource source{data, damping_spectrum(data), {}, 0.0};
  source.interval = std::min(kInterval / source.spectrum.typical, 0.5 * std::numbers::pi / source.spectrum.last);
  source.kernel = retardation_samples(source.spectrum, source.interval, kKernelSamples);
  return source;
}

Vec6 max_diagonals(const HydrodynamicData& data, Mat6 RadiationPoint::*what) {
  Vec6 max_values = Vec6::Zero();
  for (const RadiationPoint& point : data.radiation) {
    max_values = max_values.cwiseMax((point.*what).diagonal().cwiseAbs());
  }
  return max_values;
}

std::vector<std::vector<int>> coupled_groups(const HydrodynamicData& data) {
  const Mat6 damping = max_pair_damping(data);
  const Vec6 peak = max_diagonals(data, &RadiationPoint::damping);
  std::vector<std::vector<int>> groups;
  std::vector<bool> taken(6, false);
  for (int i = 0; i < 6; ++i) {
    const double strongest = (i < 3 ? peak.head<3>() : peak.tail<3>()).maxCoeff();
    taken[static_cast<std::size_t>(i)] = peak(i) <= kSilent * strongest;
  }
  for (int first = 0; first < 6; ++first) {
    std::vector<int> group;
    if (!taken[static_cast<std::size_t>(first)]) {
      group.push_back(first);
      taken[static_cast<std::size_t>(first)] = true;
    }
    for (std::size_t k = 0; k < group.size(); ++k) {
      for (int j = 0; j < 6; ++j) {
        const int i = group[k];
        if (!taken[static_cast<std::size_t>(j)] && damping(i, j) > kNoise * std::sqrt(peak(i) * peak(j))) {
          group.push_back(j);
          taken[static_cast<std::size_t>(j)] = true;
        }
      }
    }
    if (!group.empty()) {
      std::sort(group.begin(), group.end());
      groups.push_back(group);
    }
  }
  return groups;
}

ChosenFit choose_fit(const RadiationSource& source, const std::vector<int>& modes) {
  Eigen::VectorXd unit(static_cast<Eigen::Index>(modes.size()));
  for (std::size_t i = 0; i < modes.size(); ++i) {
    unit(static_cast<Eigen::Index>(i)) = std::sqrt(source.kernel[0](modes[i], modes[i]));
  }
  const FitTarget target = make_target(source, modes, unit);
  const LaneMask truth = make_reference_spectrum(source.spectrum, source.data, modes, unit);
  const HankelRealization realization(target.kernel, target.interval, kMaxOrder);
  const double slowest = kSlowest * source.spectrum.typical;
  ChosenFit best;
  best.unit = unit;
  double best_error = kFairFit;
  // Errors mostly decrease with the order: bisection for the minimum order with a good fit.
  for (int low = kMinOrder, high = kMaxOrder; low <= high;) {
    const int order = low + (high - low) / 4 * 2;
    const std::vector<std::complex<double>> poles = improve_poles(target, realization.poles(order, slowest), slowest);
    GroupFit fit = poles.size() < 2 ? GroupFit{} : fit_residues(target, poles);
    const bool passive = poles.size() >= 2 && fit.min_fitted_damping > -kPassive;
    const double error = passive ? max_fit_error(fit, truth) : 1.0;
    const bool good = error <= kGoodFit;
    if (good || error < best_error) {
      best_error = error;
      best.fit = std::move(fit);
      best.order = order;
    }
    (good ? high : low) = good ? order - 2 : order + 2;
  }
  return best;
}

}  // namespace overbend
