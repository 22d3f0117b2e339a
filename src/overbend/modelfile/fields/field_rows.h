/// Parts of the field table by subject. Include modelfile/fields/field_table.h instead.
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "model/description/description.h"
#include "modelfile/schema/field.h"
#include "modelfile/schema/field_value.h"
#include "modelfile/schema/member.h"

namespace overbend::field_rows {

inline Range azimuth() {
  return {.low = -2.0 * std::numbers::pi, .high = 2.0 * std::numbers::pi};
}

inline void append(std::vector<Field>& rows, const std::vector<Field>& more) {
  rows.insert(rows.end(), more.begin(), more.end());
}

/// Coulomb friction at `path`: one number for both directions, or a group with one each.
template <typename Owner>
std::vector<Field> friction(const std::string& path, const std::string& text, double Owner::*axial,
                            double Owner::*lateral) {
  const Range range = {.low = 0.0, .high = 5.0};
  const Member both = taken_by<Owner>(
      [axial, lateral](Owner& owner, const FieldValue& value) { owner.*axial = owner.*lateral = value.number; });
  return {
      {.path = path,
       .member = with_default(both, Owner{}.*axial),
       .kind = FieldKind::number,
       .text = text + ", the same in both directions; or a group of the two below.",
       .range = range},
      {.path = path, .text = "Coulomb friction by direction."},
      {.path = path + ".axial",
       .member = defaults(axial),
       .kind = FieldKind::number,
       .text = "Along the pipe.",
       .range = range},
      {.path = path + ".lateral",
       .member = defaults(lateral),
       .kind = FieldKind::number,
       .text = "Normal to the pipe.",
       .range = range},
  };
}

std::vector<Field> environment();
std::vector<Field> waves();
std::vector<Field> pipe();
std::vector<Field> vessel();
std::vector<Field> hull();
std::vector<Field> motion_convention();
std::vector<Field> tensioner();
std::vector<Field> rollers();
std::vector<Field> supports();
/// Row of boxes at `path`; `open` returns its BoxRowDescription. A stinger's row `continues` the ramp if its first box
/// is not given.
std::vector<Field> box_row(const std::string& path, const Member& open, bool continues);
/// Table of settings of the stinger at `path`, and the selection among them.
std::vector<Field> stinger_settings(const std::string& path, const Member& settings, const Member& setting);
/// The lay route in plan.
std::vector<Field> route();
std::vector<Field> moorings();
std::vector<Field> bodies();
std::vector<Field> free_lines();
std::vector<Field> station_keeping();
std::vector<Field> operation();
/// Keys of operations on the laid line: cable, head, winch and anchor.
std::vector<Field> lay_operation();
/// Stages of an operation, listed or generated.
std::vector<Field> operation_stages();
/// Steel, coatings and hydrodynamics of the head under `p`; missing keys are those of the pipe's main section.
std::vector<Field> head_section_rows(const std::string& p);
/// Steel, coatings, joints and contents of a length of pipe under `p`; their members belong to a SectionDescription.
/// None of them is required.
std::vector<Field> pipe_section_rows(const std::string& p);
/// Rows of pipe.structures.
std::vector<Field> structures();
/// operation.structure.
Field passing_structure();
std::vector<Field> lay_table();
/// Items of a list of loads on the vessel, whose own row is at `p`.
std::vector<Field> vessel_load_rows(const std::string& p);
std::vector<Field> seek();
std::vector<Field> analysis();
std::vector<Field> checks();
std::vector<Field> sensitivities();

}  // namespace overbend::field_rows
