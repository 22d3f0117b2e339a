/// Calculation sheets of the checks to API RP 1111, computed by the functions of the checks.
#pragma once

#include "checks/calculation_sheet.h"
#include "checks/check_station.h"

namespace overbend {

std::vector<SheetLine> api_collapse_sheet(const CheckStations& all, const CheckStation& station,
                                          const CheckSettings& settings, double utilisation);
std::vector<SheetLine> api_propagation_sheet(const CheckStations& all, const CheckStation& station, double utilisation);
std::vector<SheetLine> api_bending_sheet(const CheckStations& all, const CheckStation& station,
                                         const CheckSettings& settings, double utilisation);
std::vector<SheetLine> api_tension_sheet(const CheckStations& all, const CheckStation& station, double utilisation);
/// `limit`: limit of the combined load.
std::vector<SheetLine> api_combined_sheet(const CheckStations& all, const CheckStation& station, double limit,
                                          double utilisation);

}  // namespace overbend
