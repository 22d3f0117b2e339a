#include "hull/make_radiation.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

#include "base/units.h"
#include "hull/radiation_groups.h"

namespace overbend {
namespace {

constexpr double kWarnAddedMass = 0.03, kWarnNegative = 0.01;
constexpr const char* kModeNames[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};

/// Fits one group and adds it to the model. Returns false if no order is accurate enough.
bool add_group(const RadiationSource& source, int group, RadiationModel& model, RadiationGroupReport& report) {
  const std::vector<int>& modes = model.groups[static_cast<std::size_t>(group)];
  const ChosenFit chosen = choose_fit(source, modes);
  if (chosen.order == 0) {
    return false;
  }
  report.order = chosen.order;
  report.min_fitted_damping = chosen.fit.min_fitted_damping;
  report.min_fitted_damping_omega = chosen.fit.min_fitted_damping_omega;
  report.added_damping = std::max(0.0, -chosen.fit.min_fitted_damping);
  for (std::size_t p = 0; p < chosen.fit.poles.size(); ++p) {
    RadiationPole pole;
    pole.pole = chosen.fit.poles[p];
    pole.group = group;
    for (std::size_t i = 0; i < modes.size(); ++i) {
      for (std::size_t j = 0; j < modes.size(); ++j) {
        const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
        pole.residue(modes[i], modes[j]) = chosen.fit.residues[p](row, column) * chosen.unit(row) * chosen.unit(column);
      }
    }
    model.poles.push_back(pole);
  }
  const Vec6 peak = max_diagonals(source.data, &RadiationPoint::damping);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    model.constant_damping(modes[i], modes[i]) = report.added_damping * peak(modes[i]);
  }
  return true;
}

void use_convolution(const RadiationSource& source, RadiationModel& model) {
  model.kind = Radiation::convolution;
  model.poles.clear();
  model.constant_damping.setZero();
  model.samples = convolution_samples(source.spectrum);
}

std::string join_mode_names(const std::vector<int>& modes) {
  std::string names;
  for (const int mode : modes) {
    names += (names.empty() ? "" : ", ") + std::string(kModeNames[mode]);
  }
  return names;
}

void fit_all(const RadiationSource& source, Radiated& radiated) {
  radiated.model.kind = Radiation::state_space;
  for (std::size_t g = 0; g < radiated.model.groups.size(); ++g) {
    if (!add_group(source, static_cast<int>(g), radiated.model, radiated.report.groups[g])) {
      radiated.report.findings.push_back({FindingCode::radiation_by_convolution,
                                          "the radiation memory of " + join_mode_names(radiated.model.groups[g]) +
                                              " is not represented within 1 % by exponentials of order 20; direct "
                                              "convolution is used instead"});
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

void report_entries(const RadiationSource& source, Radiated& radiated) {
  const Vec6 damping_peak = max_diagonals(source.data, &RadiationPoint::damping);
  const Vec6 mass_peak = max_diagonals(source.data, &RadiationPoint::added_mass);
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
        const double file_value =
            source.data.has_infinite
                ? 0.5 * (source.data.added_mass_infinite(i, j) + source.data.added_mass_infinite(j, i))
                : used;
        radiated.report.entries.push_back({i, j, source.spectrum.tail_exponent(i, j), file_value, used,
                                           damping_error(i, j) / std::sqrt(damping_peak(i) * damping_peak(j)),
                                           mass_error(i, j) / std::sqrt(mass_peak(i) * mass_peak(j))});
      }
    }
  }
}

void add_file_warnings(double max_negative_damping, RadiationReport& report) {
  if (max_negative_damping > kWarnNegative) {
    report.findings.push_back(Finding{FindingCode::negative_radiation_damping,
                                      "the hydrodynamic file contains negative radiation damping, up to " +
                                          format_number(100.0 * max_negative_damping, 2) +
                                          " % of the maximum; it is set to zero"}
                                  .on("vessel")
                                  .with("fraction", max_negative_damping, "1"));
  }
  for (const RadiationEntryReport& entry : report.entries) {
    const double change = entry.added_mass_used / entry.added_mass_file - 1.0;
    if (entry.i == entry.j && std::abs(change) > kWarnAddedMass) {
      report.findings.push_back(
          Finding{FindingCode::added_mass_mismatch,
                  "added mass of " + std::string(kModeNames[entry.i]) + " at infinite frequency differs by " +
                      format_number(100.0 * change, 2) +
                      " % from the value required by the damping of the hydrodynamic file (Ogilvie's relation); " +
                      "its frequencies may not extend far enough"}
              .on("added mass of " + std::string(kModeNames[entry.i]))
              .with("difference", change, "1"));
    }
  }
}

/// Integral of K exp(-i omega t) of the convolution, with velocities linear between its grid points: K is the second
/// derivative of its samples.
Eigen::Matrix<std::complex<double>, 6, 6> kernel_transform(const RadiationSamples& samples, double omega) {
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
    transform = kernel_transform(model.samples, omega);
  }
  const std::complex<double> s(0.0, omega);
  for (const RadiationPole& pole : model.poles) {
    transform += 0.5 * (pole.residue / (s - pole.pole) + pole.residue.conjugate() / (s - std::conj(pole.pole)));
  }
  return {omega, model.added_mass + transform.imag() / omega, model.constant_damping + transform.real()};
}

namespace {

Radiated compute_radiation(const HydrodynamicData& data, Radiation kind) {
  const RadiationSource source = radiation_source(data);
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
  add_file_warnings(source.spectrum.max_negative_damping, radiated.report);
  radiated.report.states = static_cast<int>(make_bending_memory(radiated.model).values.size());
  return radiated;
}

/// The coefficients that determine the radiation model: no others reach it.
HydrodynamicData radiation_coefficients(const HydrodynamicData& data) {
  HydrodynamicData coefficients;
  coefficients.radiation = data.radiation;
  coefficients.has_infinite = data.has_infinite;
  coefficients.added_mass_infinite = data.added_mass_infinite;
  return coefficients;
}

bool are_equal(const HydrodynamicData& a, const HydrodynamicData& b) {
  return a.has_infinite == b.has_infinite && a.added_mass_infinite == b.added_mass_infinite &&
         std::equal(a.radiation.begin(), a.radiation.end(), b.radiation.begin(), b.radiation.end(),
                    [](const RadiationPoint& left, const RadiationPoint& right) {
                      return left.omega == right.omega && left.added_mass == right.added_mass &&
                             left.damping == right.damping;
                    });
}

/// The latest radiation models. A fit takes longer than the statics of a moored barge, and the cases of a study, the
/// seeds of a storm and the page ask for the same one again.
class RadiationCache {
 public:
  Radiated find_or_compute(HydrodynamicData coefficients, Radiation kind) {
    if (const std::optional<Radiated> found = find(coefficients, kind)) return *found;
    Radiated computed = compute_radiation(coefficients, kind);  // other threads need not wait for it
    const std::lock_guard<std::mutex> hold(mutex_);
    entries_.push_front({std::move(coefficients), kind, computed});
    if (entries_.size() > kMaxEntries) entries_.pop_back();
    return computed;
  }

 private:
  struct Entry {
    HydrodynamicData coefficients;
    Radiation kind;
    Radiated radiated;
  };
  static constexpr std::size_t kMaxEntries = 4;  ///< More than the hulls of a model.

  std::optional<Radiated> find(const HydrodynamicData& coefficients, Radiation kind) {
    const std::lock_guard<std::mutex> hold(mutex_);
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
      return entry.kind == kind && are_equal(entry.coefficients, coefficients);
    });
    if (found == entries_.end()) return std::nullopt;
    return found->radiated;
  }

  std::mutex mutex_;
  std::deque<Entry> entries_;
};

}  // namespace

Radiated make_radiation(const HydrodynamicData& data, Radiation kind) {
  static RadiationCache cache;
  return cache.find_or_compute(radiation_coefficients(data), kind);
}

}  // namespace overbend
