/// Lines of calculation sheets on design load effects: static load effects times load factors, or those of a run.
#pragma once

#include "checks/calculation_sheet.h"
#include "checks/check_station.h"

namespace overbend {

/// M_Sd and S_Sd.
void add_design_loads(CalculationSheet& sheet, const CheckStations& all, const CheckStation& station,
                      const CheckSettings& settings);

/// eps_Sd.
void add_design_strain(CalculationSheet& sheet, const CheckStations& all, const CheckStation& station,
                       const CheckSettings& settings);

}  // namespace overbend
