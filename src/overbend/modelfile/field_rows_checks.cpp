#include "modelfile/field_rows.h"

namespace overbend::field_rows {
namespace {

Range share() {
  return {.low = 0.0, .high = 1.5, .low_open = true};
}

Field number(const char* path, const char* text, const char* fallback, Range range) {
  return {.path = path, .kind = FieldKind::number, .text = text, .fallback = fallback, .range = range};
}

/// A number without which something is not checked, or follows from something else.
Field open_number(const char* path, const char* text, const char* without, Range range) {
  return {.path = path, .kind = FieldKind::number, .text = text, .fallback_text = without, .range = range};
}

Field limit(const char* path, const char* text, const char* unit, const char* show) {
  return {.path = path,
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
       .kind = FieldKind::choice,
       .text = "Codes used: DNV-ST-F101 (dnv), API RP 1111 (api), or both.",
       .fallback = "both",
       .choices = {"both", "dnv", "api"}},
      {.path = "checks.safety_class",
       .kind = FieldKind::choice,
       .text = "Safety class of DNV-ST-F101; low for installation.",
       .fallback = "low",
       .choices = {"low", "medium", "high"}},
      {.path = "checks.manufacture",
       .kind = FieldKind::choice,
       .text = "Manufacturing process; sets the fabrication factor of DNV and the collapse factor of API.",
       .fallback_text = "uoe, the least favourable, with a note",
       .choices = {"seamless", "erw", "hfw", "trb", "uo", "uoe"}},
      number("checks.alpha_u", "Material strength factor: 0.96, or 1.00 with supplementary requirement U.", "0.96",
             {.low = 0.5, .high = 1.0}),
      open_number("checks.alpha_fab", "Fabrication factor on the compressive strength in the hoop direction.",
                  "from the manufacture", {.low = 0.5, .high = 1.0}),
      {.path = "checks.wall_tolerance",
       .kind = FieldKind::quantity,
       .text = "Negative fabrication tolerance of the wall thickness; used for collapse.",
       .unit = "m",
       .show = "mm",
       .fallback = "0 mm",
       .range = {.low = 0.0, .high = 1.0}},
      number("checks.ovality", "Out-of-roundness according to DNV, (largest - smallest diameter)/diameter.", "0.005",
             {.low = 0.005, .high = 0.1}),
      number("checks.alpha_h", "Largest ratio of yield stress to tensile strength.", "0.93", {.low = 0.5, .high = 1.0}),
      {.path = "checks.grade",
       .kind = FieldKind::choice,
       .text = "Row of the simplified laying criteria.",
       .fallback_text = "nearest grade with equal or lower yield stress",
       .choices = {"X52", "X60", "X65", "X70"}},
  };
}

std::vector<Field> options() {
  const std::vector<std::string> yes_no = {"no", "yes"};
  return {
      number("checks.condition_factor",
             "gamma_C on functional load effects: 1 in water, 1.07 on an uneven seabed, 0.82 in reeling.", "1",
             {.low = 0.5, .high = 1.5}),
      {.path = "checks.system_effects",
       .kind = FieldKind::choice,
       .text = "yes: load combination a (1.2 functional, 0.7 environmental), for system effects, is checked in "
               "addition to b.",
       .fallback = "yes",
       .choices = yes_no},
      {.path = "checks.yield_basis",
       .kind = FieldKind::choice,
       .text = "Yield stress in the limit 0.87 f_y: smys, or fy, which is alpha_u times SMYS.",
       .fallback = "fy",
       .choices = {"smys", "fy"}},
      {.path = "checks.current_load",
       .kind = FieldKind::choice,
       .text = "Classification of the load effects of the steady current in the load combinations of DNV.",
       .fallback = "environmental",
       .choices = {"environmental", "functional"}},
      {.path = "checks.point_load",
       .kind = FieldKind::choice,
       .text = "yes: the force of a roller reduces the plastic moment of the load-controlled check.",
       .fallback = "no",
       .choices = yes_no},
      {.path = "checks.arrestor", .text = "A buckle arrestor, for its cross-over pressure.", .fallback_text = "none"},
      {.path = "checks.arrestor.propagation_pressure",
       .kind = FieldKind::quantity,
       .text = "Propagation pressure of an infinitely long arrestor.",
       .unit = "N/m^2",
       .show = "MPa",
       .required = true,
       .range = {.low = 0.0, .low_open = true}},
      {.path = "checks.arrestor.length",
       .kind = FieldKind::quantity,
       .text = "Length of the arrestor.",
       .unit = "m",
       .show = "m",
       .required = true,
       .range = {.low = 0.0, .low_open = true}},
      {.path = "checks.api", .text = "Settings of API RP 1111."},
      {.path = "checks.api.edition",
       .kind = FieldKind::choice,
       .text = "third (1999), fourth (2009) or fifth (2015): since the fourth edition the collapse pressure is "
               "multiplied by f_o/g(delta).",
       .fallback = "fifth",
       .choices = {"third", "fourth", "fifth"}},
      open_number("checks.api.collapse_factor", "Collapse factor f_o.", "0.6 for uoe and uo, otherwise 0.7",
                  {.low = 0.1, .high = 1.0}),
      number("checks.api.bending_factor", "Factor f_1 on the installation bending strain.", "3.33",
             {.low = 1.0, .high = 10.0}),
      open_number("checks.api.ovality", "delta = (largest - smallest)/(largest + smallest diameter).",
                  "half of checks.ovality", {.low = 0.0, .high = 0.1}),
  };
}

std::vector<Field> limits() {
  const auto stress = [](const char* path, const char* text) {
    return open_number(path, text, "not checked", share());
  };
  return {
      {.path = "checks.yield_share",
       .text = "Allowable von Mises stress as a fraction of SMYS (0.85 is 85 %), for projects that use such limits.",
       .fallback_text = "not checked"},
      stress("checks.yield_share.overbend_static", "Overbend, static."),
      stress("checks.yield_share.overbend_dynamic", "Overbend, dynamic."),
      stress("checks.yield_share.sagbend_static", "Sagbend, static."),
      stress("checks.yield_share.sagbend_dynamic", "Sagbend, dynamic."),
      {.path = "checks.limits", .text = "Limits of the lay equipment and the coating.", .fallback_text = "not checked"},
      limit("checks.limits.roller_load", "Largest force of one roller.", "N", "kN"),
      limit("checks.limits.coating_line_load", "Largest force per length of coating under a roller.", "N/m", "kN/m"),
      limit("checks.limits.tension", "Largest tension at the tensioner.", "N", "kN"),
      limit("checks.limits.tip_clearance", "Minimum distance of the pipe from the last roller of the stinger.", "m",
            "m"),
  };
}

}  // namespace

std::vector<Field> checks() {
  std::vector<Field> rows = {{.path = "checks", .text = "Code checks.", .fallback_text = "all with their defaults"}};
  for (const std::vector<Field>& part : {strength(), options(), limits()}) {
    rows.insert(rows.end(), part.begin(), part.end());
  }
  return rows;
}

}  // namespace overbend::field_rows
