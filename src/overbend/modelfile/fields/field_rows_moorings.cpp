#include <array>

#include "model/description/description_enum_names.h"
#include "modelfile/fields/field_rows_lines.h"
#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {
namespace {

using Line = MooringLineDescription;

LineTypeDescription& add_type(MooringsDescription& moorings, const FieldValue& name) {
  LineTypeDescription& type = moorings.types.emplace_back(make_open_line_type());
  type.name = name.key;
  return type;
}

WinchDescription& add_winch(MooringsDescription& moorings, const FieldValue& name) {
  WinchDescription& winch = moorings.winches.emplace_back();
  winch.name = name.key;
  return winch;
}

std::vector<Field> winch_program(const std::string& winch) {
  using Step = WinchStepDescription;
  const std::string p = winch + ".program";
  return {
      list_row(p, enters(&WinchDescription::program),
               "Payout of the winch over time. Mode speed: steps start at their times and run one after the other at "
               "the winch speed. Mode length: payouts reached at their times, smooth in between.",
               "follows the operation"),
      group_row(p + "[]", appends<Step>(), "One step."),
      required(quantity_row(p + "[].time", fills(&Step::time), "Time.", kTime, kNotNegative)),
      required(quantity_row(p + "[].paid_out", fills(&Step::paid_out),
                            "Total paid out since the start of the run; negative is hauled in.", kLength)),
  };
}

std::vector<Field> winches() {
  using Winch = WinchDescription;
  const std::string w = "moorings.winches.*";
  std::vector<Field> rows = {
      otherwise(group_row("moorings.winches", {}, "Winches, each with a user-defined name, to which the lines refer."),
                "lines of constant length"),
      group_row(w, opened_by<MooringsDescription>(add_winch), "One kind of winch."),
      row_of_kind(
          FieldKind::choice, w + ".mode", defaults(&Winch::mode),
          "hold: brake on; speed: hauls or pays out at its speed; length: follows the lengths of the operation; "
          "tension: keeps a tension."),
      quantity_row(w + ".speed", defaults(&Winch::speed), "Speed of hauling and paying out.", kSpeed,
                   {.low = 0.0, .high = 20.0, .low_open = true}),
      otherwise(quantity_row(w + ".haul", fills(&Winch::haul),
                             "Tension up to which it hauls at its speed; without `stall` it hauls no further, with it "
                             "the speed is constant up to `stall`.",
                             kForce, kPositive),
                "not limited"),
      otherwise(
          quantity_row(w + ".stall", fills(&Winch::stall), "Tension at which it stops hauling.", kForce, kPositive),
          "not limited"),
      otherwise(
          quantity_row(w + ".brake", fills(&Winch::brake), "Tension at which its brake renders.", kForce, kPositive),
          "the brake holds"),
      otherwise(
          quantity_row(w + ".tension", fills(&Winch::tension), "Target tension in mode tension.", kForce, kPositive),
          "not used"),
      otherwise(
          quantity_row(w + ".band", fills(&Winch::band),
                       "Mode tension: deadband on either side of the target tension within which the winch holds.",
                       kForce, kPositive),
          "10 % of the tension"),
      quantity_row(w + ".delay", defaults(&Winch::delay), "Mode tension: time before it reacts.", kTime,
                   {.low = 0.0, .high = 3600.0}),
      quantity_row(w + ".acceleration_time", defaults(&Winch::acceleration_time), "Time to reach its speed.", kTime,
                   {.low = 0.0, .high = 3600.0, .low_open = true}),
      otherwise(quantity_row(w + ".drum", fills(&Winch::drum), "Length of line on the drum.", kLength, kPositive),
                "not checked"),
  };
  append(rows, winch_program(w));
  return rows;
}

/// Point on the seabed by x and y.
std::vector<Field> anchor() {
  using Place = std::array<double, 2>;
  const auto open = [](Line& line, const FieldValue&) -> Place& { return line.anchor.emplace(); };
  const auto take = [](std::size_t i) {
    return taken_by<Place>([i](Place& place, const FieldValue& value) { place[i] = value.number; });
  };
  const std::string a = "moorings.lines[].anchor";
  return {
      otherwise(group_row(a, opened_by<Line>(open), "Position of the anchor in the world frame."),
                "follows from direction and distance"),
      required(quantity_row(a + ".x", take(0), world_axis_texts()[0], kLength)),
      required(quantity_row(a + ".y", take(1), world_axis_texts()[1], kLength)),
  };
}

std::vector<Field> place_of_line() {
  const std::string l = "moorings.lines[]";
  std::vector<Field> rows =
      vector_rows({.group = required(group_row(l + ".fairlead", enters(&Line::fairlead),
                                               "Position of the fairlead, in the vessel's frame.")),
                   .shown = kLength,
                   .texts = vessel_axis_texts()});
  append(rows,
         {otherwise(quantity_row(l + ".azimuth", fills(&Line::azimuth),
                                 "Direction from the fairlead to the anchor, clockwise from north.", kAngle, azimuth()),
                    "bearing or anchor is given"),
          otherwise(quantity_row(l + ".bearing", fills(&Line::bearing),
                                 "Same direction, clockwise from the bow of the vessel as drawn.", kAngle, azimuth()),
                    "azimuth or anchor is given"),
          otherwise(
              quantity_row(l + ".anchor_distance", fills(&Line::anchor_distance),
                           "Horizontal distance from the fairlead to the anchor, vessel as drawn.", kLength, kPositive),
              "anchor is given")});
  append(rows, anchor());
  return rows;
}

std::vector<Field> mooring_lines() {
  const std::string l = "moorings.lines[]";
  std::vector<Field> rows = {
      list_row("moorings.lines", enters(&MooringsDescription::lines), "Mooring lines.", "none"),
      group_row(l, appends_named<Line>("line"), "One mooring line."),
      otherwise(row_of_kind(FieldKind::text, l + ".name", fills(&Line::name), "Name in the results; must be unique."),
                "line 1, 2, ..."),
  };
  append(rows, place_of_line());
  append(rows, {otherwise(quantity_row(l + ".tension", fills(&Line::tension),
                                       "Tension at the fairlead with the vessel as drawn; the length of the first "
                                       "segment follows from it.",
                                       kForce, kPositive),
                          "follows from the length")});
  append(rows, line_body_rows<Line>(l));
  append(
      rows,
      {otherwise(row_of_kind(FieldKind::text, l + ".winch", fills(&Line::winch), "A name under moorings.winches."),
                 "the length of the line is constant"),
       otherwise(quantity_row(l + ".anchor_holding", taken_by<Line>([](Line& line, const FieldValue& value) {
                                line.anchor_holding.holding = value.number;
                              }),
                              "Holding power of the anchor along the line.", kForce, kPositive),
                 "not checked"),
       row_of_kind(FieldKind::choice, l + ".anchor_slides",
                   with_default(through(&Line::anchor_holding, fills(&AnchorDescription::slides)), std::string("no")),
                   "yes: the anchor drags above its holding power; no: it is fixed, and its utilisation is reported."),
       otherwise(
           group_row(
               l + ".useful", enters(&Line::useful),
               "Range within which the line can be used as the vessel advances, for operation.type: anchor_plan."),
           "its anchor is not moved"),
       otherwise(quantity_row(l + ".useful.least_length", fills(&UsefulRange::min_length),
                              "Minimum unstressed length of the line.", kLength, kPositive),
                 "no bound"),
       otherwise(quantity_row(l + ".useful.most_length", fills(&UsefulRange::max_length),
                              "Maximum unstressed length of the line.", kLength, kPositive),
                 "no bound"),
       otherwise(quantity_row(l + ".useful.sector", fills(&UsefulRange::sector),
                              "Maximum change of its direction, either way from that as drawn.", kAngle,
                              {.low = 0.0, .high = 3.14159265358979323846, .low_open = true}),
                 "no bound"),
       otherwise(quantity_row(l + ".fails_at", fills(&Line::fails_at), "Time at which the line fails at its fairlead.",
                              kTime, kNotNegative),
                 "it does not fail")});
  return rows;
}

std::vector<Field> objects() {
  using Object = SeabedObjectDescription;
  const std::string o = "moorings.objects[]";
  std::vector<Field> rows = {
      list_row("moorings.objects", enters(&MooringsDescription::objects),
               "Objects on the seabed; the minimum distance of each line to them is reported.", "none"),
      group_row(o, appends_named<Object>("object"), "One object."),
      otherwise(row_of_kind(FieldKind::text, o + ".name", fills(&Object::name), "Name in the results."),
                "object 1, 2, ..."),
      list_row(o + ".points", enters(&Object::points), "A point, or the corners of a polyline such as a pipeline.",
               "")};
  rows.back().required = true;
  rows.back().min_items = 1;
  append(rows, vector_rows({.group = group_row(o + ".points[]", appends<Vec3>(), "One point, in the world frame."),
                            .shown = kLength,
                            .texts = world_axis_texts()}));
  return rows;
}

}  // namespace

std::vector<Field> moorings() {
  using Moorings = MooringsDescription;
  std::vector<Field> rows = {
      otherwise(group_row("moorings", enters(&Description::moorings), "Mooring lines of the vessel."), "none"),
      otherwise(group_row("moorings.types", {},
                          "Line types, each with a user-defined name, to which lines and segments refer."),
                "segments have their properties in place"),
      group_row("moorings.types.*", opened_by<Moorings>(add_type), "One type of line."),
  };
  append(rows, line_type_rows("moorings.types.*"));
  append(rows, winches());
  append(rows, mooring_lines());
  append(rows, objects());
  append(rows,
         {otherwise(row_of_kind(FieldKind::choice, "moorings.find", fills(&Moorings::find),
                                "pose: finds the position of the vessel on lines of given length; lengths: finds the "
                                "lengths that hold it as drawn, with tensions as near as possible to those given."),
                    "pose"),
          row_of_kind(FieldKind::choice, "moorings.model", defaults(&Moorings::model),
                      "elements: lines with inertia and drag; quasi_static: elastic catenaries."),
          otherwise(quantity_row("moorings.working_load", fills(&Moorings::working_load),
                                 "Maximum tension when lengths are found.", kForce, kPositive),
                    "not limited"),
          otherwise(quantity_row("moorings.least_tension", fills(&Moorings::min_tension),
                                 "Minimum tension when lengths are found.", kForce, kPositive),
                    "not limited"),
          otherwise(
              row_of_kind(FieldKind::number, "moorings.friction", fills(&Moorings::bed_friction),
                          "Coulomb friction on the seabed of lines whose type gives none.", {.low = 0.0, .high = 5.0}),
              "environment.seabed.friction")});
  return rows;
}

}  // namespace overbend::field_rows
