#include "modelfile/field_rows.h"

namespace overbend::field_rows {
namespace {

constexpr double kDeg = std::numbers::pi / 180.0;

Field roller_size(const std::string& key, const std::string& text, double high) {
  return {.path = "rollers.*." + key,
          .kind = FieldKind::quantity,
          .text = text,
          .unit = "m",
          .show = "m",
          .required = true,
          .range = {.low = 0.0, .high = high, .low_open = true}};
}

std::vector<Field> structure(const std::string& p, const std::string& text) {
  const std::string b = p + ".boxes[]";
  const Range rows = {.low = 1.0, .high = 1000.0};
  return {
      {.path = p, .text = text},
      {.path = p + ".radius",
       .kind = FieldKind::quantity,
       .text = "Nominal radius, for the report; the boxes rule.",
       .unit = "m",
       .show = "m",
       .fallback_text = "not given",
       .range = {.low = 0.0, .low_open = true}},
      {.path = p + ".roller",
       .kind = FieldKind::text,
       .text = "Kind of roller row of its boxes, a name under rollers.",
       .fallback_text = "each box names its own"},
      {.path = p + ".rows",
       .kind = FieldKind::integer,
       .text = "Roller rows per box, evenly over its length.",
       .fallback = "1",
       .range = rows},
      {.path = p + ".boxes",
       .kind = FieldKind::list,
       .text = "Roller boxes in the order the pipe runs, astern.",
       .required = true,
       .least = 1},
      {.path = b, .text = "One roller box."},
      {.path = b + ".name",
       .kind = FieldKind::text,
       .text = "Names it in results; no two alike.",
       .fallback_text = "ramp 1, 2, ... or stinger 1, 2, ..."},
      {.path = b + ".x",
       .kind = FieldKind::quantity,
       .text = "Where the underside of the coated pipe rests at mid-box, astern of the stern shoe.",
       .unit = "m",
       .show = "m",
       .required = true},
      {.path = b + ".z",
       .kind = FieldKind::quantity,
       .text = "Where the underside of the coated pipe rests at mid-box, above the stern shoe.",
       .unit = "m",
       .show = "m",
       .required = true},
      {.path = b + ".offset",
       .kind = FieldKind::quantity,
       .text = "Raises the box along the outward normal of the curve through the boxes.",
       .unit = "m",
       .show = "m",
       .fallback = "0 m",
       .range = {.low = -100.0, .high = 100.0}},
      {.path = b + ".length",
       .kind = FieldKind::quantity,
       .text = "Along the pipe; with more than one row it must be given.",
       .unit = "m",
       .show = "m",
       .fallback = "0 m",
       .range = {.low = 0.0, .high = 1000.0}},
      {.path = b + ".incline",
       .kind = FieldKind::quantity,
       .text = "Of the box from horizontal, positive when it dips astern.",
       .unit = "rad",
       .show = "deg",
       .fallback_text = "tangent of the smooth curve through the boxes",
       .range = {.low = -90.0 * kDeg, .high = 90.0 * kDeg, .low_open = true, .high_open = true}},
      {.path = b + ".roller",
       .kind = FieldKind::text,
       .text = "Kind of roller row of this box.",
       .fallback_text = "as the structure's"},
      {.path = b + ".rows",
       .kind = FieldKind::integer,
       .text = "Roller rows of this box.",
       .fallback_text = "as the structure's",
       .range = rows},
  };
}

}  // namespace

std::vector<Field> rollers() {
  return {
      {.path = "rollers", .text = "Kinds of roller row by a name of your own; supports name the kind they have."},
      {.path = "rollers.*", .text = "One kind of roller row."},
      {.path = "rollers.*.bottom", .text = "The roller under the pipe.", .required = true},
      roller_size("bottom.radius", "Radius.", 10.0),
      roller_size("bottom.face", "Length of the roller.", 100.0),
      {.path = "rollers.*.sides", .text = "A roller on either side.", .fallback_text = "bottom roller only"},
      roller_size("sides.radius", "Radius.", 10.0),
      roller_size("sides.face", "Length of the roller.", 100.0),
      {.path = "rollers.*.sides.angle",
       .kind = FieldKind::quantity,
       .text = "Of the roller's axis from horizontal.",
       .unit = "rad",
       .show = "deg",
       .required = true,
       .range = {.low = 0.0, .high = 90.0 * kDeg, .low_open = true}},
      {.path = "rollers.*.sides.clearance",
       .kind = FieldKind::quantity,
       .text = "Gap to a pipe centred on the bottom roller.",
       .unit = "m",
       .show = "m",
       .fallback = "0 m",
       .range = {.low = 0.0, .high = 100.0}},
      {.path = "rollers.*.stiffness",
       .kind = FieldKind::quantity,
       .text = "Stiffness of the contact of pipe and roller as a whole.",
       .unit = "N/m",
       .show = "kN/m",
       .fallback_text = "as default_stiffness says",
       .range = {.low = 0.0, .low_open = true},
       .usual = {.low = 1e4, .high = 1e12}},
      {.path = "rollers.*.default_stiffness",
       .kind = FieldKind::choice,
       .text =
           "Where no stiffness is given. physical: pipe shell, coating and roller structure in series; penalty: EI/h^3 "
           "of the pipe's elements, nearly rigid.",
       .fallback = "physical",
       .choices = {"physical", "penalty"}},
      {.path = "rollers.*.structure_stiffness",
       .kind = FieldKind::quantity,
       .text = "Of the roller with its bearings and box, a part of the physical stiffness.",
       .unit = "N/m",
       .show = "kN/m",
       .fallback = "50000 kN/m",
       .range = {.low = 0.0, .low_open = true},
       .usual = {.low = 1e5, .high = 1e10}},
      {.path = "rollers.*.friction",
       .kind = FieldKind::number,
       .text = "Coulomb friction of pipe on roller, the same in both directions; or a group of the two below.",
       .fallback = "0",
       .range = friction_range()},
      {.path = "rollers.*.friction", .text = "Coulomb friction by direction."},
      {.path = "rollers.*.friction.axial",
       .kind = FieldKind::number,
       .text = "Along the pipe.",
       .fallback = "0",
       .range = friction_range()},
      {.path = "rollers.*.friction.lateral",
       .kind = FieldKind::number,
       .text = "Across the pipe.",
       .fallback = "0",
       .range = friction_range()},
      {.path = "rollers.*.restitution",
       .kind = FieldKind::number,
       .text = "Coefficient of restitution of an impact.",
       .fallback = "0.5",
       .range = {.low = 0.0, .high = 1.0}},
      {.path = "rollers.*.damping",
       .kind = FieldKind::choice,
       .text = "clipped: impacts rebound with the coefficient of restitution; textbook: the common formula, which "
               "takes rollers to pull at the end of a rebound, for comparison.",
       .fallback = "clipped",
       .choices = {"clipped", "textbook"}},
      {.path = "rollers.*.tangential_stiffness",
       .kind = FieldKind::quantity,
       .text = "Of a roller against a pipe that friction makes stick to it.",
       .unit = "N/m",
       .show = "kN/m",
       .fallback_text = "a tenth of the normal stiffness",
       .range = {.low = 0.0, .low_open = true},
       .usual = {.low = 1e3, .high = 1e12}},
  };
}

std::vector<Field> supports() {
  std::vector<Field> rows = {{.path = "supports",
                              .text = "Ramp and stinger, in the ramp/stinger frame.",
                              .fallback_text = "the pipe hangs from the tensioner (J-lay)"},
                             {.path = "supports.contact",
                              .kind = FieldKind::choice,
                              .text = "rollers: each stands for itself; gap_springs: for comparison with traditional "
                                      "models, one spring with gaps in the middle of each box, without damping and "
                                      "friction.",
                              .fallback = "rollers",
                              .choices = {"rollers", "gap_springs"}}};
  for (const auto& part : {structure("supports.ramp", "Roller boxes on the vessel."),
                           structure("supports.stinger", "Roller boxes on the stinger.")}) {
    rows.insert(rows.end(), part.begin(), part.end());
  }
  return rows;
}

}  // namespace overbend::field_rows
