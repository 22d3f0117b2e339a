/// The table of checks as text for spreadsheets, and its display units.
#pragma once

#include <string>
#include <vector>

#include "base/shown_unit.h"
#include "results/check_results.h"

namespace overbend {

/// Returns the display unit of demand and capacity of a check: kN, kN m, MPa, kN/m; a strain in %.
ShownUnit check_unit(const CheckRow& row);

/// Returns the same for an input of a check; lengths are those of a section and in mm.
ShownUnit check_unit(const CheckInput& input);

/// Returns the text of checks.csv: a row per check, with the units of the other tables next to demand and capacity.
std::string checks_table(const CheckTable& table);

/// Returns the text of calculation_sheet.csv: a row per line of the calculation sheets, values in SI units.
std::string calculation_sheet_table(const CheckTable& table);

/// The checks of a stage of an operation.
struct StageChecks {
  std::string stage;
  const CheckTable& checks;
};
/// Return the same two texts for all stages, with the name of the stage in the first column.
std::string checks_table(const std::vector<StageChecks>& stages);
std::string calculation_sheet_table(const std::vector<StageChecks>& stages);

}  // namespace overbend
