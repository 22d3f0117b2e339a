#include "checks/dnv_sheet.h"

#include <fmt/format.h>

#include <cmath>

#include "checks/design_effect_lines.h"
#include "checks/dnv_section_lines.h"
#include "checks/dnv_strength.h"
#include "model/description/description_enum_names.h"

namespace overbend {
namespace {

constexpr Confirmation kOne = Confirmation::one_source, kTwo = Confirmation::two_sources;
constexpr const char* kCombined = "5.4.6";

void add_slenderness_factor(CalculationSheet& sheet, const CheckSection& section) {
  const double slenderness = section.wall.slenderness();
  const char* const formula = slenderness < 15.0 ? "0.5" : slenderness > 60.0 ? "0" : "(60 - D/t_2)/90";
  sheet.computed({"beta", "slenderness factor: 0.5 below D/t_2 = 15, straight to 0 at 60", formula, "1", kCombined,
                  kOne, kDnvCombined},
                 section.load.beta);
  sheet.computed({"alpha_c", "flow stress factor", "1 - beta + beta f_u/f_y", "1", kCombined, kOne, kDnvCombined},
                 section.load.alpha_c);
}

void add_plastic_capacities(CalculationSheet& sheet, const CheckSection& section) {
  sheet.computed({"S_p", "plastic axial force", "f_y pi (D - t_2) t_2", "N", kCombined, kTwo, kDnvPlastic},
                 plastic_axial_force(section.wall, section.fy));
  sheet.computed({"M_p", "plastic moment", "f_y (D - t_2)^2 t_2", "N m", kCombined, kTwo, kDnvPlastic},
                 plastic_moment(section.wall, section.fy));
}

/// Adds the moment part; the point load factor only if rollers are to be considered.
void add_moment_term(CalculationSheet& sheet, const CheckStation& station, const CheckSettings& settings, bool in_time,
                     double term) {
  constexpr const char* kMeaning = "moment part of the utilisation";
  if (!settings.point_load && station.share == 1.0) {
    sheet.computed({"m", kMeaning, "gamma_m gamma_SC M_Sd/(alpha_c M_p)", "1", kCombined, kOne, kDnvCombined}, term);
    return;
  }
  if (!in_time) sheet.given("R", "largest force of a roller at the station", station.roller_force, "N", "static state");
  sheet.computed(
      {"alpha_pm", "reduction of the plastic moment by a roller force",
       in_time ? "" : "max(0.05, 1 - D/t_2/130 R/(3.9 f_y t_2^2))", "1", "since 2012", Confirmation::unconfirmed},
      station.share);
  sheet.computed({"m", kMeaning, "gamma_m gamma_SC M_Sd/(alpha_c alpha_pm M_p)", "1", kCombined, kOne, kDnvCombined},
                 term);
}

void add_pressure_term(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings,
                       double difference, const LoadTerms& terms) {
  if (difference >= 0.0) {
    add_fabrication_factor(sheet, section, settings);
    add_collapse_pressure(sheet, section, settings, false);
    sheet.computed({"q", "pressure part, p_e >= p_i", "gamma_m gamma_SC dp/p_c", "1", kCombined, kOne, kDnvCombined},
                   std::sqrt(terms.pressure));
    return;
  }
  const double ratio = -difference / section.load.burst;
  sheet.computed({"alpha_p", "1 - beta below p_i - p_e = 2/3 p_b, then to 1 at p_b",
                  ratio < 2.0 / 3.0 ? "1 - beta" : "1 - 3 beta max(0, 1 + dp/p_b)", "1", kCombined, kOne, kDnvCombined},
                 burst_share_factor(section.load.beta, ratio));
  sheet.computed({"q", "pressure part, p_i > p_e", "alpha_p (-dp)/(alpha_c p_b)", "1", kCombined, kOne, kDnvCombined},
                 std::sqrt(terms.pressure));
}

/// Adds girth weld factor and characteristic strain, increased by internal overpressure.
void add_strain_capacity(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings,
                         double difference) {
  const bool raised = difference < 0.0 && section.strain.burst > 0.0;
  const bool compact = section.wall.slenderness() <= 20.0;
  if (raised) add_burst_pressure(sheet, section);
  sheet.given("alpha_h", "largest ratio of yield stress to tensile strength", settings.alpha_h, "1", "checks.alpha_h");
  sheet.computed({"alpha_gw", "girth weld factor: 1 up to D/t_2 = 20, then falling", compact ? "1" : "1.2 - 0.01 D/t_2",
                  "1", kCombined, Confirmation::unconfirmed, "0.60 at D/t_2 = 60: RigidPipe"},
                 girth_weld_factor(section.wall.slenderness()));
  sheet.computed({"eps_c", "characteristic strain capacity",
                  fmt::format("0.78 (t_2/D - 0.01) {}alpha_h^(-1.5) alpha_gw", raised ? "(1 - 5.75 dp/p_b) " : ""), "1",
                  kCombined, kOne, kDnvCombined},
                 section.strain_capacity * internal_pressure_factor(-difference, section.strain.burst));
}

}  // namespace

std::vector<SheetLine> dnv_collapse_sheet(const CheckStations& all, const CheckStation& station,
                                          const CheckSettings& settings, double utilisation) {
  const CheckSection& section = all.section_for(station);
  CalculationSheet sheet;
  add_wall(sheet, section, settings, true);
  add_yield_strength(sheet, section, settings);
  add_fabrication_factor(sheet, section, settings);
  add_collapse_pressure(sheet, section, settings, true);
  add_resistance_factors(sheet, settings);
  add_static_pressure(sheet, station);
  sheet.computed({"U", "utilisation", "gamma_m gamma_SC max(dp, 0)/p_c", "1", "5.4.4, eq. 5.12", kTwo, kDnvPressure},
                 utilisation);
  return sheet.lines;
}

std::vector<SheetLine> dnv_propagation_sheet(const CheckStations& all, const CheckStation& station,
                                             const CheckSettings& settings, double utilisation) {
  CalculationSheet sheet;
  add_propagation_pressure(sheet, all.section_for(station), settings);
  add_resistance_factors(sheet, settings);
  add_static_pressure(sheet, station);
  sheet.computed({"U", "utilisation, 15 < D/t_2 < 45", "gamma_m gamma_SC max(dp, 0)/p_pr", "1", "5.4.5", kTwo, kDnvTwo},
                 utilisation);
  return sheet.lines;
}

std::vector<SheetLine> dnv_crossover_sheet(const CheckStations& all, const CheckStation& station,
                                           const CheckSettings& settings, double utilisation) {
  const CheckSection& section = all.section_for(station);
  const ArrestorSettings& arrestor = *settings.arrestor;
  CalculationSheet sheet;
  add_propagation_pressure(sheet, section, settings);
  sheet.given("p_BA", "propagation pressure of the arrestor", arrestor.propagation_pressure, "Pa",
              "checks.arrestor.propagation_pressure");
  sheet.given("L_BA", "length of the arrestor", arrestor.length, "m", "checks.arrestor.length");
  sheet.computed({"p_X", "cross-over pressure", "p_pr + (p_BA - p_pr) (1 - exp(-20 t_2 L_BA/D^2))", "Pa",
                  "5.4.5, eq. 5.22 and 5.23", kOne, kDnvArrestor},
                 crossover_pressure(section.wall, section.propagation, arrestor.propagation_pressure, arrestor.length));
  add_resistance_factors(sheet, settings);
  add_static_pressure(sheet, station);
  sheet.computed(
      {"U", "utilisation", "1.1 gamma_m gamma_SC max(dp, 0)/p_X", "1", "5.4.5, eq. 5.22 and 5.23", kOne, kDnvArrestor},
      utilisation);
  return sheet.lines;
}

std::vector<SheetLine> dnv_load_sheet(const CheckStations& all, const CheckStation& station,
                                      const CheckSettings& settings, const LoadTerms& terms) {
  const CheckSection& section = all.section_for(station);
  CalculationSheet sheet;
  add_design_loads(sheet, all, station, settings);
  add_wall(sheet, section, settings, false);
  add_yield_strength(sheet, section, settings);
  add_burst_pressure(sheet, section);
  add_resistance_factors(sheet, settings);
  add_slenderness_factor(sheet, section);
  add_plastic_capacities(sheet, section);
  add_pressure_difference(sheet, all, station, station.load_pressure);
  add_moment_term(sheet, station, settings, all.in_time, terms.moment);
  sheet.computed({"s", "axial part of the utilisation, |S_Sd| < 0.4 S_p", "gamma_m gamma_SC S_Sd/(alpha_c S_p)", "1",
                  kCombined, kOne, kDnvCombined},
                 terms.axial);
  add_pressure_term(sheet, section, settings, station.load_pressure, terms);
  sheet.computed({"U", "utilisation, 15 <= D/t_2 <= 45", "(m + s^2)^2 + q^2", "1", kCombined, kOne, kDnvCombined},
                 terms.utilisation());
  return sheet.lines;
}

std::vector<SheetLine> dnv_strain_sheet(const CheckStations& all, const CheckStation& station,
                                        const CheckSettings& settings, const StrainTerms& terms) {
  const CheckSection& section = all.section_for(station);
  const bool external = station.bend_pressure >= 0.0;
  CalculationSheet sheet;
  add_design_strain(sheet, all, station, settings);
  add_wall(sheet, section, settings, false);
  add_yield_strength(sheet, section, settings);
  add_pressure_difference(sheet, all, station, station.bend_pressure);
  add_strain_capacity(sheet, section, settings, station.bend_pressure);
  sheet.computed(
      {"gamma_eps", "resistance factor on strain, gamma_SC,DC", "", "1",
       fmt::format("{}, {} (checks.safety_class)", kCombined, enum_name(settings.safety_class)), kOne, kDnvCombined},
      strain_safety_factor(settings.safety_class));
  if (external) {
    add_fabrication_factor(sheet, section, settings);
    add_collapse_pressure(sheet, section, settings, false);
    add_resistance_factors(sheet, settings);
  }
  sheet.computed({"U", external ? "utilisation, p_e >= p_i, D/t_2 < 45" : "utilisation, p_i > p_e, D/t_2 < 45",
                  external ? "(gamma_eps eps_Sd/eps_c)^0.8 + gamma_m gamma_SC dp/p_c" : "gamma_eps eps_Sd/eps_c", "1",
                  kCombined, kOne, kDnvCombined},
                 terms.utilisation());
  return sheet.lines;
}

}  // namespace overbend
