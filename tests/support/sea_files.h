/// Files of waves for tests: validation/sea_files, and damaged copies of them.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "model/description/waves_description.h"
#include "seafiles/wave_file_reader.h"
#include "support/damaged_text.h"

namespace overbend::testing {

inline std::string sea_file(const std::string& name) {
  return std::string(OVERBEND_SOURCE_DIR) + "/validation/sea_files/" + name;
}

inline std::string sea_file_text(const std::string& name) {
  std::ifstream stream(sea_file(name), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Waves read from a file, and the messages of the reader.
struct WavesRead {
  WavesDescription waves;
  std::vector<std::string> errors, warnings;
};

inline WavesRead read_waves(const std::string& path, const std::string& time = "", WaveType type = WaveType::user) {
  WavesRead read;
  read.waves.type = type;
  (type == WaveType::elevation ? read.waves.elevation_file : read.waves.spectrum_file) = path;
  read.waves.time = time;
  Diagnostics diagnostics;
  read_wave_file(read.waves, diagnostics);
  read.errors = diagnostics.lines(Severity::error);
  read.warnings = diagnostics.lines(Severity::warning);
  return read;
}

/// Moment of a spectrum by the trapezium rule over its points.
inline double trapezium_moment(const std::vector<SpectrumPoint>& points, int n) {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const SpectrumPoint &a = points[i - 1], &b = points[i];
    sum += 0.5 * (b.omega - a.omega) * (std::pow(a.omega, n) * a.density + std::pow(b.omega, n) * b.density);
  }
  return sum;
}

/// Folder for files that a test writes.
class WrittenFiles {
 public:
  explicit WrittenFiles(const std::string& name)
      : folder_(std::filesystem::path(::testing::TempDir()) / (name + "_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~WrittenFiles() {
    std::error_code error;
    std::filesystem::remove_all(folder_, error);
  }
  WrittenFiles(const WrittenFiles&) = delete;
  WrittenFiles& operator=(const WrittenFiles&) = delete;

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }

 private:
  std::filesystem::path folder_;
};

/// Reads damaged copies of a file: each gives finite waves or an error with a text.
inline void read_damaged_copies(const std::string& text, const std::string& time, WaveType type, int count) {
  const WrittenFiles files("overbend_damaged");
  std::mt19937 random(1);
  for (int i = 0; i < count; ++i) {
    const std::string copy = damaged_text(text, random);
    const WavesRead read = read_waves(files.write("waves", copy), time, type);
    for (const std::string& error : read.errors) EXPECT_NE(error.find("found "), std::string::npos) << error;
    EXPECT_TRUE(std::isfinite(read.waves.hs) && std::isfinite(read.waves.tp) && std::isfinite(read.waves.from));
    if (!read.errors.empty()) continue;
    EXPECT_GT(read.waves.hs, 0.0) << copy;
    for (const SpectrumPoint& point : read.waves.spectrum) {
      EXPECT_TRUE(std::isfinite(point.omega) && std::isfinite(point.density) && point.density >= 0.0);
    }
    for (const double s : read.waves.directions.spreading) EXPECT_TRUE(std::isfinite(s) && s >= 0.0);
    for (const double y : read.waves.record.elevation) EXPECT_TRUE(std::isfinite(y));
  }
}

}  // namespace overbend::testing
