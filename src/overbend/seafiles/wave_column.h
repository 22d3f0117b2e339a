/// First column of WAMIT numeric files: periods, or frequencies or wave numbers as set by IPEROUT.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/enum_names.h"

namespace overbend {

enum class WaveColumn {
  periods,           ///< [s]; 0: infinite frequency, -1: zero frequency.
  rad_per_s,         ///< 0: zero frequency, -1: infinite frequency, also below.
  hz,                ///< Cycles per second.
  deep_wavenumbers,  ///< omega^2 L / g.
  wavenumbers        ///< k L in the water depth.
};

template <>
inline constexpr std::array kEnumNames<WaveColumn> = {
    Word{WaveColumn::periods, "periods"}, Word{WaveColumn::rad_per_s, "rad_per_s"}, Word{WaveColumn::hz, "hz"},
    Word{WaveColumn::deep_wavenumbers, "deep_wavenumbers"}, Word{WaveColumn::wavenumbers, "wavenumbers"}};

/// Settings for reading the column.
struct WaveColumnSettings {
  std::optional<WaveColumn> stated = {};  ///< Default: periods.
  double length_scale = 1.0;              ///< L, ULEN of WAMIT [m].
  double gravity = 9.81;                  ///< [m/s2]
  double depth = 0.0;                     ///< Water depth [m].
};

/// Returns the angular frequency [rad/s] of a value; 0 or infinity for the limits.
double column_frequency(const WaveColumnSettings& settings, double value);

/// Returns a label such as "the period 5.7 s" or "the frequency 0.4 rad/s".
std::string column_label(const WaveColumnSettings& settings, double value);

/// Reports an error if the contents are not stated and the values cannot be periods, and a warning if they are stated
/// to be frequencies but look like periods. `key` is the model key that states the contents.
void check_column(const WaveColumnSettings& settings, const std::vector<double>& values, const std::string& file,
                  const std::string& key, Diagnostics& diagnostics);

}  // namespace overbend
