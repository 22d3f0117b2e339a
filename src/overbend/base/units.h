/// Quantities with units: text such as "406.4 mm" to SI and back, by UDUNITS-2.
///
/// A dimension is named by its SI unit: "m", "N", "N/m", "N/m^2", "N/m^3", "s", "rad", "m/s", ... Angles are a
/// dimension of their own here (UDUNITS alone would take "3 deg" where a plain ratio is wanted). Spellings of this
/// trade are added to the library's own (base/unit_spelling.h). All functions may be called from several threads.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace overbend {

/// Reads a decimal number that fills the whole text: no octal or hexadecimal look, no leading zeros, no inf or nan.
std::optional<double> parse_number(std::string_view text);

/// A text read as a quantity, or why it is none.
struct QuantityReading {
  std::optional<double> value;  ///< In SI; empty when the text is not a quantity of the wanted dimension.
  std::string found;            ///< What the text is, for a message: "'89 kN' (a force)".
  std::string hint;             ///< How to correct it; may be empty.
  std::string remark = {};      ///< Of a value that was taken: which meaning of its unit; mostly empty.
};

/// Reads "number unit" as a quantity of the dimension whose SI unit is `si_unit`.
QuantityReading parse_quantity(std::string_view text, const std::string& si_unit);

/// What one `unit` is in `si_unit`; empty when the unit is unknown or of another dimension.
std::optional<double> unit_factor(const std::string& unit, const std::string& si_unit);

/// The dimension in words with its article: "a length", "a weight density".
std::string dimension_words(const std::string& si_unit);

/// The same without the article: "length".
std::string dimension_name(const std::string& si_unit);

/// Units people use for the dimension, most usual first.
std::vector<std::string> usual_units(const std::string& si_unit);

/// A value [SI] in `unit` as "406.4 mm", at most `digits` significant digits. The unit must measure
/// `si_unit`.
std::string format_quantity(double value, const std::string& si_unit, const std::string& unit, int digits = 6);

/// A number with at most `digits` significant digits: "0.25", "1e-09".
std::string format_number(double value, int digits = 6);

}  // namespace overbend
