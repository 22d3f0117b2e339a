/// Formulas of calculation sheets with the numbers put in. The page sets their symbols
/// (web/src/components/Formula.tsx).
#pragma once

#include <string>
#include <vector>

#include "results/check_results.h"

namespace overbend {

/// Six digits, without an exponent where that is possible.
std::string six_digits(double value);

/// Value with its unit, as people read it: "448 MPa".
std::string value_text(const SheetLine& line);

/// A line's formula with the values of the lines before it in place of their symbols, as plain text; empty for an
/// input.
std::string numbers_put_in(const std::vector<SheetLine>& lines, std::size_t line);

}  // namespace overbend
