/// Evaluates formulas of calculation sheets: an evaluation of the printed text, apart from the program's functions.
#pragma once

#include <map>
#include <string>

namespace overbend::testing {

/// Values by symbol. Throws std::runtime_error for an unknown symbol or a text that is no formula.
double formula_value(const std::string& formula, const std::map<std::string, double>& values);

}  // namespace overbend::testing
