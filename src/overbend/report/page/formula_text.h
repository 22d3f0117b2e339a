/// Formulas of calculation sheets with their numbers. The page typesets the symbols (web/src/components/Formula.tsx).
#pragma once

#include <string>
#include <vector>

#include "results/check_results.h"

namespace overbend {

/// Formats with six digits, without an exponent if possible.
std::string six_digits(double value);

/// Formats a value with its unit for readers: "448 MPa".
std::string value_text(const SheetLine& line);

/// Returns a line's formula with the values of the preceding lines in place of their symbols, as plain text; empty for
/// an input.
std::string substituted_formula(const std::vector<SheetLine>& lines, std::size_t line);

}  // namespace overbend
