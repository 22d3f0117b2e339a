/// The table of checks as text for spreadsheets, and the units it is read in.
#pragma once

#include <string>
#include <vector>

#include "base/shown_unit.h"
#include "results/check_results.h"

namespace overbend {

/// What people read demand and capacity of a check in: kN, kN m, MPa, kN/m; a strain in %.
ShownUnit check_unit(const CheckRow& row);

/// The same for a number that went in; lengths, which are those of a section, in mm.
ShownUnit check_unit(const CheckInput& input);

/// The text of checks.csv: a row per check, the units of the other tables beside demand and capacity.
std::string checks_table(const CheckTable& table);

/// The text of calculation_sheet.csv: a row per line of the calculation sheets, values in SI units.
std::string calculation_sheet_table(const CheckTable& table);

/// The checks of a stage of an operation.
struct StageChecks {
  std::string stage;
  const CheckTable& checks;
};
/// The same two texts of all stages, the name of the stage in the first column.
std::string checks_table(const std::vector<StageChecks>& stages);
std::string calculation_sheet_table(const std::vector<StageChecks>& stages);

}  // namespace overbend
