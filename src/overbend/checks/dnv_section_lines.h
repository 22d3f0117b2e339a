/// Lines of calculation sheets that several checks to DNV-ST-F101 share: strength, wall, resistance factors, pressures.
#pragma once

#include "checks/calculation_sheet.h"
#include "checks/check_station.h"

namespace overbend {

/// Diameter and wall; the wall less its tolerance where `thinnest`. Names of the walls: t_2 and t_1.
void add_wall(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings, bool thinnest);

/// f_y and alpha_fab.
void add_yield_strength(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings);
void add_fabrication_factor(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings);

/// gamma_m and gamma_SC.
void add_resistance_factors(CalculationSheet& sheet, const CheckSettings& settings);

/// p_el, p_p and p_c of the wall t_1 or t_2, with E, nu and O_0.
void add_collapse_pressure(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings,
                           bool thinnest);

/// p_pr, with f_y and alpha_fab.
void add_propagation_pressure(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings);

/// f_u, f_cb and p_b.
void add_burst_pressure(CalculationSheet& sheet, const CheckSection& section);

/// dp = p_e - p_i at the static place of the station.
void add_static_pressure(CalculationSheet& sheet, const CheckStation& station);

/// dp with the load effects: of the static state, or of the governing instant.
void add_pressure_difference(CalculationSheet& sheet, const CheckStations& all, const CheckStation& station,
                             double difference);

}  // namespace overbend
