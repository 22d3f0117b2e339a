/// Heights and periods of a scatter diagram: centres of cells or ranges, and what the header says of them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/description/study_description.h"

namespace overbend {

/// Row or column of a diagram.
struct ScatterBin {
  double middle = 0.0;
  std::optional<double> width;  ///< Set if given as a range.
};

/// Parses "0.75" or a range "0.5-1", "0.5 to 1".
std::optional<ScatterBin> parse_scatter_bin(std::string_view text);

/// Returns why bins in ascending order are no axis: ranges that do not follow each other, or uneven centres; empty if
/// they are. Sets the widths of centres.
std::string complete_scatter_bins(std::vector<ScatterBin>& bins);

/// First cell of the header: "hs_m" or "Hs (m) / Tz (s)".
struct ScatterCorner {
  bool height = false;                  ///< True if it names the wave height, first.
  std::optional<ScatterPeriod> period;  ///< Period that it names.
  double height_factor = 1.0;           ///< To m.
  bool plain = false;                   ///< True for "hs_m".
};
ScatterCorner parse_scatter_corner(std::string_view text);

}  // namespace overbend
