/// Quantities with units: text such as "406.4 mm" to SI and back. Units are those of UDUNITS-2 (base/unit_parser.h).
///
/// A dimension is identified by its SI unit: "m", "N", "N/m", "N/m^2", "N/m^3", "s", "rad", "m/s", ... Angles are a
/// separate dimension here (UDUNITS alone would accept "3 deg" for a plain ratio). Industry spellings are added
/// (base/unit_spelling.h). All functions are thread-safe.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace overbend {

/// Reads a decimal number that fills the whole text: not octal or hexadecimal, no leading zeros, no inf or nan.
std::optional<double> parse_number(std::string_view text);

/// Text read as a quantity, or the reason why it is none.
struct QuantityReading {
  std::optional<double> value;  ///< In SI; empty if the text is not a quantity of the required dimension.
  std::string found;            ///< Description of the text for a message: "'89 kN' (a force)".
  std::string hint;             ///< Suggested correction; may be empty.
  std::string remark = {};      ///< For an accepted value: the assumed meaning of its unit; mostly empty.
};

/// Reads "number unit" as a quantity of the dimension whose SI unit is `si_unit`.
QuantityReading parse_quantity(std::string_view text, const std::string& si_unit);

/// Returns the value of one `unit` in `si_unit`; empty if the unit is unknown or of another dimension.
std::optional<double> unit_factor(const std::string& unit, const std::string& si_unit);

/// Returns the dimension with its article: "a length", "a weight density".
std::string dimension_phrase(const std::string& si_unit);

/// Returns the dimension without the article: "length".
std::string dimension_name(const std::string& si_unit);

/// Returns usual units of the dimension, most usual first.
std::vector<std::string> usual_units(const std::string& si_unit);

/// Formats a value [SI] in `unit` as "406.4 mm", with at most `digits` significant digits. The unit must measure
/// `si_unit`.
std::string format_quantity(double value, const std::string& si_unit, const std::string& unit, int digits = 6);

/// Formats a number with at most `digits` significant digits: "0.25", "1e-09".
std::string format_number(double value, int digits = 6);

}  // namespace overbend
