/// The box barge of validation/hull_files in the files of several programs, and its expected values.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "base/constants.h"
#include "seafiles/hydrodynamics_reader.h"
#include "support/damaged_text.h"

namespace overbend::testing {

inline std::string hull_file(const std::string& name) {
  return std::string(OVERBEND_SOURCE_DIR) + "/validation/hull_files/" + name;
}

inline std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline const nlohmann::json& barge_values() {
  static const nlohmann::json kValues = nlohmann::json::parse(read_text(hull_file("expected.json")));
  return kValues;
}

/// Centre of gravity and mass of the barge; the gravity of the files.
inline HydrodynamicsSource barge_source(const std::string& path) {
  HydrodynamicsSource source;
  source.path = path;
  source.origin_V = Vec3(0.0, 0.0, 1.5);
  source.mass = 12915e3;
  source.gravity = kGravity;
  return source;
}

struct HullReading {
  std::optional<HydrodynamicData> data;
  std::vector<std::string> errors, warnings;

  std::string notes() const {
    std::string text;
    for (const std::string& note : data ? data->notes : std::vector<std::string>()) text += note + "\n";
    return text;
  }
};

inline HullReading read_hull(const HydrodynamicsSource& source) {
  Diagnostics diagnostics;
  HullReading reading{read_hydrodynamics(source, diagnostics), {}, {}};
  reading.errors = diagnostics.lines(Severity::error);
  reading.warnings = diagnostics.lines(Severity::warning);
  return reading;
}

inline std::size_t nearest_index(const std::vector<double>& values, double wanted) {
  const auto found = std::min_element(values.begin(), values.end(),
                                      [&](double a, double b) { return std::abs(a - wanted) < std::abs(b - wanted); });
  return static_cast<std::size_t>(found - values.begin());
}

/// Compares with the expected values within a relative tolerance; small forces of a mode within a tenth of it.
inline void expect_barge(const HydrodynamicData& data, double tolerance, bool infinite_frequency) {
  const nlohmann::json& values = barge_values();
  const nlohmann::json& stiffness = values["hull"]["stiffness"];
  const double c[] = {stiffness["heave_N_per_m"], stiffness["roll_Nm"], stiffness["pitch_Nm"]};
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(data.hydrostatic_stiffness(k + 2, k + 2), c[k], tolerance * c[k]) << k;
  }
  Mat6 coupling = data.hydrostatic_stiffness;
  coupling.diagonal().setZero();
  EXPECT_LT(coupling.cwiseAbs().maxCoeff(), tolerance * c[0]);
  std::vector<double> omegas;
  for (const RadiationPoint& point : data.radiation) omegas.push_back(point.omega);
  ASSERT_EQ(omegas.size(), 12U);
  EXPECT_EQ(data.has_infinite, infinite_frequency);
  for (const auto& [modes, value] : values["hull"]["infinite_frequency_added_mass"].items()) {
    const int i = modes[0] - '1';
    if (infinite_frequency) {
      EXPECT_NEAR(data.added_mass_infinite(i, i), value, tolerance * value.get<double>()) << modes;
    }
  }
  for (const nlohmann::json& row : values["rows"]) {
    const double omega = kTurn / row["period_s"].get<double>();
    SCOPED_TRACE(row["period_s"].get<double>());
    const RadiationPoint& point = data.radiation[nearest_index(omegas, omega)];
    EXPECT_NEAR(point.omega, omega, 1e-5 * omega);
    for (const auto& [modes, value] : row["A"].items()) {
      EXPECT_NEAR(point.added_mass(modes[0] - '1', modes[1] - '1'), value, tolerance * std::abs(value.get<double>()));
    }
    for (const auto& [modes, value] : row["B"].items()) {
      EXPECT_NEAR(point.damping(modes[0] - '1', modes[1] - '1'), value, tolerance * std::abs(value.get<double>()));
    }
    const std::size_t i = nearest_index(data.excitation.omega, omega);
    for (const auto& [heading, forces] : row["X"].items()) {
      const std::size_t j = nearest_index(data.excitation.heading, std::stod(heading) * kDegree);
      EXPECT_NEAR(data.excitation.heading[j], std::stod(heading) * kDegree, 1e-9);
      const CVec6& force = data.force[data.excitation.index(i, j)];
      for (int k = 0; k < 6; ++k) {
        double max_force = 0.0;
        for (const CVec6& entry : data.force) max_force = std::max(max_force, std::abs(entry(k)));
        const auto pair = forces[static_cast<std::size_t>(k)];
        const double amplitude = pair[0], lag = pair[1].get<double>() * kDegree;
        const double error = std::abs(force(k) - std::polar(amplitude, -lag));
        EXPECT_LT(error, tolerance * (amplitude + 0.1 * max_force)) << "heading " << heading << ", mode " << k + 1;
      }
    }
  }
}

/// Folder that is removed at the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    static int count = 0;
    folder_ = std::filesystem::path(::testing::TempDir()) /
              ("overbend_hulls_" + std::to_string(std::random_device()()) + "_" + std::to_string(++count));
    std::filesystem::create_directories(folder_);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return path(name);
  }
  void copy(const std::string& from) const {
    std::filesystem::copy(from, folder_, std::filesystem::copy_options::recursive);
  }

 private:
  std::filesystem::path folder_;
};

/// Replaces the first occurrence; fails if there is none.
inline std::string with_change(std::string text, const std::string& find, const std::string& replacement) {
  const std::size_t place = text.find(find);
  EXPECT_NE(place, std::string::npos) << find;
  return place == std::string::npos ? text : text.replace(place, find.size(), replacement);
}

/// True if all values are finite and complete.
inline bool is_whole(const HydrodynamicData& data) {
  bool whole = data.hydrostatic_stiffness.allFinite() && data.added_mass_infinite.allFinite() &&
               data.force.size() == data.excitation.omega.size() * data.excitation.heading.size() &&
               data.mean_drift.size() == data.drift.omega.size() * data.drift.heading.size();
  for (const RadiationPoint& point : data.radiation) {
    whole = whole && point.added_mass.allFinite() && point.damping.allFinite() && point.omega > 0.0;
  }
  for (const CVec6& force : data.force) whole = whole && force.allFinite();
  for (const Vec6& drift : data.mean_drift) whole = whole && drift.allFinite();
  return whole;
}

/// Reads damaged versions of one file in a copy of its folder: an answer each time, either errors or whole data.
inline void expect_answers_to_damage(const std::string& folder, const std::string& damaged_file,
                                     const std::string& named_file, int trials) {
  const ScratchFolder scratch;
  scratch.copy(folder);
  const std::string good = read_text(scratch.path(damaged_file));
  std::mt19937 random(20261130);
  for (int trial = 0; trial < trials; ++trial) {
    std::string text = damaged_text(good, random);
    if (trial % 3 == 0) text = damaged_text(text, random);
    scratch.write(damaged_file, text);
    const HullReading reading = read_hull(barge_source(scratch.path(named_file)));
    EXPECT_NE(reading.data.has_value(), !reading.errors.empty()) << trial;
    if (reading.data) {
      EXPECT_TRUE(is_whole(*reading.data)) << trial;
    }
  }
}

}  // namespace overbend::testing
