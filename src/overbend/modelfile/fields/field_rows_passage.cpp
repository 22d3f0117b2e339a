#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {
namespace {

using Built = StructureDescription;

/// Keys of drag and added mass, as for a section.
std::vector<Field> hydrodynamics(const std::string& p) {
  const auto coefficient = [&](const char* key, std::optional<double> Built::*member, const char* text) {
    return otherwise(row_of_kind(FieldKind::number, p + key, fills(member), text, {.low = 0.0, .high = 10.0}),
                     "that of the pipe there");
  };
  return {coefficient(".drag_normal", &Built::drag_normal, "Drag coefficient across its axis, on its diameter."),
          coefficient(".drag_axial", &Built::drag_axial, "Drag coefficient along its axis."),
          coefficient(".added_mass_normal", &Built::added_mass_normal, "Added mass coefficient across its axis."),
          coefficient(".added_mass_axial", &Built::added_mass_axial, "Added mass coefficient along its axis.")};
}

}  // namespace

std::vector<Field> structures() {
  const std::string s = "pipe.structures[]";
  std::vector<Field> rows = {
      list_row("pipe.structures", enters(&PipeDescription::structures),
               "In-line structures: arrestors, tees, end terminations. Each replaces the pipe over its length.",
               "none"),
      group_row(s, appends_named<Built>("structure"), "One structure."),
      otherwise(row_of_kind(FieldKind::text, s + ".name", fills(&Built::name), "Name in results and operations."),
                "structure 1, 2, ..."),
      otherwise(quantity_row(s + ".at", fills(&Built::at), "Unstressed length from the tensioner to its middle.",
                             kLength, kNotNegative),
                "only in the line during its passage (operation.type: passage)"),
      required(quantity_row(s + ".length", fills(&Built::length), "Unstressed length.", kLength,
                            {.low = 0.1, .high = 200.0})),
      required(quantity_row(s + ".weight_in_air", fills(&Built::weight_in_air),
                            "Weight of the whole structure in air, distributed over its length.", kForce, kPositive)),
      required(quantity_row(s + ".weight_submerged", fills(&Built::weight_submerged),
                            "Weight of the whole structure under water; negative if it floats.", kForce)),
      otherwise(quantity_row(s + ".bending_stiffness", fills(&Built::bending_stiffness), "Bending stiffness EI.",
                             {"N*m^2", "kN*m^2"}, kPositive),
                "that of the pipe there"),
      otherwise(quantity_row(s + ".axial_stiffness", fills(&Built::axial_stiffness), "Axial stiffness EA.", kForce,
                             kPositive),
                "that of the pipe there"),
      otherwise(quantity_row(s + ".diameter", fills(&Built::diameter),
                             "Contact diameter on rollers and seabed, and drag diameter.", {"m", "mm"},
                             {.low = 0.0, .high = 10.0, .low_open = true}),
                "that of the pipe there")};
  append(rows, hydrodynamics(s));
  return rows;
}

Field passing_structure() {
  return otherwise(row_of_kind(FieldKind::text, "operation.structure",
                               through(&OperationDescription::lay, fills(&LayOperationDescription::structure)),
                               "passage: name of the structure under pipe.structures that moves along the line."),
                   "required by passage");
}

}  // namespace overbend::field_rows
