/// Texts of inputs, results and effects for readers, common to terminal, report and page.
#pragma once

#include <fmt/format.h>

#include <string>

#include "base/shown_unit.h"
#include "base/units.h"
#include "results/sensitivity_results.h"

namespace overbend {

/// Returns a value of the input in the unit of the model file: "-8.371 m".
inline std::string value_text(const SensitivityInput& input, double value, int digits = 6) {
  return input.show.empty() ? format_number(value, digits) : format_quantity(value, input.unit, input.show, digits);
}

/// Returns the tolerance of the input in the unit of the model file.
inline std::string tolerance_text(const SensitivityInput& input) {
  return value_text(input, input.tolerance, 4);
}

/// Returns a value of the result, or a change of it with its sign, in the unit shown: "+12.3 kN".
inline std::string result_text(const SensitivityOutput& result, double value, bool with_sign) {
  const ShownUnit unit = shown_unit(result.name, result.unit);
  const std::string number = format_number(value * unit.factor, with_sign ? 3 : 5);
  return (with_sign && value > 0.0 ? "+" : "") + number + (unit.name.empty() ? "" : " " + std::string(unit.name));
}

/// Returns "stinger 7 closes at -8.365 m"; empty if the derivative holds in both directions.
inline std::string contact_text(const SensitivityInput& input, const Derivative& slope) {
  if (!slope.one_sided()) return "";
  return fmt::format("{} {} at {}", slope.support, slope.closes ? "closes" : "opens", value_text(input, slope.until));
}

}  // namespace overbend
