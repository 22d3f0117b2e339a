/// The rows of the table of checks, by subject. Each list leaves out regions that the line does not have.
#pragma once

#include <vector>

#include "checks/check_station.h"

namespace overbend {

/// DNV-ST-F101: collapse, propagation, load and displacement controlled local buckling.
std::vector<CheckRow> dnv_rows(const CheckStations& all, const CheckSettings& settings);

/// Simplified laying criteria: strain over the supports, equivalent stress in the free span; fractions of yield.
std::vector<CheckRow> laying_rows(const CheckStations& all, const CheckSettings& settings);

/// API RP 1111.
std::vector<CheckRow> api_rows(const CheckStations& all, const CheckSettings& settings);

/// Rollers, coating, tensioner, stinger tip: those that have a limit. `dynamics` may be null.
std::vector<CheckRow> equipment_rows(const Model& model, const StaticResults& statics, const DynamicResults* dynamics);

/// Fatigue of welds while the pipe is laid, where the run counted it.
std::vector<CheckRow> fatigue_rows(const Model& model, const DynamicResults& dynamics);

/// Diameter over wall thickness up to which API's formulas of bending hold.
inline constexpr double kApiMostSlender = 50.0;
/// Utilisation by API RP 1111 for bending and external pressure at a station [-].
double api_bending_at(const CheckStations& all, const CheckStation& station, const CheckSettings& settings);

}  // namespace overbend
