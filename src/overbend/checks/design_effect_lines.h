/// Calculation sheet lines for design load effects: static load effects times load factors, or those of a run.
#pragma once

#include "checks/calculation_sheet.h"
#include "checks/check_station.h"

namespace overbend {

/// Adds M_Sd and S_Sd.
void add_design_loads(CalculationSheet& sheet, const CheckStations& all, const CheckStation& station,
                      const CheckSettings& settings);

/// Adds eps_Sd.
void add_design_strain(CalculationSheet& sheet, const CheckStations& all, const CheckStation& station,
                       const CheckSettings& settings);

}  // namespace overbend
