#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {
namespace {

using Lay = LayOperationDescription;

/// Member of a key of operations on the laid line, under the group `operation`.
Member of_lay(const Member& member) {
  return through(&OperationDescription::lay, member);
}

std::vector<Field> head() {
  using Head = HeadDescription;
  const std::string p = "operation.head";
  const auto as_pipe = [](Head& head, const FieldValue&) { head.section.reset(); };
  Field word = row_of_kind(FieldKind::choice, p + ".section", with_default(taken_by<Head>(as_pipe), "pipe"),
                           "pipe: stiffness, diameter and drag of the head are the pipe's; or a group of the keys "
                           "below.");
  word.choices = {"pipe"};
  std::vector<Field> rows = {
      otherwise(group_row(p, of_lay(enters(&Lay::head)), "Head that closes the pipe and connects the cable."),
                "required by abandonment, recovery, lay_down, start_up, shore_pull and hold_back"),
      required(quantity_row(p + ".length", fills(&Head::length), "Its length.", kLength,
                            {.low = 0.0, .high = 100.0, .low_open = true})),
      required(quantity_row(p + ".weight_in_air", fills(&Head::weight_in_air),
                            "Weight of the whole head in air, distributed over its length.", kForce, kPositive)),
      required(quantity_row(p + ".weight_submerged", fills(&Head::weight_submerged),
                            "Weight of the whole head under water; negative for one that floats.", kForce)),
      word,
      group_row(p + ".section", read_elsewhere(),
                "Section of the head: its stiffness, diameter and drag; its weight is given above.")};
  append(rows, head_section_rows(p + ".section"));
  return rows;
}

std::vector<Field> cable() {
  using Cable = CableDescription;
  const std::string p = "operation.cable";
  const Shown weight = {"N/m", "N/m"};
  const auto coefficient = [&](const std::string& key, double Cable::*member, const std::string& text) {
    return row_of_kind(FieldKind::number, p + "." + key, defaults(member), text, {.low = 0.0, .high = 10.0});
  };
  return {
      otherwise(group_row(p, of_lay(enters(&Lay::cable)), "The cable, which has no bending stiffness."),
                "required by abandonment, recovery, lay_down, start_up, shore_pull and hold_back"),
      required(quantity_row(p + ".diameter", fills(&Cable::diameter),
                            "Contact diameter on rollers and seabed, and drag diameter.", {"m", "mm"},
                            {.low = 0.0, .high = 1.0, .low_open = true})),
      required(quantity_row(p + ".weight_in_air", fills(&Cable::weight_in_air), "Weight per length in air.", weight,
                            kPositive)),
      required(quantity_row(p + ".weight_submerged", fills(&Cable::weight_submerged),
                            "Weight per length under water; negative for a cable that floats.", weight)),
      required(quantity_row(p + ".axial_stiffness", fills(&Cable::axial_stiffness), "Axial stiffness EA.", kForce,
                            kPositive)),
      otherwise(quantity_row(p + ".breaking_load", fills(&Cable::breaking_load),
                             "Minimum breaking load, for the utilisation.", kForce, kPositive),
                "not checked"),
      coefficient("drag_normal", &Cable::drag_normal, "Normal drag."),
      coefficient("drag_axial", &Cable::drag_axial, "Axial drag, on the circumference."),
      coefficient("added_mass_normal", &Cable::added_mass_normal, "Normal added mass over the displaced water."),
      coefficient("added_mass_axial", &Cable::added_mass_axial, "Axial added mass over the displaced water."),
      otherwise(quantity_row(p + ".length", fills(&Cable::length),
                             "start_up: unstressed length from the head to the anchor; shore_pull and hold_back: cable "
                             "length on the winch.",
                             kLength, kPositive),
                "required by start_up; otherwise as long as needed"),
      otherwise(
          row_of_kind(FieldKind::number, p + ".friction", fills(&Cable::friction),
                      "shore_pull and hold_back: friction of the cable on the seabed, divided by its normal force.",
                      {.low = 0.0, .high = 10.0}),
          "environment.seabed.friction.axial"),
  };
}

}  // namespace

std::vector<Field> lay_operation() {
  std::vector<Field> rows = head();
  append(rows, cable());
  Field winch = otherwise(group_row("operation.winch", of_lay(enters(&Lay::winch)),
                                    "Position of the cable's fixed end: abandonment, recovery and lay_down by x and z, "
                                    "shore_pull and hold_back by distance and depth."),
                          "the tensioner's position; required by shore_pull and hold_back");
  winch.min_items = 1;
  append(
      rows,
      {winch,
       otherwise(quantity_row("operation.winch.x", fills(&WinchPlace::x),
                              "Astern of the stern shoe, as for the tensioner.", kLength),
                 "required by abandonment, recovery and lay_down"),
       otherwise(quantity_row("operation.winch.z", fills(&WinchPlace::z), "Above the stern shoe, as for the tensioner.",
                              kLength),
                 "required by abandonment, recovery and lay_down"),
       otherwise(
           quantity_row("operation.winch.distance", fills(&WinchPlace::distance),
                        "Horizontal distance of the cable's fixed end astern of the stern shoe.", kLength, kPositive),
           "required by shore_pull and hold_back"),
       otherwise(quantity_row("operation.winch.depth", fills(&WinchPlace::depth),
                              "Depth of that end below the water; negative above the water, ashore.", kLength),
                 "required by shore_pull and hold_back"),
       otherwise(group_row("operation.anchor", of_lay(enters(&Lay::anchor)),
                           "start_up: dead-man anchor or bow-string to which the cable is pinned."),
                 "required by start_up"),
       required(quantity_row("operation.anchor.depth", fills(&StartUpAnchor::depth),
                             "Depth of the pin below the water; for a cable that lies on the seabed, that of its axis.",
                             kLength, kPositive)),
       otherwise(quantity_row("operation.anchor.distance", fills(&StartUpAnchor::distance),
                              "Distance of the pin astern of the stern shoe. The tension of each stage follows.",
                              kLength, kPositive),
                 "follows from the tension of each stage"),
       otherwise(row_of_kind(FieldKind::text, "operation.tank", of_lay(fills(&Lay::tank)),
                             "ballast: name of the tank of the stinger."),
                 "required by ballast")});
  return rows;
}

}  // namespace overbend::field_rows
