/// Calculation sheet lines shared by several checks to DNV-ST-F101: strength, wall, resistance factors, pressures.
#pragma once

#include "checks/calculation_sheet.h"
#include "checks/check_station.h"

namespace overbend {

/// Adds diameter and wall; the wall minus its tolerance if `thinnest`. Symbols of the walls: t_2 and t_1.
void add_wall(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings, bool thinnest);

/// Adds f_y and alpha_fab.
void add_yield_strength(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings);
void add_fabrication_factor(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings);

/// Adds gamma_m and gamma_SC.
void add_resistance_factors(CalculationSheet& sheet, const CheckSettings& settings);

/// Adds p_el, p_p and p_c of the wall t_1 or t_2, with E, nu and O_0.
void add_collapse_pressure(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings,
                           bool thinnest);

/// Adds p_pr, with f_y and alpha_fab.
void add_propagation_pressure(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings);

/// Adds f_u, f_cb and p_b.
void add_burst_pressure(CalculationSheet& sheet, const CheckSection& section);

/// Adds dp = p_e - p_i at the static position of the station.
void add_static_pressure(CalculationSheet& sheet, const CheckStation& station);

/// Adds dp with the load effects: of the static state, or of the governing instant.
void add_pressure_difference(CalculationSheet& sheet, const CheckStations& all, const CheckStation& station,
                             double difference);

}  // namespace overbend
