/// Parser of units with the grammar, the names and the arithmetic of UDUNITS-2: "kN/m^2", "kilonewton per
/// square_meter", "degF", "lg(re 1 mW)". A test compares it with the library: scales have the same bits. The texts that
/// it reads otherwise, such as dates with hyphens and exponents beyond 32 bits, are listed there.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "base/unit_table.h"

namespace overbend {

/// Unit as a scale and an offset of a product of base units, or of the logarithm of such a unit.
struct ParsedUnit {
  double scale = 1.0;
  double offset = 0.0;                      ///< Zero point in this unit: 273.15 for degC, NaN for a date.
  bool logarithmic = false;                 ///< The powers are then those of the reference.
  std::array<int, kBaseUnits> powers = {};  ///< Powers of the base units.

  /// True if a value converts by a factor alone.
  bool is_scale() const { return offset == 0.0 && !logarithmic; }
};

/// Reads a unit in UTF-8 without white space at its ends; empty if it is none.
std::optional<ParsedUnit> parse_unit(std::string_view text);

}  // namespace overbend
