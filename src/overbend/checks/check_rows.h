/// Rows of the check table, by subject. Each list omits regions that the line does not have.
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

/// Limits of rollers, coating, tensioner and stinger tip, as far as given. `dynamics` may be null.
std::vector<CheckRow> equipment_rows(const Model& model, const StaticResults& statics, const DynamicResults* dynamics);

/// Fatigue of welds during laying, if counted in the run.
std::vector<CheckRow> fatigue_rows(const Model& model, const DynamicResults& dynamics);

/// Maximum ratio of diameter to wall thickness for API's bending formulas.
inline constexpr double kMaxApiSlenderness = 50.0;
/// Returns the utilisation by API RP 1111 for bending and external pressure at a station [-].
double api_bending_at(const CheckStations& all, const CheckStation& station, const CheckSettings& settings);

}  // namespace overbend
