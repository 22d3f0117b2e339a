/// Files of waves for tests: validation/sea_files, and damaged copies of them.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "model/description/waves_description.h"
#include "seafiles/wave_file_reader.h"

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

/// Text with one change at random: a byte, a cut, or a line doubled, removed or moved.
inline std::string damaged(std::string text, std::mt19937& random) {
  const auto below = [&random](std::size_t size) {
    return std::uniform_int_distribution<std::size_t>(0, std::max<std::size_t>(size, 1) - 1)(random);
  };
  const std::size_t place = below(text.size());
  switch (below(5)) {
    case 0:
      text[place] = static_cast<char>(below(256));
      return text;
    case 1:
      return text.substr(0, place);
    case 2:
      return text.insert(place, std::string(1 + below(3), "0-9.eMx \n"[below(9)]));
    default:
      break;
  }
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  const auto line = static_cast<std::ptrdiff_t>(below(lines.size()));
  if (below(2) == 0) {
    lines.erase(lines.begin() + line);
  } else {
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(below(lines.size())),
                 lines[static_cast<std::size_t>(line)]);
  }
  std::string joined;
  for (const std::string& one_line : lines) joined += one_line + "\n";
  return joined;
}

/// Reads damaged copies of a file: each gives finite waves or an error with a text.
inline void read_damaged_copies(const std::string& text, const std::string& time, WaveType type, int count) {
  const WrittenFiles files("overbend_damaged");
  std::mt19937 random(1);
  for (int i = 0; i < count; ++i) {
    const std::string copy = damaged(text, random);
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
