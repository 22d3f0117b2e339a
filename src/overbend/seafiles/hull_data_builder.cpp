#include "seafiles/hull_data_builder.h"

#include <cmath>

#include "base/constants.h"
#include "base/units.h"
#include "seafiles/hull_file_error.h"

namespace overbend {
namespace {

constexpr std::size_t kMinFrequencies = 4;

std::string frequency_label(double omega) {
  if (omega == 0.0) return "zero frequency";
  if (std::isinf(omega)) return "infinite frequency";
  return "period " + format_number(kTurn / omega) + " s";
}

std::string mode_pair_label(int i, int j) {
  return "(" + std::to_string(i + 1) + "," + std::to_string(j + 1) + ")";
}

void check_frequency(double omega, int line) {
  constexpr double kMin = 1e-5, kMax = 1e3;  // [rad/s]
  if (omega == 0.0 || omega == kInfinity || (omega > kMin && omega < kMax)) return;
  throw HullFileError(line, "a frequency of " + format_number(omega) + " rad/s", "a frequency of waves");
}

void check_heading(double heading, int line) {
  if (std::abs(heading) <= 2.0 * kTurn) return;
  throw HullFileError(line, "a heading of " + format_number(heading * kToDegrees) + " deg", "-360 to 360 deg");
}

void require_finite(bool finite, const std::string& name, double omega, int line) {
  if (!finite) throw HullFileError(line, name + " that is not finite at " + frequency_label(omega), "finite numbers");
}

HeadingTableBuilder::Built build_table(const HeadingTableBuilder& values, bool mirror, const std::string& name) {
  std::string error;
  auto table = values.build(mirror, error);
  if (!table) throw HullFileError(name + ": " + error, "one value for every pair of period and heading");
  return std::move(*table);
}

}  // namespace

HullDataBuilder::Radiation& HullDataBuilder::radiation(double omega, int i, int j, double value, int line) {
  require_finite(std::isfinite(value), "added mass or damping", omega, line);
  check_frequency(omega, line);
  if (i < 0 || i > 5 || j < 0 || j > 5) {
    throw HullFileError(line, "the modes " + mode_pair_label(i, j), "modes from 1 to 6");
  }
  Radiation& entry = radiation_[omega];
  if (entry.line == 0) entry.line = line;
  return entry;
}

void HullDataBuilder::add_added_mass(double omega, int i, int j, double value, int line) {
  Radiation& entry = radiation(omega, i, j, value, line);
  if (entry.has_mass(i, j)) {
    throw HullFileError(line, "A" + mode_pair_label(i, j) + " twice at " + frequency_label(omega), "each value once");
  }
  entry.added_mass(i, j) = value;
  entry.has_mass(i, j) = true;
}

void HullDataBuilder::add_damping(double omega, int i, int j, double value, int line) {
  Radiation& entry = radiation(omega, i, j, value, line);
  if (entry.has_damping(i, j)) {
    throw HullFileError(line, "B" + mode_pair_label(i, j) + " twice at " + frequency_label(omega), "each value once");
  }
  entry.damping(i, j) = value;
  entry.has_damping(i, j) = true;
}

void HullDataBuilder::add_force(double omega, double heading, int mode, std::complex<double> force, int line) {
  require_finite(std::isfinite(force.real()) && std::isfinite(force.imag()), "an excitation", omega, line);
  check_frequency(omega, line);
  check_heading(heading, line);
  if (!(omega > 0.0) || std::isinf(omega)) return;
  forces_.add(omega, heading, mode, force);
}

void HullDataBuilder::add_drift(double omega, double heading, int mode, double force, int line) {
  require_finite(std::isfinite(force), "a mean drift", omega, line);
  check_frequency(omega, line);
  check_heading(heading, line);
  const bool horizontal = mode == 0 || mode == 1 || mode == 5;
  if (!horizontal || !(omega > 0.0) || std::isinf(omega)) return;
  drift_.add(omega, heading, mode, force);
}

void HullDataBuilder::build_radiation(HydrodynamicData& data) const {
  const auto first = radiation_.upper_bound(0.0), last = radiation_.lower_bound(kInfinity);
  if (std::distance(first, last) < static_cast<std::ptrdiff_t>(kMinFrequencies)) {
    throw HullFileError(std::to_string(std::distance(first, last)) + " finite frequencies",
                        "added mass and damping at four frequencies or more");
  }
  for (const auto& [omega, entry] : radiation_) {
    const bool finite = omega > 0.0 && std::isfinite(omega);
    if (entry.has_mass != first->second.has_mass || (finite && entry.has_damping != entry.has_mass)) {
      throw HullFileError(entry.line,
                          "other pairs of modes at " + frequency_label(omega) + " than at " +
                              frequency_label(first->first) + ", or added mass without damping",
                          "the same pairs at every frequency");
    }
    RadiationPoint point{omega, entry.added_mass, entry.damping};
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        if (entry.has_mass(i, j) || !entry.has_mass(j, i)) continue;  // symmetry, which holds without forward speed
        point.added_mass(i, j) = point.added_mass(j, i);
        point.damping(i, j) = point.damping(j, i);
      }
    }
    if (finite) {
      data.radiation.push_back(point);
    } else if (omega == 0.0) {
      data.has_zero = true;
      data.added_mass_zero = point.added_mass;
    } else {
      data.has_infinite = true;
      data.added_mass_infinite = point.added_mass;
    }
  }
  constexpr double kSameFrequency = 1e-5;  // relative: files print seven digits
  for (std::size_t k = 1; k < data.radiation.size(); ++k) {
    const double omega = data.radiation[k].omega;
    if (omega - data.radiation[k - 1].omega > kSameFrequency * omega) continue;
    throw HullFileError(radiation_.at(omega).line, frequency_label(omega) + " twice", "each frequency once");
  }
}

void HullDataBuilder::build(HydrodynamicData& data, bool mirror) const {
  build_radiation(data);
  if (forces_.empty()) throw HullFileError("no wave forces", "the excitation by frequency and heading");
  auto excitation = build_table(forces_, mirror, "excitation");
  data.excitation = std::move(excitation.table);
  data.force = std::move(excitation.values);
  if (drift_.empty()) return;
  auto drift = build_table(drift_, mirror, "mean drift");
  data.drift = std::move(drift.table);
  for (const CVec6& value : drift.values) data.mean_drift.push_back(value.real());
}

}  // namespace overbend
