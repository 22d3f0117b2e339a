#include "model/description/description_enum_names.h"
#include "modelfile/fields/field_rows.h"
#include "modelfile/fields/field_rows_lines.h"

namespace overbend::field_rows {
namespace {

/// Keys of a cross-section under `p`. Keys missing in a segment are those of the main section.
std::vector<Field> section(const std::string& p) {
  return {
      {.path = p + ".steel", .member = enters(&SectionDescription::steel), .text = "The steel pipe.", .required = true},
      {.path = p + ".steel.outside_diameter",
       .member = fills(&SteelDescription::outside_diameter),
       .kind = FieldKind::quantity,
       .text = "Outside diameter of the steel.",
       .unit = "m",
       .show = "mm",
       .required = true,
       .range = {.low = 0.0, .high = 5.0, .low_open = true},
       .usual = {.low = 0.02, .high = 2.2}},
      {.path = p + ".steel.wall_thickness",
       .member = fills(&SteelDescription::wall_thickness),
       .kind = FieldKind::quantity,
       .text = "Wall thickness of the steel.",
       .unit = "m",
       .show = "mm",
       .required = true,
       .range = {.low = 0.0, .high = 1.0, .low_open = true}},
      {.path = p + ".steel.youngs_modulus",
       .member = defaults(&SteelDescription::youngs_modulus),
       .kind = FieldKind::quantity,
       .text = "Young's modulus.",
       .unit = "N/m^2",
       .show = "GPa",
       .range = {.low = 0.0, .low_open = true},
       .usual = {.low = 50e9, .high = 300e9}},
      {.path = p + ".steel.poissons_ratio",
       .member = defaults(&SteelDescription::poissons_ratio),
       .kind = FieldKind::number,
       .text = "Poisson's ratio.",
       .range = {.low = 0.0, .high = 0.5, .low_open = true, .high_open = true}},
      {.path = p + ".steel.yield_stress",
       .member = fills(&SteelDescription::yield_stress),
       .kind = FieldKind::quantity,
       .text = "Specified minimum yield stress (SMYS).",
       .unit = "N/m^2",
       .show = "MPa",
       .required = true,
       .range = {.low = 0.0, .low_open = true},
       .usual = {.low = 100e6, .high = 2000e6}},
      {.path = p + ".steel.yield_assumed",
       .member = defaults(&SteelDescription::yield_assumed),
       .kind = FieldKind::choice,
       .text = "yes: yield_stress is an assumption, as after an import of a file without one. Stresses and strains are "
               "compared with it, and the verdict is reserved."},
      {.path = p + ".steel.tensile_strength",
       .member = fills(&SteelDescription::tensile_strength),
       .kind = FieldKind::quantity,
       .text = "Specified minimum tensile strength (SMTS).",
       .unit = "N/m^2",
       .show = "MPa",
       .fallback_text = "not given",
       .range = {.low = 0.0, .low_open = true},
       .usual = {.low = 100e6, .high = 2000e6}},
      {.path = p + ".steel.weight_density",
       .member = defaults(&SteelDescription::weight_density),
       .kind = FieldKind::quantity,
       .text = "Weight density of the steel.",
       .unit = "N/m^3",
       .show = "kN/m^3",
       .range = {.low = 0.0, .low_open = true},
       .usual = {.low = 15e3, .high = 100e3}},
      {.path = p + ".steel.material",
       .member = enters(&SteelDescription::material),
       .text = "Material law of the steel beyond yield.",
       .fallback_text = "linear"},
      {.path = p + ".steel.material.law",
       .member = defaults(&MaterialDescription::law),
       .kind = FieldKind::choice,
       .text = "linear; kappa/kappa_y = M/M_y + A (M/M_y)^B; a stress-strain law integrated over the wall with wall "
               "tension and hoop stress; or a table. All but linear unload elastically and harden kinematically."},
      {.path = p + ".steel.material.moment_coefficient",
       .member = fills(&MaterialDescription::moment_coefficient),
       .kind = FieldKind::number,
       .text = "A of moment_ramberg_osgood.",
       .fallback_text = "fitted to the given stress-strain law",
       .range = {.low = 0.0, .high = 10.0, .low_open = true}},
      {.path = p + ".steel.material.moment_exponent",
       .member = fills(&MaterialDescription::moment_exponent),
       .kind = FieldKind::number,
       .text = "B of moment_ramberg_osgood.",
       .fallback_text = "fitted to the given stress-strain law",
       .range = {.low = 1.0, .high = 100.0, .low_open = true}},
      {.path = p + ".steel.material.hardening_exponent",
       .member = fills(&MaterialDescription::hardening_exponent),
       .kind = FieldKind::number,
       .text = "n of ramberg_osgood: strain = stress/E + (yield_strain - SMYS/E) (stress/SMYS)^n.",
       .fallback_text = "not given",
       .range = {.low = 1.0, .high = 100.0, .low_open = true}},
      {.path = p + ".steel.material.yield_strain",
       .member = defaults(&MaterialDescription::yield_strain),
       .kind = FieldKind::quantity,
       .text = "Total strain at SMYS.",
       .unit = "1",
       .show = "%",
       .range = {.low = 0.0, .high = 0.1, .low_open = true}},
      {.path = p + ".steel.material.hardening_modulus",
       .member = defaults(&MaterialDescription::hardening_modulus),
       .kind = FieldKind::quantity,
       .text = "Slope of bilinear beyond yield.",
       .unit = "N/m^2",
       .show = "GPa",
       .range = {.low = 0.0}},
      {.path = p + ".steel.material.stress_strain",
       .member = enters(&MaterialDescription::stress_strain),
       .kind = FieldKind::list,
       .text = "Stress-strain curve of a tension test, increasing from the origin, which is not listed. The first "
               "point is the end of the linear part.",
       .fallback_text = "not given"},
      {.path = p + ".steel.material.stress_strain[]", .member = appends<CurvePoint>(), .text = "One point."},
      {.path = p + ".steel.material.stress_strain[].strain",
       .member = fills(&CurvePoint::x),
       .kind = FieldKind::quantity,
       .text = "Total strain.",
       .unit = "1",
       .show = "%",
       .required = true,
       .range = {.low = 0.0, .high = 1.0, .low_open = true}},
      {.path = p + ".steel.material.stress_strain[].stress",
       .member = fills(&CurvePoint::y),
       .kind = FieldKind::quantity,
       .text = "Stress.",
       .unit = "N/m^2",
       .show = "MPa",
       .required = true,
       .range = {.low = 0.0, .low_open = true}},
      {.path = p + ".steel.material.moment_curvature",
       .member = enters(&MaterialDescription::moment_curvature),
       .kind = FieldKind::list,
       .text = "Moment-curvature curve of the pipe, increasing from the origin, which is not listed. The first point "
               "is the end of the linear part, whose slope is the bending stiffness; it may be below that of the steel "
               "section, and is at most 5 % above.",
       .fallback_text = "not given"},
      {.path = p + ".steel.material.moment_curvature[]", .member = appends<CurvePoint>(), .text = "One point."},
      {.path = p + ".steel.material.moment_curvature[].curvature",
       .member = fills(&CurvePoint::x),
       .kind = FieldKind::quantity,
       .text = "Curvature.",
       .unit = "m-1",
       .show = "1/m",
       .required = true,
       .range = {.low = 0.0, .low_open = true}},
      {.path = p + ".steel.material.moment_curvature[].moment",
       .member = fills(&CurvePoint::y),
       .kind = FieldKind::quantity,
       .text = "Bending moment.",
       .unit = "N*m",
       .show = "kN*m",
       .required = true,
       .range = {.low = 0.0, .low_open = true}},
      {.path = p + ".coatings",
       .member = enters(&SectionDescription::coatings),
       .kind = FieldKind::list,
       .text = "Coatings, from the steel outwards.",
       .fallback_text = "bare pipe",
       .max_items = 100},
      {.path = p + ".coatings[]", .member = appends_named<CoatingDescription>("coating"), .text = "One coating."},
      {.path = p + ".coatings[].name",
       .member = fills(&CoatingDescription::name),
       .kind = FieldKind::text,
       .text = "For the report.",
       .fallback_text = "coating 1, 2, ..."},
      {.path = p + ".coatings[].thickness",
       .member = fills(&CoatingDescription::thickness),
       .kind = FieldKind::quantity,
       .text = "Thickness.",
       .unit = "m",
       .show = "mm",
       .required = true,
       .range = {.low = 0.0, .high = 1.0, .low_open = true},
       .usual = {.low = 0.0, .high = 0.3}},
      {.path = p + ".coatings[].weight_density",
       .member = fills(&CoatingDescription::weight_density),
       .kind = FieldKind::quantity,
       .text = "Weight density.",
       .unit = "N/m^3",
       .show = "kN/m^3",
       .required = true,
       .range = {.low = 0.0, .low_open = true},
       .usual = {.low = 3e3, .high = 60e3}},
      {.path = p + ".coatings[].youngs_modulus",
       .member = fills(&CoatingDescription::youngs_modulus),
       .kind = FieldKind::quantity,
       .text = "Young's modulus, for the stiffness of the contact with rollers; adds nothing to EA and EI.",
       .unit = "N/m^2",
       .show = "GPa",
       .fallback_text = "rigid under rollers",
       .range = {.low = 0.0, .low_open = true},
       .usual = {.low = 1e6, .high = 100e9}},
      {.path = p + ".joint",
       .member = enters(&SectionDescription::joint),
       .text = "Pipe joint with field joints, at which infill replaces the outermost coating.",
       .fallback_text = "no field joints"},
      {.path = p + ".joint.length",
       .member = fills(&JointDescription::length),
       .kind = FieldKind::quantity,
       .text = "Length of one pipe joint.",
       .unit = "m",
       .show = "m",
       .required = true,
       .range = {.low = 0.1, .high = 1000.0}},
      {.path = p + ".joint.field_joint",
       .member = fills(&JointDescription::field_joint),
       .kind = FieldKind::quantity,
       .text = "Length without the outermost coating, per pipe joint.",
       .unit = "m",
       .show = "m",
       .required = true,
       .range = {.low = 0.0}},
      {.path = p + ".joint.infill_weight_density",
       .member = defaults(&JointDescription::infill_weight_density),
       .kind = FieldKind::quantity,
       .text = "Weight density of the infill.",
       .unit = "N/m^3",
       .show = "kN/m^3",
       .range = {.low = 0.0}},
      {.path = p + ".joint.coated_stiffness",
       .member = defaults(&JointDescription::coated_stiffness),
       .kind = FieldKind::number,
       .text = "Ratio of the bending stiffness between field joints, stiffened by concrete, to that of the bare steel, "
               "which applies at the joints. Used over the supports and three joints beyond.",
       .range = {.low = 1.0, .high = 5.0}},
      {.path = p + ".joint.first",
       .member = fills(&JointDescription::first),
       .kind = FieldKind::quantity,
       .text = "Distance of the middle of the first field joint from the tensioner, used with coated_stiffness.",
       .unit = "m",
       .show = "m",
       .fallback_text = "half a pipe joint",
       .range = {.low = 0.0}},
      {.path = p + ".joint.strain_factor",
       .member = fills(&JointDescription::strain_factor),
       .kind = FieldKind::number,
       .text = "Strain concentration factor of field joints: strain there divided by that of the adjacent coated pipe, "
               "for the strain checks.",
       .fallback_text = "1, with a warning for concrete-coated pipe",
       .range = {.low = 1.0, .high = 10.0}},
      {.path = p + ".hydrodynamics",
       .member = enters(&SectionDescription::hydrodynamics),
       .text = "Morison coefficients, on the outermost diameter."},
      {.path = p + ".hydrodynamics.drag_normal",
       .member = defaults(&HydrodynamicsDescription::drag_normal),
       .kind = FieldKind::number,
       .text = "Normal drag.",
       .range = {.low = 0.0, .high = 10.0}},
      {.path = p + ".hydrodynamics.drag_axial",
       .member = defaults(&HydrodynamicsDescription::drag_axial),
       .kind = FieldKind::number,
       .text = "Axial drag.",
       .range = {.low = 0.0, .high = 10.0}},
      {.path = p + ".hydrodynamics.added_mass_normal",
       .member = defaults(&HydrodynamicsDescription::added_mass_normal),
       .kind = FieldKind::number,
       .text = "Normal added mass.",
       .range = {.low = 0.0, .high = 10.0}},
      {.path = p + ".hydrodynamics.added_mass_axial",
       .member = defaults(&HydrodynamicsDescription::added_mass_axial),
       .kind = FieldKind::number,
       .text = "Axial added mass.",
       .range = {.low = 0.0, .high = 10.0}},
      {.path = p + ".contents", .text = "Contents of the pipe.", .fallback_text = "empty"},
      {.path = p + ".contents.weight_density",
       .member = defaults(&SectionDescription::contents_weight_density),
       .kind = FieldKind::quantity,
       .text = "Weight density of the contents.",
       .unit = "N/m^3",
       .show = "kN/m^3",
       .range = {.low = 0.0}},
      {.path = p + ".contents.pressure",
       .member = defaults(&SectionDescription::internal_pressure),
       .kind = FieldKind::quantity,
       .text = "Internal pressure at the water level.",
       .unit = "N/m^2",
       .show = "MPa",
       .range = {.low = -0.1e6}},  // a vacuum
  };
}

/// Rows of a section under the group that contains it.
template <typename Owner>
std::vector<Field> pipe_section(const std::string& p, std::vector<Field> rows) {
  for (Field& row : rows) {
    const bool below_another = row.path.find_first_of(".[", p.size() + 1) != std::string::npos;
    if (!below_another) row.member = through(&Owner::section, row.member);
  }
  return rows;
}

/// A segment starts as a copy of the main section, whose rows are above those of the segments.
SegmentDescription& add_segment(PipeDescription& pipe, const FieldValue&) {
  SegmentDescription& segment = pipe.segments.emplace_back();
  segment.name = "segment " + std::to_string(pipe.segments.size());
  segment.section = pipe.section;
  return segment;
}

/// In a segment no key of the section is required; missing keys are those of the main section.
std::vector<Field> segment_section(const std::string& p) {
  std::vector<Field> rows = section(p);
  for (Field& row : rows) {
    const std::string key = row.path.substr(p.size());
    const bool keeps_requirement = key.find("[]") != std::string::npos || key.starts_with(".joint.");
    if (keeps_requirement) continue;
    row.required = false;
    row.member.standard.reset();
    row.fallback_text = "as in the main section";
  }
  return rows;
}

}  // namespace

std::vector<Field> head_section_rows(const std::string& p) {
  std::vector<Field> rows;
  for (const Field& row : segment_section(p)) {
    const std::string key = row.path.substr(p.size());
    const bool part = key.starts_with(".steel") || key.starts_with(".coatings") || key.starts_with(".hydrodynamics");
    if (part) rows.push_back(row);
  }
  return rows;
}

std::vector<Field> pipe_section_rows(const std::string& p) {
  std::vector<Field> rows = section(p);
  std::erase_if(rows, [&](const Field& row) { return row.path.starts_with(p + ".hydrodynamics"); });
  rows.front().required = false;
  rows.front().fallback_text = "not pipe";
  return rows;
}

std::vector<Field> pipe() {
  std::vector<Field> rows = {{.path = "pipe",
                              .member = enters(&Description::pipe),
                              .text = "The pipe.",
                              .fallback_text = "a model without pipe: of moorings, lines or a floating hull"}};
  append(rows, pipe_section<PipeDescription>("pipe", section("pipe")));
  append(rows,
         {
             {.path = "pipe.length",
              .member = fills(&PipeDescription::length),
              .kind = FieldKind::quantity,
              .text = "Unstressed length from tensioner to anchor.",
              .unit = "m",
              .show = "m",
              .fallback_text = "follows from the tension",
              .range = {.low = 0.0, .low_open = true}},
             {.path = "pipe.anchor",
              .member = fills(&PipeDescription::anchor),
              .kind = FieldKind::quantity,
              .text = "Horizontal distance of the anchor astern of the stern shoe, with pipe.length in place of "
                      "tensioner.tension.",
              .unit = "m",
              .show = "m",
              .fallback_text = "far enough behind touchdown",
              .range = {.low = 0.0, .low_open = true}},
             {.path = "pipe.segments",
              .kind = FieldKind::list,
              .text = "Segments with a different section, from the tensioner astern; the rest has the main section.",
              .fallback_text = "one section for the whole line"},
             {.path = "pipe.segments[]",
              .member = opened_by<PipeDescription>(add_segment),
              .text = "One segment; only properties that differ from the main section are given."},
             {.path = "pipe.segments[].name",
              .member = fills(&SegmentDescription::name),
              .kind = FieldKind::text,
              .text = "For the report.",
              .fallback_text = "segment 1, 2, ..."},
             {.path = "pipe.segments[].length",
              .member = fills(&SegmentDescription::length),
              .kind = FieldKind::quantity,
              .text = "Unstressed length.",
              .unit = "m",
              .show = "m",
              .required = true,
              .range = {.low = 0.0, .low_open = true}},
         });
  append(rows, pipe_section<SegmentDescription>("pipe.segments[]", segment_section("pipe.segments[]")));
  append(rows, structures());
  append(rows, point_rows<PipeDescription>("pipe", "from the tensioner"));
  return rows;
}

}  // namespace overbend::field_rows
