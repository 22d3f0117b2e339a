/// Calculation sheets of the checks to DNV-ST-F101, computed by the functions of the checks.
#pragma once

#include "checks/calculation_sheet.h"
#include "checks/check_station.h"

namespace overbend {

std::vector<SheetLine> dnv_collapse_sheet(const CheckStations& all, const CheckStation& station,
                                          const CheckSettings& settings, double utilisation);
std::vector<SheetLine> dnv_propagation_sheet(const CheckStations& all, const CheckStation& station,
                                             const CheckSettings& settings, double utilisation);
/// Only with `settings.arrestor`.
std::vector<SheetLine> dnv_crossover_sheet(const CheckStations& all, const CheckStation& station,
                                           const CheckSettings& settings, double utilisation);
std::vector<SheetLine> dnv_load_sheet(const CheckStations& all, const CheckStation& station,
                                      const CheckSettings& settings, const LoadTerms& terms);
std::vector<SheetLine> dnv_strain_sheet(const CheckStations& all, const CheckStation& station,
                                        const CheckSettings& settings, const StrainTerms& terms);

}  // namespace overbend
