#include "seafiles/wave_column.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/constants.h"
#include "base/text.h"

namespace overbend {
namespace {

/// Minimum, maximum and number of distinct values, without the limits of zero and infinite frequency.
struct Extent {
  double min_value = kInfinity, max_value = 0.0;
  std::size_t count = 0;
};

/// Length of deep-water waves of a period [s].
double deep_wave_length(double period) {
  return kGravity * period * period / kTurn;
}

Extent extent(const std::vector<double>& values) {
  Extent extent;
  std::set<double> distinct;
  for (const double value : values) {
    if (!(value > 0.0)) continue;
    distinct.insert(value);
    extent.min_value = std::min(extent.min_value, value);
    extent.max_value = std::max(extent.max_value, value);
  }
  extent.count = distinct.size();
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
  if (column == WaveColumn::hz) return kTurn * value;
  const double k = value / settings.length_scale;
  const double finite = column == WaveColumn::wavenumbers ? std::tanh(k * settings.depth) : 1.0;
  return std::sqrt(settings.gravity * k * finite);
}

std::string column_label(const WaveColumnSettings& settings, double value) {
  switch (settings.stated.value_or(WaveColumn::periods)) {
    case WaveColumn::periods:
      return fmt::format("the period {:.9g} s", value);
    case WaveColumn::rad_per_s:
      return fmt::format("the frequency {:.9g} rad/s", value);
    case WaveColumn::hz:
      return fmt::format("the frequency {:.9g} Hz", value);
    case WaveColumn::deep_wavenumbers:
    case WaveColumn::wavenumbers:
      break;
  }
  return fmt::format("the wave number {:.9g}", value);
}

void check_column(const WaveColumnSettings& settings, const std::vector<double>& values, const std::string& file,
                  const std::string& key, Diagnostics& diagnostics) {
  constexpr double kMaxHertz = 2.0;
  // Periods below about 1 s do not move a vessel, and files of periods always include some above 4 s.
  constexpr double kMinPeriod = 0.7, kUsualPeriod = 4.0, kMaxPeriodWithShort = 10.0, kMaxFrequency = 12.0;
  const Extent found = extent(values);
  if (!(found.max_value > 0.0)) return;
  const std::string range =
      fmt::format("{} values from {:.4g} to {:.4g} in the first column", found.count, found.min_value, found.max_value);
  if (!settings.stated &&
      (found.max_value < kUsualPeriod || (found.max_value < kMaxPeriodWithShort && found.min_value < kMinPeriod))) {
    diagnostics.add({Severity::error, file, 0, 0, "",
                     range + fmt::format(", which as periods in s are waves of {:.2g} to {:.2g} m length",
                                         deep_wave_length(found.min_value), deep_wave_length(found.max_value)),
                     "wave periods in s",
                     "frequencies or wave numbers (IPEROUT of WAMIT)? " + key +
                         " states the contents: " + join_items(enum_names<WaveColumn>(), "or")});
  }
  const bool hertz = settings.stated == WaveColumn::hz;
  const double max_frequency = hertz ? kMaxHertz : kMaxFrequency;
  if ((hertz || settings.stated == WaveColumn::rad_per_s) && found.max_value > max_frequency &&
      found.min_value > kMinPeriod) {
    diagnostics.add({Severity::warning, file, 0, 0, "",
                     range + " are used as frequencies in " + (hertz ? "Hz" : "rad/s") + ", as stated by " + key +
                         ", but look like periods",
                     "", ""});
  }
}

}  // namespace overbend
