#include "seafiles/wave_column.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"

namespace overbend {
namespace {

/// Smallest and largest value of waves; the limits of zero and infinite frequency are left out.
struct Extent {
  double smallest = kInfinity, largest = 0.0;
};

Extent extent(const std::vector<double>& values) {
  Extent extent;
  for (const double value : values) {
    if (!(value > 0.0)) continue;
    extent.smallest = std::min(extent.smallest, value);
    extent.largest = std::max(extent.largest, value);
  }
  return extent;
}

}  // namespace

double column_frequency(const WaveColumnSettings& settings, double value) {
  const WaveColumn column = settings.stated.value_or(WaveColumn::periods);
  if (column == WaveColumn::periods) {
    return value > 0.0 ? kTurn / value : value == 0.0 ? kInfinity : 0.0;
  }
  if (value <= 0.0) return value == 0.0 ? 0.0 : kInfinity;
  if (column == WaveColumn::rad_per_s) return value;
  const double k = value / settings.length_scale;
  const double finite = column == WaveColumn::wavenumbers ? std::tanh(k * settings.depth) : 1.0;
  return std::sqrt(settings.gravity * k * finite);
}

std::string column_words(const WaveColumnSettings& settings, double value) {
  switch (settings.stated.value_or(WaveColumn::periods)) {
    case WaveColumn::periods:
      return fmt::format("the period {:.9g} s", value);
    case WaveColumn::rad_per_s:
      return fmt::format("the frequency {:.9g} rad/s", value);
    case WaveColumn::deep_wavenumbers:
    case WaveColumn::wavenumbers:
      break;
  }
  return fmt::format("the wave number {:.9g}", value);
}

void check_column(const WaveColumnSettings& settings, const std::vector<double>& values, const std::string& file,
                  const std::string& key, Diagnostics& diagnostics) {
  // A sea has no period of less than a second that moves a vessel, and always some of more than four.
  constexpr double kShortest = 0.7, kLongest = 4.0, kLongestOfAll = 10.0, kFastest = 12.0;
  const Extent found = extent(values);
  if (!(found.largest > 0.0)) return;
  const std::string range =
      fmt::format("values from {:.4g} to {:.4g} in the first column", found.smallest, found.largest);
  if (!settings.stated && (found.largest < kLongest || (found.largest < kLongestOfAll && found.smallest < kShortest))) {
    diagnostics.add({Severity::error, file, 0, 0, "", range, "wave periods in s",
                     "frequencies or wave numbers (IPEROUT of WAMIT)? " + key +
                         " says what it holds: " + "periods, rad_per_s, deep_wavenumbers or wavenumbers"});
  }
  if (settings.stated == WaveColumn::rad_per_s && found.largest > kFastest && found.smallest > kShortest) {
    diagnostics.add({Severity::warning, file, 0, 0, "",
                     range + " are taken as frequencies in rad/s, as " + key + " says; they look like periods", "",
                     ""});
  }
}

}  // namespace overbend
