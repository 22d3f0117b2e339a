#include "checks/api_sheet.h"

#include <fmt/format.h>

#include "checks/dnv_section_lines.h"
#include "model/description/description_enum_names.h"

namespace overbend {
namespace {

constexpr Confirmation kOne = Confirmation::one_source, kTwo = Confirmation::two_sources;
constexpr Confirmation kNone = Confirmation::unconfirmed;

void add_pipe(CalculationSheet& sheet, const CheckSection& section) {
  sheet.given("D", "nominal outside diameter of the steel", section.api.diameter, "m", "steel.outside_diameter");
  sheet.given("t", "nominal wall", section.api.wall, "m", "steel.wall_thickness");
  sheet.given("SMYS", "specified minimum yield strength S", section.api.yield_stress, "Pa", "steel.yield_stress");
}

void add_collapse(CalculationSheet& sheet, const ApiPipe& pipe) {
  sheet.given("E", "Young's modulus", pipe.youngs_modulus, "Pa", "steel.youngs_modulus");
  sheet.given("nu", "Poisson's ratio", pipe.poissons_ratio, "1", "steel.poissons_ratio");
  sheet.computed({"P_y", "yield pressure at collapse", "2 SMYS t/D", "Pa", "4.3.2.1", kTwo, kApiCollapse},
                 api_yield_pressure(pipe));
  sheet.computed({"P_e", "elastic collapse pressure", "2 E (t/D)^3/(1 - nu^2)", "Pa", "4.3.2.1", kTwo, kApiCollapse},
                 api_elastic_pressure(pipe));
  sheet.computed({"P_c", "collapse pressure", "P_y P_e/sqrt(P_y^2 + P_e^2)", "Pa", "4.3.2.1", kTwo, kApiCollapse},
                 api_collapse_pressure(pipe));
}

void add_collapse_factor(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings) {
  if (settings.api.collapse_factor) {
    sheet.given("f_o", "collapse factor", section.api_collapse_share, "1", "checks.api.collapse_factor");
    return;
  }
  const std::string_view manufacture = enum_name(settings.manufacture.value_or(Manufacture::uoe));
  sheet.computed({"f_o", "collapse factor: 0.6 of uoe and uo, otherwise 0.7", "", "1",
                  fmt::format("4.3.2.1, {} ({})", manufacture,
                              settings.manufacture ? "checks.manufacture" : "checks.manufacture not given"),
                  kTwo, kApiCollapse},
                 section.api_collapse_share);
}

/// Adds f_c, preceded by g.
void add_combined_factor(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings) {
  constexpr const char* kMeaning = "collapse factor for bending with external pressure";
  sheet.given("delta", "ovality (D_max - D_min)/(D_max + D_min)", section.api_delta, "1",
              settings.api.ovality ? "checks.api.ovality" : "half of checks.ovality");
  sheet.computed({"g", "collapse reduction factor of the ovality", "1/(1 + 20 delta)", "1", "4.3.2.2", kNone},
                 api_ovality_factor(section.api_delta));
  if (settings.api.combined_collapse_factor) {
    sheet.given("f_c", kMeaning, section.api_pressure_factor, "1", "checks.api.combined_collapse_factor");
    return;
  }
  if (settings.api.edition == ApiEdition::third) {
    sheet.computed({"f_c", kMeaning, "", "1", "4.3.2.2, third edition", kNone}, section.api_pressure_factor);
    return;
  }
  add_collapse_factor(sheet, section, settings);
  sheet.computed({"f_c", "collapse factor for bending with external pressure, as recommended; up to 1 for installation",
                  "min(1, f_o/g)", "1", "4.3.2.2, since the fourth edition", kOne, kApiFactor},
                 section.api_pressure_factor);
}

void add_strain(CalculationSheet& sheet, const CheckSection& section, const CheckStation& station,
                const CheckSettings& settings) {
  sheet.given("eps_1", "installation strain, the largest longitudinal one", station.max_strain.value, "1", "analysis");
  sheet.given("SAF", "strain factor of field joints", section.strain_factor, "1", "pipe.joint.strain_factor");
  sheet.computed(
      {"f_1", "bending safety factor of installation", "", "1", "4.3.2.2 (checks.api.bending_factor)", kNone},
      settings.api.bending_factor);
  sheet.computed({"eps_b", "buckling strain under pure bending", "t/(2 D)", "1", "4.3.2.2", kOne, kBuckling},
                 api_buckling_strain(section.api));
}

void add_tension(CalculationSheet& sheet, const CheckSection& section, const CheckStation& station) {
  sheet.given("T_eff", "effective tension", station.max_tension.value, "N", "analysis");
  sheet.computed({"T_y", "yield tension", "SMYS pi (D - t) t", "N", "4.3.1.1", kTwo, kApiOther},
                 api_yield_tension(section.api));
}

void add_burst(CalculationSheet& sheet, const CheckSection& section) {
  const char* const origin = section.grade_of_smts.empty() ? "steel.tensile_strength" : "API 5L grade of SMYS";
  sheet.given("SMTS", "specified minimum ultimate tensile strength U", section.smts, "Pa", origin);
  sheet.computed(
      {"P_b", "burst pressure, D_i = D - 2 t", "0.45 (SMYS + SMTS) ln(D/(D - 2 t))", "Pa", "4.3.1", kTwo, kApiOther},
      api_burst_pressure(section.api, section.smts));
}

}  // namespace

std::vector<SheetLine> api_collapse_sheet(const CheckStations& all, const CheckStation& station,
                                          const CheckSettings& settings, double utilisation) {
  const CheckSection& section = all.section_for(station);
  CalculationSheet sheet;
  add_pipe(sheet, section);
  add_collapse(sheet, section.api);
  add_collapse_factor(sheet, section, settings);
  add_static_pressure(sheet, station);
  sheet.computed({"U", "utilisation", "max(dp, 0)/(f_o P_c)", "1", "4.3.2.1", kTwo, kApiCollapse}, utilisation);
  return sheet.lines;
}

std::vector<SheetLine> api_propagation_sheet(const CheckStations& all, const CheckStation& station,
                                             double utilisation) {
  const CheckSection& section = all.section_for(station);
  CalculationSheet sheet;
  add_pipe(sheet, section);
  sheet.computed({"P_p", "propagation pressure", "24 SMYS (t/D)^2.4", "Pa", "4.3.2.3", kTwo, kApiOther},
                 api_propagation_pressure(section.api));
  sheet.computed({"f_p", "propagation factor", "", "1", "4.3.2.3", kTwo, kApiOther}, kApiPropagationFactor);
  add_static_pressure(sheet, station);
  sheet.computed({"U", "utilisation", "max(dp, 0)/(f_p P_p)", "1", "4.3.2.3", kTwo, kApiOther}, utilisation);
  return sheet.lines;
}

std::vector<SheetLine> api_bending_sheet(const CheckStations& all, const CheckStation& station,
                                         const CheckSettings& settings, double utilisation) {
  const CheckSection& section = all.section_for(station);
  CalculationSheet sheet;
  add_pipe(sheet, section);
  add_strain(sheet, section, station, settings);
  add_collapse(sheet, section.api);
  add_combined_factor(sheet, section, settings);
  add_static_pressure(sheet, station);
  sheet.computed({"U", "utilisation, D/t <= 50", "(f_1 SAF eps_1/eps_b + max(dp, 0)/(f_c P_c))/g", "1", "4.3.2.2", kTwo,
                  kApiBending},
                 utilisation);
  return sheet.lines;
}

std::vector<SheetLine> api_tension_sheet(const CheckStations& all, const CheckStation& station, double utilisation) {
  const CheckSection& section = all.section_for(station);
  CalculationSheet sheet;
  add_pipe(sheet, section);
  add_tension(sheet, section, station);
  sheet.computed({"U", "utilisation", "max(T_eff, 0)/(0.60 T_y)", "1", "4.3.1.1", kTwo, kApiOther}, utilisation);
  return sheet.lines;
}

std::vector<SheetLine> api_combined_sheet(const CheckStations& all, const CheckStation& station, double limit,
                                          double utilisation) {
  const CheckSection& section = all.section_for(station);
  CalculationSheet sheet;
  add_pipe(sheet, section);
  add_tension(sheet, section, station);
  add_burst(sheet, section);
  add_static_pressure(sheet, station);
  sheet.computed({"k", "limit: 0.90 functional, 0.96 extreme loads; one public text has 0.96 for installation", "", "1",
                  all.in_time ? "4.3.1.2, extreme" : "4.3.1.2, functional, the conservative reading", kOne,
                  "Riser Design Analysis Tool"},
                 limit);
  sheet.computed(
      {"U", "utilisation", "sqrt((dp/P_b)^2 + (T_eff/T_y)^2)/k", "1", "4.3.1.2", kOne, "Riser Design Analysis Tool"},
      utilisation);
  return sheet.lines;
}

}  // namespace overbend
