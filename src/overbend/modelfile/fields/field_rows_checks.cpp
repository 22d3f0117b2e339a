#include "model/description/description_enum_names.h"
#include "modelfile/fields/field_rows.h"
#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {
namespace {

Range share() {
  return {.low = 0.0, .high = 1.5, .low_open = true};
}

Field number(const char* path, const Member& member, const char* text, Range range) {
  return {.path = path, .member = member, .kind = FieldKind::number, .text = text, .range = range};
}

/// Number whose absence disables a check or selects another source of the value.
Field open_number(const std::string& path, const Member& member, const char* text, const char* without, Range range) {
  return {.path = path,
          .member = member,
          .kind = FieldKind::number,
          .text = text,
          .fallback_text = without,
          .range = range};
}

Field limit(const char* key, std::optional<double> EquipmentLimits::*member, const char* text, const char* unit,
            const char* show) {
  return {.path = std::string("checks.limits.") + key,
          .member = fills(member),
          .kind = FieldKind::quantity,
          .text = text,
          .unit = unit,
          .show = show,
          .fallback_text = "not checked",
          .range = {.low = 0.0, .low_open = true}};
}

std::vector<Field> strength() {
  return {
      {.path = "checks.codes",
       .member = defaults(&CheckSettings::codes),
       .kind = FieldKind::choice,
       .text = "Codes used: DNV-ST-F101 (dnv), API RP 1111 (api), or both."},
      {.path = "checks.safety_class",
       .member = defaults(&CheckSettings::safety_class),
       .kind = FieldKind::choice,
       .text = "Safety class of DNV-ST-F101; low for installation."},
      {.path = "checks.manufacture",
       .member = fills(&CheckSettings::manufacture),
       .kind = FieldKind::choice,
       .text = "Manufacturing process; sets the fabrication factor of DNV and the collapse factor of API.",
       .fallback_text = "uoe, the least favourable, with a note"},
      number("checks.alpha_u", defaults(&CheckSettings::alpha_u),
             "Material strength factor: 0.96, or 1.00 with supplementary requirement U.", {.low = 0.5, .high = 1.0}),
      open_number("checks.alpha_fab", fills(&CheckSettings::alpha_fab),
                  "Fabrication factor on the compressive strength in the hoop direction.", "from the manufacture",
                  {.low = 0.5, .high = 1.0}),
      {.path = "checks.wall_tolerance",
       .member = defaults(&CheckSettings::wall_tolerance),
       .kind = FieldKind::quantity,
       .text = "Negative fabrication tolerance of the wall thickness; used for collapse.",
       .unit = "m",
       .show = "mm",
       .range = {.low = 0.0, .high = 1.0}},
      number("checks.ovality", defaults(&CheckSettings::ovality),
             "Out-of-roundness according to DNV, (largest - smallest diameter)/diameter.", {.low = 0.005, .high = 0.1}),
      number("checks.alpha_h", defaults(&CheckSettings::alpha_h), "Largest ratio of yield stress to tensile strength.",
             {.low = 0.5, .high = 1.0}),
      {.path = "checks.grade",
       .member = fills(&CheckSettings::grade),
       .kind = FieldKind::choice,
       .text = "Row of the simplified laying criteria.",
       .fallback_text = "nearest grade with equal or lower yield stress",
       .choices = {"X52", "X60", "X65", "X70"}},
  };
}

std::vector<Field> options() {
  return {
      number("checks.condition_factor", defaults(&CheckSettings::condition_factor),
             "gamma_C on functional load effects: 1 in water, 1.07 on an uneven seabed, 0.93 in a system test, 0.82 in "
             "reeling on and J-tube pull-in only.",
             {.low = 0.5, .high = 1.5}),
      {.path = "checks.system_effects",
       .member = defaults(&CheckSettings::system_effects),
       .kind = FieldKind::choice,
       .text = "yes: load combination a (1.2 functional, 0.7 environmental), for system effects, is checked in "
               "addition to b."},
      {.path = "checks.yield_basis",
       .member = defaults(&CheckSettings::yield_basis),
       .kind = FieldKind::choice,
       .text = "Yield stress in the limit 0.87 f_y: smys, or fy, which is alpha_u times SMYS."},
      {.path = "checks.current_load",
       .member = defaults(&CheckSettings::current_load),
       .kind = FieldKind::choice,
       .text = "Classification of the load effects of the steady current in the load combinations of DNV."},
      {.path = "checks.point_load",
       .member = defaults(&CheckSettings::point_load),
       .kind = FieldKind::choice,
       .text = "yes: the force of a roller reduces the plastic moment of the load-controlled check."},
      {.path = "checks.arrestor",
       .member = enters(&CheckSettings::arrestor),
       .text = "A buckle arrestor, for its cross-over pressure.",
       .fallback_text = "none"},
      {.path = "checks.arrestor.propagation_pressure",
       .member = fills(&ArrestorSettings::propagation_pressure),
       .kind = FieldKind::quantity,
       .text = "Propagation pressure of an infinitely long arrestor.",
       .unit = "N/m^2",
       .show = "MPa",
       .required = true,
       .range = {.low = 0.0, .low_open = true}},
      {.path = "checks.arrestor.length",
       .member = fills(&ArrestorSettings::length),
       .kind = FieldKind::quantity,
       .text = "Length of the arrestor.",
       .unit = "m",
       .show = "m",
       .required = true,
       .range = {.low = 0.0, .low_open = true}},
      {.path = "checks.api", .member = enters(&CheckSettings::api), .text = "Settings of API RP 1111."},
      {.path = "checks.api.edition",
       .member = defaults(&ApiSettings::edition),
       .kind = FieldKind::choice,
       .text = "third (1999), fourth (2009) or fifth (2015): since the fourth edition the collapse pressure is "
               "multiplied by f_o/g(delta)."},
      open_number("checks.api.collapse_factor", fills(&ApiSettings::collapse_factor), "Collapse factor f_o.",
                  "0.6 for uoe and uo, otherwise 0.7", {.low = 0.1, .high = 1.0}),
      open_number("checks.api.combined_collapse_factor", fills(&ApiSettings::combined_collapse_factor),
                  "Collapse factor f_c for bending with external pressure; up to 1 for installation.",
                  "f_o/g(delta), at most 1; 1 in the third edition", {.low = 0.1, .high = 1.0}),
      number("checks.api.bending_factor", defaults(&ApiSettings::bending_factor),
             "Factor f_1 on the installation bending strain.", {.low = 1.0, .high = 10.0}),
      open_number("checks.api.ovality", fills(&ApiSettings::ovality),
                  "delta = (largest - smallest)/(largest + smallest diameter).", "half of checks.ovality",
                  {.low = 0.0, .high = 0.1}),
  };
}

std::vector<Field> limits() {
  const auto stress = [](const std::string& key, std::optional<double> AllowableStressFactors::*member,
                         const char* text) {
    return open_number("checks.yield_share." + key, fills(member), text, "not checked", share());
  };
  return {
      {.path = "checks.yield_share",
       .member = enters(&CheckSettings::allowable_stress),
       .text = "Allowable von Mises stress as a fraction of SMYS (0.85 is 85 %), for projects that use such limits.",
       .fallback_text = "not checked"},
      stress("overbend_static", &AllowableStressFactors::overbend_static, "Overbend, static."),
      stress("overbend_dynamic", &AllowableStressFactors::overbend_dynamic, "Overbend, dynamic."),
      stress("sagbend_static", &AllowableStressFactors::sagbend_static, "Sagbend, static."),
      stress("sagbend_dynamic", &AllowableStressFactors::sagbend_dynamic, "Sagbend, dynamic."),
      {.path = "checks.limits",
       .member = enters(&CheckSettings::limits),
       .text = "Limits of the lay equipment and the coating.",
       .fallback_text = "not checked"},
      limit("roller_load", &EquipmentLimits::roller_load, "Maximum force on one roller.", "N", "kN"),
      limit("coating_line_load", &EquipmentLimits::coating_line_load,
            "Maximum force per length of coating under a roller.", "N/m", "kN/m"),
      limit("tension", &EquipmentLimits::tension, "Maximum tension at the tensioner.", "N", "kN"),
      limit("tip_clearance", &EquipmentLimits::tip_clearance,
            "Minimum distance of the pipe from the last roller of the stinger.", "m", "m"),
  };
}

Field safety_factor(const char* key, std::optional<double> SafetyFactors::*member, const char* text,
                    const char* otherwise) {
  return open_number(std::string("checks.safety_factors.") + key, fills(member), text, otherwise,
                     {.low = 1.0, .high = 20.0});
}

std::vector<Field> safety_factors() {
  using Factors = SafetyFactors;
  return {
      group_row("checks.safety_factors", enters(&CheckSettings::safety_factors),
                "Required strength over load of lines, anchors and cables."),
      safety_factor("mooring_intact", &Factors::mooring_intact,
                    "Breaking load over tension of a mooring line, all lines intact.",
                    "API RP 2SK: 2.0 in statics and with quasi_static lines, 1.67 in dynamic analysis"),
      safety_factor("mooring_damaged", &Factors::mooring_damaged, "The same with a mooring line missing or failed.",
                    "API RP 2SK: 1.43, and 1.25"),
      safety_factor("anchor_intact", &Factors::anchor_intact, "Holding power over load of an anchor, all lines intact.",
                    "1.5, assumed for drag anchors (piles and plates have others)"),
      safety_factor("anchor_damaged", &Factors::anchor_damaged, "The same with a mooring line missing or failed.",
                    "1.0, assumed for drag anchors"),
      safety_factor("cable", &Factors::cable,
                    "Breaking load over tension of the cable of abandonment, recovery and start-up.",
                    "3, assumed: no public text gives a number"),
      safety_factor("line", &Factors::line, "Breaking load over tension of free lines.",
                    "that of an intact mooring line, assumed")};
}

std::vector<Field> accepted() {
  return {list_row("checks.accepted_findings", enters(&CheckSettings::accepted_findings),
                   "Serious findings that the project accepts, by their names in the guide: they do not block a pass, "
                   "and the report states that they are accepted.",
                   "none"),
          row_of_kind(FieldKind::text, "checks.accepted_findings[]", appends_value<std::string>(),
                      "Name of a serious finding, such as pipe-off-rollers.")};
}

}  // namespace

std::vector<Field> checks() {
  std::vector<Field> rows = {{.path = "checks",
                              .member = enters(&Description::checks),
                              .text = "Code checks.",
                              .fallback_text = "all with their defaults"}};
  for (const std::vector<Field>& part : {strength(), options(), limits(), safety_factors(), accepted()}) {
    rows.insert(rows.end(), part.begin(), part.end());
  }
  return rows;
}

}  // namespace overbend::field_rows
