#include <algorithm>

#include "base/constants.h"
#include "model/description/description_enum_names.h"
#include "model/pipe/contact_stiffness.h"
#include "modelfile/fields/field_rows_stinger.h"

namespace overbend::field_rows {
namespace {

constexpr Range kRows = {.low = 1.0, .high = 50.0};  ///< Boxes have 1 to 4.

/// The keys of the structure are above its boxes in the table and therefore bound before them.
BoxDescription& add_box(StructureKeys& keys, const FieldValue&) {
  const auto is_same_structure = [&](const BoxDescription& box) { return box.structure == keys.structure; };
  const auto number = std::count_if(keys.supports->boxes.begin(), keys.supports->boxes.end(), is_same_structure) + 1;
  BoxDescription& box = keys.supports->boxes.emplace_back();
  box.name = std::string(enum_name(keys.structure)) + " " + std::to_string(number);
  box.structure = keys.structure;
  box.roller = keys.roller;
  box.rows = keys.rows;
  box.section = std::max(keys.section, 0);
  return box;
}

/// The boxes of a row are placed when ramp and stinger are both bound.
BoxRowDescription& add_row(StructureKeys& keys, const FieldValue& row) {
  for (std::int64_t i = row.get_integer("count").value_or(0); i > 0; --i) {
    add_box(keys, row);
  }
  SupportsDescription& supports = *keys.supports;
  return (keys.structure == Structure::ramp ? supports.ramp_row : supports.stinger_row).emplace();
}

/// Table of settings, and the selection among them.
std::vector<Field> stinger_setting_rows(const std::string& path) {
  const auto open = [](StructureKeys& keys, const FieldValue&) -> std::vector<StingerSettingDescription>& {
    return keys.supports->settings;
  };
  const auto choose = [](StructureKeys& keys, const FieldValue& value) { keys.supports->setting = value.text; };
  return stinger_settings(path, opened_by<StructureKeys>(open), taken_by<StructureKeys>(choose));
}

RollerKindDescription& add_kind(Description& description, const FieldValue& kind) {
  RollerKindDescription& roller = description.rollers.emplace_back();
  roller.name = kind.key;
  return roller;
}

Field roller_size(const std::string& key, const Member& member, const std::string& text, double high) {
  return {.path = "rollers.*." + key,
          .member = member,
          .kind = FieldKind::quantity,
          .text = text,
          .unit = "m",
          .show = "m",
          .required = true,
          .range = {.low = 0.0, .high = high, .low_open = true},
          .usual = {.low = 5e-3, .high = high}};
}

/// Boxes of a structure, or of a section of it, at `path`.
std::vector<Field> box_rows(const std::string& path, bool required) {
  const std::string b = path + "[]";
  return {
      {.path = path,
       .kind = FieldKind::list,
       .text = "Roller boxes in order from the tensioner astern.",
       .required = required,
       .fallback_text = required ? "" : "given by sections",
       .min_items = 1,
       .max_items = 1000},
      {.path = b, .member = opened_by<StructureKeys>(add_box), .text = "One roller box."},
      {.path = b + ".name",
       .member = fills(&BoxDescription::name),
       .kind = FieldKind::text,
       .text = "Name in the results; must be unique.",
       .fallback_text = "ramp 1, 2, ... or stinger 1, 2, ..."},
      {.path = b + ".x",
       .member = fills(&BoxDescription::x),
       .kind = FieldKind::quantity,
       .text = "Point of the underside of the coated pipe at mid-box, astern of the stern shoe.",
       .unit = "m",
       .show = "m",
       .required = true},
      {.path = b + ".z",
       .member = fills(&BoxDescription::z),
       .kind = FieldKind::quantity,
       .text = "Point of the underside of the coated pipe at mid-box, above the stern shoe.",
       .unit = "m",
       .show = "m",
       .required = true},
      {.path = b + ".offset",
       .member = defaults(&BoxDescription::offset),
       .kind = FieldKind::quantity,
       .text = "Moves the box along the outward normal of the curve through the boxes.",
       .unit = "m",
       .show = "m",
       .range = {.low = -100.0, .high = 100.0}},
      {.path = b + ".length",
       .member = defaults(&BoxDescription::length),
       .kind = FieldKind::quantity,
       .text = "Length along the pipe; required with more than one row.",
       .unit = "m",
       .show = "m",
       .range = {.low = 0.0, .high = 1000.0}},
      {.path = b + ".incline",
       .member = fills(&BoxDescription::incline),
       .kind = FieldKind::quantity,
       .text = "Inclination of the box from horizontal, positive downwards astern.",
       .unit = "rad",
       .show = "deg",
       .fallback_text = "tangent of the smooth curve through the boxes",
       .range = {.low = -90.0 * kDegree, .high = 90.0 * kDegree, .low_open = true, .high_open = true}},
      {.path = b + ".roller",
       .member = fills(&BoxDescription::roller),
       .kind = FieldKind::text,
       .text = "Type of roller row of this box.",
       .fallback_text = "as for the structure"},
      {.path = b + ".rows",
       .member = fills(&BoxDescription::rows),
       .kind = FieldKind::integer,
       .text = "Roller rows of this box.",
       .fallback_text = "as for the structure",
       .range = kRows},
  };
}

std::vector<Field> structure(Structure which, std::optional<double> SupportsDescription::*radius,
                             const std::string& text) {
  const auto open = [which](SupportsDescription& supports, const FieldValue&) {
    return StructureKeys{.supports = &supports, .structure = which};
  };
  const auto take_radius = [radius](StructureKeys& keys, const FieldValue& value) {
    keys.supports->*radius = value.number;
  };
  const std::string p = std::string("supports.") + enum_name(which);
  std::vector<Field> rows = {
      {.path = p,
       .member = opened_by<SupportsDescription>(open),
       .text = text,
       .min_items = which == Structure::stinger ? 1 : 0},
      {.path = p + ".radius",
       .member = taken_by<StructureKeys>(take_radius),
       .kind = FieldKind::quantity,
       .text = "Radius of the arc of a row of boxes (boxes.count, boxes.spacing). Listed boxes have none: they are "
               "placed by their coordinates, and the radius of the circle fitted to them is a result.",
       .unit = "m",
       .show = "m",
       .fallback_text = "the boxes are listed",
       .range = {.low = 0.0, .low_open = true}},
      {.path = p + ".roller",
       .member = fills(&StructureKeys::roller),
       .kind = FieldKind::text,
       .text = "Type of roller row of its boxes, a name under rollers.",
       .fallback_text = "each box gives its own"},
      {.path = p + ".rows",
       .member = defaults(&StructureKeys::rows),
       .kind = FieldKind::integer,
       .text = "Roller rows per box, evenly over its length.",
       .range = kRows},
  };
  if (which == Structure::stinger) {
    append(rows, stinger_section_rows(p));
    append(rows, stinger_section_list());
    append(rows, box_rows(p + ".sections[].boxes", true));
  }
  append(rows, box_rows(p + ".boxes", which == Structure::ramp));
  return rows;
}

}  // namespace

std::vector<Field> rollers() {
  std::vector<Field> rows = {
      {.path = "rollers", .text = "Types of roller row, each with a user-defined name, to which the supports refer."},
      {.path = "rollers.*", .member = opened_by<Description>(add_kind), .text = "One type of roller row."},
      {.path = "rollers.*.bottom",
       .member = enters(&RollerKindDescription::bottom),
       .text = "The roller under the pipe.",
       .required = true},
      roller_size("bottom.radius", fills(&BottomRollerDescription::radius), "Radius.", 10.0),
      roller_size("bottom.face", fills(&BottomRollerDescription::face), "Length of the roller.", 100.0),
      {.path = "rollers.*.sides",
       .member = enters(&RollerKindDescription::sides),
       .text = "A roller on each side.",
       .fallback_text = "bottom roller only"},
      roller_size("sides.radius", fills(&SideRollerDescription::radius), "Radius.", 10.0),
      roller_size("sides.face", fills(&SideRollerDescription::face), "Length of the roller.", 100.0),
      {.path = "rollers.*.sides.angle",
       .member = fills(&SideRollerDescription::angle),
       .kind = FieldKind::quantity,
       .text = "Angle of the roller's axis from horizontal.",
       .unit = "rad",
       .show = "deg",
       .required = true,
       .range = {.low = 0.0, .high = 90.0 * kDegree, .low_open = true}},
      {.path = "rollers.*.sides.clearance",
       .member = defaults(&SideRollerDescription::clearance),
       .kind = FieldKind::quantity,
       .text = "Gap to a pipe centred on the bottom roller.",
       .unit = "m",
       .show = "m",
       .range = {.low = 0.0, .high = 100.0}},
      {.path = "rollers.*.stiffness",
       .member = fills(&RollerKindDescription::stiffness),
       .kind = FieldKind::quantity,
       .text = "Total stiffness of the contact between pipe and roller.",
       .unit = "N/m",
       .show = "kN/m",
       .fallback_text = "according to default_stiffness",
       .range = {.low = 0.0, .low_open = true},
       .usual = {.low = 1e4, .high = 1e12}},
      {.path = "rollers.*.default_stiffness",
       .member = defaults(&RollerKindDescription::default_stiffness),
       .kind = FieldKind::choice,
       .text = "Used if no stiffness is given. physical: pipe shell, coating and roller structure in series; penalty: "
               "EI/D^3 of the pipe, nearly rigid."},
      {.path = "rollers.*.structure_stiffness",
       .member = with_default(fills(&RollerKindDescription::structure_stiffness), kRollerStructure),
       .kind = FieldKind::quantity,
       .text = "Stiffness of the roller with its bearings and box, part of the physical contact stiffness.",
       .unit = "N/m",
       .show = "kN/m",
       .range = {.low = 0.0, .low_open = true},
       .usual = {.low = 1e5, .high = 1e10}},
  };
  append(rows, friction<RollerKindDescription>("rollers.*.friction", "Coulomb friction of the pipe on a roller",
                                               &RollerKindDescription::friction_axial,
                                               &RollerKindDescription::friction_lateral));
  append(
      rows,
      {
          {.path = "rollers.*.restitution",
           .member = defaults(&RollerKindDescription::restitution),
           .kind = FieldKind::number,
           .text = "Coefficient of restitution of an impact.",
           .range = {.low = 0.0, .high = 1.0}},
          {.path = "rollers.*.damping",
           .member = defaults(&RollerKindDescription::damping),
           .kind = FieldKind::choice,
           .text = "clipped: impacts rebound with the coefficient of restitution; textbook: the common formula, which "
                   "assumes that rollers pull at the end of a rebound, for comparison."},
          {.path = "rollers.*.tangential_stiffness",
           .member = fills(&RollerKindDescription::tangential_stiffness),
           .kind = FieldKind::quantity,
           .text = "Tangential stiffness of the contact while friction sticks.",
           .unit = "N/m",
           .show = "kN/m",
           .fallback_text = "a tenth of the normal stiffness",
           .range = {.low = 0.0, .low_open = true},
           .usual = {.low = 1e3, .high = 1e12}},
      });
  return rows;
}

std::vector<Field> supports() {
  std::vector<Field> rows = {
      {.path = "supports",
       .member = enters(&Description::supports),
       .text = "Ramp and stinger, in the ramp/stinger frame.",
       .fallback_text = "the pipe hangs from the tensioner (J-lay)"},
      {.path = "supports.contact",
       .member = defaults(&SupportsDescription::contact),
       .kind = FieldKind::choice,
       .text = "rollers: contact at each roller; gap_springs: for comparison with traditional models, one gap spring "
               "in the middle of each box, without damping and friction."}};
  append(rows, structure(Structure::ramp, &SupportsDescription::ramp_radius, "Roller boxes on the vessel."));
  append(rows, box_row("supports.ramp.boxes", opened_by<StructureKeys>(add_row), false));
  append(rows, structure(Structure::stinger, &SupportsDescription::stinger_radius, "Roller boxes on the stinger."));
  append(rows, box_row("supports.stinger.boxes", opened_by<StructureKeys>(add_row), true));
  append(rows, stinger_setting_rows("supports.stinger"));
  return rows;
}

}  // namespace overbend::field_rows
