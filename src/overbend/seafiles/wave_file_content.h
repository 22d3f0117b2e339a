/// Contents of a file of buoys or wave models.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "model/description/waves_description.h"
#include "seafiles/file_time.h"

namespace overbend {

/// Significant wave height, peak period and zero up-crossing period in a file of sea states.
struct FileSeaState {
  int line = 0;
  double hs = 0.0;           ///< [m]
  double tp = 0.0;           ///< [s]
  std::optional<double> tz;  ///< [s]
};

struct WaveFileContent {
  std::vector<SpectrumPoint> spectrum;  ///< Empty in a file of sea states.
  SpectrumDirections directions;
  std::optional<FileSeaState> state;
  std::optional<double> from;  ///< Azimuth from which the waves come, of several the mean [rad].
  Assumptions assumptions;     ///< Conversions and interpretations.
};

/// A file and the choices among its contents.
struct WaveFileRequest {
  TimeChoice time;              ///< With the path.
  std::optional<int> location;  ///< From 1.
  std::string location_key;     ///< "environment.waves.location"
  std::string_view text;

  const std::string& path() const { return time.path; }
};

/// Checks densities that are linear between points: at least two, increasing frequencies, some energy, a height that
/// seas have. Errors name the file; doubtful steepness is a warning. Returns false after an error.
bool check_file_spectrum(const std::vector<SpectrumPoint>& points, const std::string& path, Diagnostics& diagnostics);

/// Returns the mean azimuth of a spectrum with directions, by the variance of each point; empty if it has none.
std::optional<double> mean_azimuth(const std::vector<SpectrumPoint>& points, const SpectrumDirections& directions);

}  // namespace overbend
