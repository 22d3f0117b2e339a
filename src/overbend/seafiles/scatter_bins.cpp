#include "seafiles/scatter_bins.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/ranges.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/column_title.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

constexpr double kEven = 1e-6;  ///< Relative tolerance of spacings.

std::string bin_label(const ScatterBin& bin) {
  if (!bin.width) return format_number(bin.middle);
  return format_number(bin.middle - 0.5 * *bin.width) + "-" + format_number(bin.middle + 0.5 * *bin.width);
}

std::optional<ScatterPeriod> period_name(const std::string& name) {
  constexpr std::array<std::string_view, 5> kPeak = {"tp", "t_p", "peak period", "peak wave period", "tpeak"};
  constexpr std::array<std::string_view, 6> kMean = {"tz",   "t_z", "zero crossing period", "zero up-crossing period",
                                                     "tm02", "t02"};
  if (ranges::find(kPeak, name) != kPeak.end()) return ScatterPeriod::tp;
  if (ranges::find(kMean, name) != kMean.end()) return ScatterPeriod::tz;
  return std::nullopt;
}

bool is_height_name(const std::string& name) {
  constexpr std::array<std::string_view, 4> kNames = {"hs", "h_s", "hm0", "significant wave height"};
  return ranges::find(kNames, name) != kNames.end();
}

}  // namespace

std::optional<ScatterBin> parse_scatter_bin(std::string_view text) {
  if (const std::optional<double> middle = cell_number(text)) return ScatterBin{*middle, std::nullopt};
  constexpr std::array<std::string_view, 3> kMarks = {"\xe2\x80\x93", " to ", "-"};  // the first is an en dash
  for (const std::string_view mark : kMarks) {
    const std::size_t place = text.find(mark, 1);
    if (place == std::string_view::npos) continue;
    const auto from = cell_number(trim(text.substr(0, place)));
    const auto to = cell_number(trim(text.substr(place + mark.size())));
    if (!from || !to || *to <= *from) return std::nullopt;
    return ScatterBin{0.5 * (*from + *to), *to - *from};
  }
  return std::nullopt;
}

std::string complete_scatter_bins(std::vector<ScatterBin>& bins) {
  const bool centres = !bins.front().width.has_value();
  const double step = bins.size() > 1 ? bins[1].middle - bins[0].middle : 0.0;
  if (centres && step <= 0.0) return "that are not evenly spaced";
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (bins[i].width.has_value() == centres) return "of which some are ranges and some are not";
    if (i == 0) continue;
    const double gap = bins[i].middle - bins[i - 1].middle;
    const double expected = centres ? step : 0.5 * (*bins[i].width + *bins[i - 1].width);
    if (std::abs(gap - expected) <= kEven * expected) continue;
    return centres ? "that are not evenly spaced"
                   : "with " + bin_label(bins[i]) + " after " + bin_label(bins[i - 1]) +
                         ", that are not even or do not follow each other";
  }
  for (ScatterBin& bin : bins) bin.width = bin.width.value_or(step);
  return "";
}

ScatterCorner parse_scatter_corner(std::string_view text) {
  ScatterCorner corner;
  corner.plain = lower_case(text) == "hs_m";
  std::size_t from = 0;
  for (int part = 0; from <= text.size(); ++part) {
    const std::size_t to = std::min(text.find_first_of("/\\|", from), text.size());
    const ColumnTitle title = parse_column_title(text.substr(from, to - from));
    from = to + 1;
    if (part == 0 && is_height_name(title.name)) {
      const std::optional<double> factor = title_unit_factor(title.unit.empty() ? "m" : title.unit, "m");
      corner.height = factor.has_value();
      corner.height_factor = factor.value_or(1.0);
    } else if (part == 1) {
      const bool seconds = title.unit.empty() || title.unit == "s" || title.unit == "sec";
      if (seconds) corner.period = period_name(title.name);
    }
  }
  return corner;
}

}  // namespace overbend
