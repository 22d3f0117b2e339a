/// The first column of WAMIT's numeric files: periods, or what IPEROUT asks for in their place.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/words.h"

namespace overbend {

enum class WaveColumn {
  periods,           ///< [s]; 0 infinite and -1 zero frequency.
  rad_per_s,         ///< 0 zero and -1 infinite frequency, here and below.
  deep_wavenumbers,  ///< omega^2 L / g.
  wavenumbers        ///< k L in the depth of the water.
};

template <>
inline constexpr std::array kWords<WaveColumn> = {
    Word{WaveColumn::periods, "periods"}, Word{WaveColumn::rad_per_s, "rad_per_s"},
    Word{WaveColumn::deep_wavenumbers, "deep_wavenumbers"}, Word{WaveColumn::wavenumbers, "wavenumbers"}};

/// How a column is read.
struct WaveColumnSettings {
  std::optional<WaveColumn> stated = {};  ///< Periods where not stated.
  double length_scale = 1.0;              ///< L, ULEN of WAMIT [m].
  double gravity = 9.81;                  ///< [m/s2]
  double depth = 0.0;                     ///< Of the water [m].
};

/// Angular frequency [rad/s] of a value: 0 or infinity for the limits.
double column_frequency(const WaveColumnSettings& settings, double value);

/// "the period 5.7 s", "the frequency 0.4 rad/s".
std::string column_words(const WaveColumnSettings& settings, double value);

/// Reports, as an error, a column that is not said to hold periods and cannot, by the size of its values; as a warning,
/// one that is said to hold frequencies and looks like periods. `key` is the key that says it.
void check_column(const WaveColumnSettings& settings, const std::vector<double>& values, const std::string& file,
                  const std::string& key, Diagnostics& diagnostics);

}  // namespace overbend
