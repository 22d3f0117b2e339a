#include "hull/make_radiation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/units.h"
#include "hull/radiation_fit.h"
#include "hull/radiation_poles.h"
#include "hull/retardation.h"

namespace overbend {
namespace {

using Eigen::MatrixXd;

constexpr int kLeastOrder = 6, kMostOrder = 20;
/// Errors of damping and added mass that end the search for an order, that are good enough after all, and the negative
/// damping that may be left to the constant one.
constexpr double kGoodFit = 0.006, kFairFit = 0.01, kPassive = 1e-5;
constexpr double kNoise = 1e-4;    ///< Of sqrt(max ii * max jj): coupling below is the panel code's rounding.
constexpr double kSilent = 1e-6;   ///< Of the strongest mode of its kind: it does not radiate.
constexpr double kSlowest = 0.03;  // [1/s]
constexpr double kWarnAddedMass = 0.03;
constexpr double kConvolutionInterval = 0.1;  // [s]
constexpr int kKernelSamples = 401;
constexpr const char* kModeNames[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};

Vec6 largest_diagonal(const HydrodynamicData& data, Mat6 RadiationPoint::*what) {
  Vec6 largest = Vec6::Zero();
  for (const RadiationPoint& point : data.radiation) {
    largest = largest.cwiseMax((point.*what).diagonal().cwiseAbs());
  }
  return largest;
}

/// Largest coupling of each pair.
Mat6 largest_damping(const HydrodynamicData& data) {
  Mat6 largest = Mat6::Zero();
  for (const RadiationPoint& point : data.radiation) {
    largest = largest.cwiseMax((0.5 * (point.damping + point.damping.transpose())).cwiseAbs());
  }
  return largest;
}

/// Modes that are coupled by damping, directly or through others; those that do not radiate are left out.
std::vector<std::vector<int>> coupled_groups(const HydrodynamicData& data) {
  const Mat6 damping = largest_damping(data);
  const Vec6 peak = largest_diagonal(data, &RadiationPoint::damping);
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

/// Rows and columns of a group, each divided by a unit.
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

/// Equal steps to one and a half times the last frequency of the data, coarser ones to 4.5 times.
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

/// Samples every 0.2 s over 80 s, finer where the data reach higher frequencies than a barge's.
double kernel_interval(double last) {
  return std::min(0.2, 0.5 * std::numbers::pi / last);
}

FitTarget target_of(const DampingSpectrum& spectrum, const std::vector<Mat6>& kernel, const std::vector<int>& modes,
                    const Eigen::VectorXd& unit) {
  FitTarget target;
  target.interval = kernel_interval(spectrum.last);
  for (const Mat6& k : kernel) {
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

/// What the kernel itself says at the frequencies of the data, scaled as the target.
struct Truth {
  std::vector<double> omega;
  std::vector<MatrixXd> damping, mass_above_infinite;
  Eigen::VectorXd damping_peak, mass_peak;
};

Truth truth_of(const DampingSpectrum& spectrum, const HydrodynamicData& data, const std::vector<int>& modes,
               const Eigen::VectorXd& unit) {
  Truth truth;
  truth.damping_peak = truth.mass_peak = Eigen::VectorXd::Zero(unit.size());
  for (const RadiationPoint& point : data.radiation) {
    truth.omega.push_back(point.omega);
    truth.damping.push_back(part(damping_at(spectrum, point.omega), modes, unit));
    truth.mass_above_infinite.push_back(part(added_mass_above_infinite(spectrum, point.omega), modes, unit));
    truth.damping_peak = truth.damping_peak.cwiseMax(truth.damping.back().diagonal());
    truth.mass_peak = truth.mass_peak.cwiseMax(part(point.added_mass, modes, unit).diagonal());
  }
  return truth;
}

/// Largest error of damping and added mass, share of the peaks.
double error_of(const GroupFit& fit, const Truth& truth) {
  double error = 0.0;
  for (std::size_t k = 0; k < truth.omega.size(); ++k) {
    const Eigen::MatrixXcd at = transform_of(fit, truth.omega[k]);
    for (Eigen::Index i = 0; i < at.rows(); ++i) {
      for (Eigen::Index j = i; j < at.cols(); ++j) {
        const double damping = at(i, j).real() - truth.damping[k](i, j);
        const double mass = at(i, j).imag() / truth.omega[k] - truth.mass_above_infinite[k](i, j);
        error = std::max({error, std::abs(damping) / std::sqrt(truth.damping_peak(i) * truth.damping_peak(j)),
                          std::abs(mass) / std::sqrt(truth.mass_peak(i) * truth.mass_peak(j))});
      }
    }
  }
  return error;
}

struct ChosenFit {
  GroupFit fit;
  int order = 0;  ///< 0: none is good enough.
};

/// The lowest order whose fit is good, else the best of those that are fair.
ChosenFit choose_fit(const FitTarget& target, const Truth& truth) {
  const HankelRealization realization(target.kernel, target.interval, kMostOrder);
  ChosenFit best;
  double best_error = kFairFit;
  for (int order = kLeastOrder; order <= kMostOrder && best_error > kGoodFit; order += 2) {
    GroupFit fit = fit_residues(target, improve_poles(target, realization.poles(order, kSlowest), kSlowest));
    const double error = error_of(fit, truth);
    if (fit.least_damping > -kPassive && error < best_error) {
      best_error = error;
      best = {std::move(fit), order};
    }
  }
  return best;
}

/// Everything about a hull that its groups share.
struct Source {
  const HydrodynamicData& data;
  DampingSpectrum spectrum;
  std::vector<Mat6> kernel;
};

/// Fits one group and adds it to the model. False where no order is good enough.
bool add_group(const Source& source, int group, RadiationModel& model, RadiationGroupReport& report) {
  const std::vector<int>& modes = model.groups[static_cast<std::size_t>(group)];
  Eigen::VectorXd unit(static_cast<Eigen::Index>(modes.size()));
  for (std::size_t i = 0; i < modes.size(); ++i) {
    unit(static_cast<Eigen::Index>(i)) = std::sqrt(source.kernel[0](modes[i], modes[i]));
  }
  const FitTarget target = target_of(source.spectrum, source.kernel, modes, unit);
  const Truth truth = truth_of(source.spectrum, source.data, modes, unit);
  const ChosenFit chosen = choose_fit(target, truth);
  if (chosen.order == 0) {
    return false;
  }
  report.order = chosen.order;
  report.least_damping = chosen.fit.least_damping;
  report.least_damping_omega = chosen.fit.least_damping_omega;
  report.added_damping = std::max(0.0, -chosen.fit.least_damping);
  for (std::size_t p = 0; p < chosen.fit.poles.size(); ++p) {
    RadiationPole pole;
    pole.pole = chosen.fit.poles[p];
    pole.group = group;
    for (std::size_t i = 0; i < modes.size(); ++i) {
      for (std::size_t j = 0; j < modes.size(); ++j) {
        const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
        pole.residue(modes[i], modes[j]) = chosen.fit.residues[p](row, column) * unit(row) * unit(column);
      }
    }
    model.poles.push_back(pole);
  }
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    model.constant_damping(modes[i], modes[i]) = report.added_damping * truth.damping_peak(row) * unit(row) * unit(row);
  }
  return true;
}

void use_convolution(const Source& source, RadiationModel& model) {
  model.kind = Radiation::convolution;
  model.poles.clear();
  model.constant_damping.setZero();
  model.samples = convolution_samples(source.spectrum, kConvolutionInterval);
}

std::string names_of(const std::vector<int>& modes) {
  std::string names;
  for (const int mode : modes) {
    names += (names.empty() ? "" : ", ") + std::string(kModeNames[mode]);
  }
  return names;
}

void fit_all(const Source& source, Radiated& radiated) {
  radiated.model.kind = Radiation::state_space;
  for (std::size_t g = 0; g < radiated.model.groups.size(); ++g) {
    if (!add_group(source, static_cast<int>(g), radiated.model, radiated.report.groups[g])) {
      radiated.report.warnings.push_back("the radiation memory of " + names_of(radiated.model.groups[g]) +
                                         " is not represented within 1 % by exponentials of order 20; direct "
                                         "convolution is used instead");
      use_convolution(source, radiated.model);
      for (RadiationGroupReport& group : radiated.report.groups) {
        group = {group.modes};
      }
      return;
    }
  }
}

bool share_group(const RadiationModel& model, int i, int j) {
  return std::any_of(model.groups.begin(), model.groups.end(), [&](const std::vector<int>& modes) {
    return std::find(modes.begin(), modes.end(), i) != modes.end() &&
           std::find(modes.begin(), modes.end(), j) != modes.end();
  });
}

void report_entries(const Source& source, Radiated& radiated) {
  const Vec6 damping_peak = largest_diagonal(source.data, &RadiationPoint::damping);
  const Vec6 mass_peak = largest_diagonal(source.data, &RadiationPoint::added_mass);
  Mat6 damping_error = Mat6::Zero(), mass_error = Mat6::Zero();
  for (const RadiationPoint& file : source.data.radiation) {
    const RadiationPoint made = radiation_at(radiated.model, file.omega);
    damping_error = damping_error.cwiseMax((made.damping - 0.5 * (file.damping + file.damping.transpose())).cwiseAbs());
    mass_error =
        mass_error.cwiseMax((made.added_mass - 0.5 * (file.added_mass + file.added_mass.transpose())).cwiseAbs());
  }
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) {
      if (share_group(radiated.model, i, j)) {
        const double used = radiated.model.added_mass(i, j);
        const double given = source.data.has_infinite
                                 ? 0.5 * (source.data.added_mass_infinite(i, j) + source.data.added_mass_infinite(j, i))
                                 : used;
        radiated.report.entries.push_back({i, j, source.spectrum.tail_exponent(i, j), given, used,
                                           damping_error(i, j) / std::sqrt(damping_peak(i) * damping_peak(j)),
                                           mass_error(i, j) / std::sqrt(mass_peak(i) * mass_peak(j))});
      }
    }
  }
}

void warn_of_added_mass(RadiationReport& report) {
  for (const RadiationEntryReport& entry : report.entries) {
    const double change = entry.added_mass_used / entry.added_mass_file - 1.0;
    if (entry.i == entry.j && std::abs(change) > kWarnAddedMass) {
      report.warnings.push_back("added mass of " + std::string(kModeNames[entry.i]) +
                                " at infinite frequency differs by " + format_number(100.0 * change, 2) +
                                " % from what the damping of the hydrodynamic file demands (Ogilvie's relation); " +
                                "frequencies may not reach far enough");
    }
  }
}

/// Integral of K exp(-i omega t) of the convolution, velocities taken as linear between the points of its grid: K is
/// the second derivative of its samples.
Eigen::Matrix<std::complex<double>, 6, 6> transform_of(const RadiationSamples& samples, double omega) {
  const std::complex<double> i_omega(0.0, omega);
  CMat6 sum = CMat6::Zero();
  for (std::size_t k = 0; k + 1 < samples.twice.size(); ++k) {
    const double middle = (static_cast<double>(k) + 0.5) * samples.interval;
    sum += (samples.twice[k + 1] - samples.twice[k]) * std::exp(-i_omega * middle);
  }
  return i_omega * sum;
}

}  // namespace

RadiationPoint radiation_at(const RadiationModel& model, double omega) {
  CMat6 transform = CMat6::Zero();
  if (model.kind == Radiation::convolution) {
    transform = transform_of(model.samples, omega);
  }
  const std::complex<double> s(0.0, omega);
  for (const RadiationPole& pole : model.poles) {
    transform += 0.5 * (pole.residue / (s - pole.pole) + pole.residue.conjugate() / (s - std::conj(pole.pole)));
  }
  return {omega, model.added_mass + transform.imag() / omega, model.constant_damping + transform.real()};
}

Radiated make_radiation(const HydrodynamicData& data, Radiation kind) {
  Source source{data, damping_spectrum(data), {}};
  source.kernel = retardation_samples(source.spectrum, kernel_interval(source.spectrum.last), kKernelSamples);
  Radiated radiated;
  radiated.model.added_mass = source.spectrum.added_mass;
  radiated.model.groups = coupled_groups(data);
  for (const std::vector<int>& modes : radiated.model.groups) {
    radiated.report.groups.push_back({modes});
  }
  if (kind == Radiation::convolution) {
    use_convolution(source, radiated.model);
  } else {
    fit_all(source, radiated);
  }
  report_entries(source, radiated);
  warn_of_added_mass(radiated.report);
  radiated.report.states = static_cast<int>(fresh_memory(radiated.model).values.size());
  return radiated;
}

}  // namespace overbend
