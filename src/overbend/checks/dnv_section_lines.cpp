#include "checks/dnv_section_lines.h"

#include <fmt/format.h>

#include "checks/dnv_strength.h"
#include "model/description/description_enum_names.h"

namespace overbend {
namespace {

const char* wall_symbol(bool thinnest) {
  return thinnest ? "t_1" : "t_2";
}

Wall checked_wall(const CheckSection& section, bool thinnest) {
  Wall wall = section.wall;
  if (thinnest) wall.thickness = section.thinnest;
  return wall;
}

}  // namespace

void add_wall(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings, bool thinnest) {
  sheet.given("D", "nominal outside diameter of the steel", section.wall.diameter, "m", "steel.outside_diameter");
  sheet.given(thinnest ? "t" : "t_2", "nominal wall, no corrosion allowance", section.wall.thickness, "m",
              "steel.wall_thickness");
  if (!thinnest) return;
  sheet.given("t_fab", "negative fabrication tolerance of the wall", settings.wall_tolerance, "m",
              "checks.wall_tolerance");
  sheet.computed({"t_1", "wall less its tolerance", "t - t_fab", "m", "no corrosion allowance in installation"},
                 section.thinnest);
}

void add_yield_strength(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings) {
  sheet.given("SMYS", "specified minimum yield stress", section.smys, "Pa", "steel.yield_stress");
  sheet.given("alpha_U", "material strength factor", settings.alpha_u, "1", "checks.alpha_u");
  sheet.computed({"f_y", "characteristic yield strength, no derating", "alpha_U SMYS", "Pa", "5.3.3",
                  Confirmation::two_sources, kDnvTables},
                 section.fy);
}

void add_fabrication_factor(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings) {
  const std::string_view manufacture = enum_name(settings.manufacture.value_or(Manufacture::uoe));
  if (settings.alpha_fab) {
    sheet.given("alpha_fab", "fabrication factor", section.alpha_fab, "1", "checks.alpha_fab");
    return;
  }
  sheet.computed(
      {"alpha_fab", "fabrication factor", "", "1",
       fmt::format("table 5.4, {} ({})", manufacture,
                   settings.manufacture ? "checks.manufacture" : "least favourable, checks.manufacture not given"),
       Confirmation::two_sources, kDnvTables},
      section.alpha_fab);
}

void add_resistance_factors(CalculationSheet& sheet, const CheckSettings& settings) {
  sheet.computed({"gamma_m", "material resistance factor", "", "1", "table 5.1", Confirmation::two_sources, kDnvTables},
                 kMaterialResistance);
  sheet.computed({"gamma_SC", "safety class resistance factor", "", "1",
                  fmt::format("table 5.2, {} (checks.safety_class)", enum_name(settings.safety_class)),
                  Confirmation::two_sources, kDnvTables},
                 safety_class_factor(settings.safety_class));
}

void add_collapse_pressure(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings,
                           bool thinnest) {
  const char* const t = wall_symbol(thinnest);
  const Wall wall = checked_wall(section, thinnest);
  sheet.given("E", "Young's modulus", wall.youngs_modulus, "Pa", "steel.youngs_modulus");
  sheet.given("nu", "Poisson's ratio", wall.poissons_ratio, "1", "steel.poissons_ratio");
  sheet.given("O_0", "ovality (D_max - D_min)/D, at least 0.005", settings.ovality, "1", "checks.ovality");
  sheet.computed({"p_el", "elastic collapse pressure", fmt::format("2 E ({}/D)^3/(1 - nu^2)", t), "Pa",
                  "5.4.4, eq. 5.14", Confirmation::two_sources, kDnvPressure},
                 elastic_collapse_pressure(wall));
  sheet.computed({"p_p", "plastic collapse pressure", fmt::format("2 f_y alpha_fab {}/D", t), "Pa", "5.4.4, eq. 5.15",
                  Confirmation::two_sources, kDnvPressure},
                 plastic_collapse_pressure(wall, section.fy, section.alpha_fab));
  sheet.computed({"p_c", "characteristic collapse pressure",
                  fmt::format("(p_c - p_el) (p_c^2 - p_p^2) = p_c p_el p_p O_0 D/{}", t), "Pa", "5.4.4",
                  Confirmation::two_sources, kDnvPressure},
                 thinnest ? section.collapse_thinnest : section.collapse);
}

void add_propagation_pressure(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings) {
  add_wall(sheet, section, settings, false);
  add_yield_strength(sheet, section, settings);
  add_fabrication_factor(sheet, section, settings);
  sheet.computed({"p_pr", "propagation pressure", "35 f_y alpha_fab (t_2/D)^2.5", "Pa", "5.4.5, eq. 5.21",
                  Confirmation::two_sources, kDnvTwo},
                 section.propagation);
}

void add_burst_pressure(CalculationSheet& sheet, const CheckSection& section) {
  const char* const origin = section.grade_of_smts.empty() ? "steel.tensile_strength" : "API 5L grade of SMYS";
  sheet.given("SMTS", "specified minimum tensile strength", section.smts, "Pa", origin);
  sheet.computed(
      {"f_u", "characteristic tensile strength", "alpha_U SMTS", "Pa", "5.3.3", Confirmation::two_sources, kDnvTables},
      section.fu);
  sheet.computed(
      {"f_cb", "strength for burst", "min(f_y, f_u/1.15)", "Pa", "5.4.2", Confirmation::two_sources, kDnvBurst},
      burst_strength(section.fy, section.fu));
  sheet.computed(
      {"p_b", "burst pressure", "2 t_2/(D - t_2) f_cb 2/sqrt(3)", "Pa", "5.4.2", Confirmation::two_sources, kDnvBurst},
      section.load.burst);
}

void add_static_pressure(CalculationSheet& sheet, const CheckStation& station) {
  sheet.given("p_e", "external pressure, from the mean water level", station.external_pressure, "Pa", "static state");
  sheet.given("p_i", "internal pressure", station.external_pressure - station.overpressure, "Pa", "pipe.contents");
  sheet.computed({"dp", "external minus internal pressure", "p_e - p_i", "Pa", ""}, station.overpressure);
}

void add_pressure_difference(CalculationSheet& sheet, const CheckStations& all, const CheckStation& station,
                             double difference) {
  if (!all.in_time) {
    add_static_pressure(sheet, station);
    return;
  }
  sheet.given("dp", "external minus internal pressure p_e - p_i at the governing instant", difference, "Pa", "run");
}

}  // namespace overbend
