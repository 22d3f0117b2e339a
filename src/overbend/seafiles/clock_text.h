/// Clock times and dates as instruments and spreadsheets write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace overbend {

/// Returns the seconds of "H:MM:SS" with an optional fraction after a point or comma; nothing for other text.
std::optional<double> parse_clock(std::string_view text);

/// A date with a time.
struct DateTime {
  double day = 0.0;      ///< Days since 1970-01-01.
  double seconds = 0.0;  ///< Since the start of the day, of UTC if the text states its distance from UTC [s].
};

/// Parses "2026-06-01T09:00:00.5Z", with a blank in place of T, with slashes, with "+02:00", or "01.06.2026 09:00:00".
/// Returns nothing for other text: days and months between slashes are ambiguous if the year is not first.
std::optional<DateTime> parse_date_time(std::string_view text);

/// Returns a Unix time [s] as "2026-06-01 08:00:00 UTC".
std::string unix_time_label(double seconds);

}  // namespace overbend
