#include <array>
#include <limits>

#include "base/constants.h"
#include "model/description/description_enum_names.h"
#include "modelfile/fields/field_rows_lines.h"
#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {
namespace {

using Line = FreeLineDescription;
using End = LineEndDescription;

const std::string kEnd = "lines[].ends[]";

/// Items of a list know their index only from their path.
LineEndDescription& open_end(Line& line, const FieldValue& end) {
  return end.path.ends_with("[0]") ? line.first : line.second;
}

Member end_place(LineEndKind kind) {
  return opened_by<End>([kind](End& end, const FieldValue&) -> Vec3& {
    end.kind = kind;
    return end.at;
  });
}

std::vector<Field> places() {
  std::vector<Field> rows = vector_rows({.group = otherwise(group_row(kEnd + ".fixed", end_place(LineEndKind::fixed),
                                                                      "Fixed at this point of the world frame."),
                                                            "another of fixed, body, bed and water"),
                                         .shown = kLength,
                                         .texts = world_axis_texts()});
  rows.push_back(
      otherwise(row_of_kind(FieldKind::text, kEnd + ".body", taken_by<End>([](End& end, const FieldValue& name) {
                              end.kind = LineEndKind::body;
                              end.body = name.text;
                            }),
                            "Attached to this body at the point `at`: `vessel`, or a name under `bodies`."),
                "another of fixed, body, bed and water"));
  append(rows,
         vector_rows({.group = otherwise(group_row(kEnd + ".at", enters(&End::at), "Point of the body, in its frame."),
                                         "required with body"),
                      .shown = kLength,
                      .texts = vessel_axis_texts()}));
  std::vector<std::string> on_bed = world_axis_texts();
  on_bed.pop_back();
  append(rows,
         vector_rows({.group = otherwise(group_row(kEnd + ".bed", end_place(LineEndKind::bed), "Held on the seabed."),
                                         "another of fixed, body, bed and water"),
                      .shown = kLength,
                      .texts = on_bed}));
  Field free = otherwise(row_of_kind(FieldKind::choice, kEnd + ".free",
                                     taken_by<End>([](End& end, const FieldValue&) { end.kind = LineEndKind::free; }),
                                     "Free end: a pipe that lies on the seabed, or is carried by other lines."),
                         "another of fixed, body, bed, water and line");
  free.choices = {"true"};
  rows.push_back(free);
  rows.push_back(
      otherwise(row_of_kind(FieldKind::text, kEnd + ".line", taken_by<End>([](End& end, const FieldValue& name) {
                              end.kind = LineEndKind::line;
                              end.line = name.text;
                            }),
                            "Attached to this other line, free to rotate; `pipe` is the laid pipe."),
                "another of fixed, body, bed, water and free"));
  rows.push_back(otherwise(
      quantity_row(
          kEnd + ".arc_length", fills(&End::arc_length),
          "Unstressed length to the attachment from the first end of that line, for the pipe from the tensioner.",
          kLength, kNotNegative),
      "required with line"));
  append(rows, vector_rows({.group = otherwise(group_row(kEnd + ".water", end_place(LineEndKind::water),
                                                         "Fixed at a point between seabed and water level."),
                                               "another of fixed, body, bed and water"),
                            .shown = kLength,
                            .texts = world_axis_texts()}));
  return rows;
}

std::vector<Field> direction() {
  const auto open = [](End& end, const FieldValue&) -> Vec3& {
    end.clamped = true;
    return end.direction;
  };
  const std::vector<std::string> texts = {"Along x.", "Along y.", "Along z."};
  const std::string d = kEnd + ".direction";
  std::vector<Field> rows = {otherwise(
      group_row(d, opened_by<End>(open), "Direction of the line at a clamped end, from the first end to the second."),
      "the end is free to turn")};
  for (int i = 0; i < 3; ++i) {
    constexpr std::array kKeys = {".x", ".y", ".z"};
    rows.push_back(row_of_kind(FieldKind::number, d + kKeys[static_cast<std::size_t>(i)],
                               with_default(component(i), 0.0), texts[static_cast<std::size_t>(i)],
                               {.low = -1e6, .high = 1e6}));
  }
  return rows;
}

std::vector<Field> motion() {
  const std::string m = kEnd + ".motion";
  std::vector<Field> rows = {otherwise(group_row(m, {},
                                                 "Prescribed motion amplitude * sin(2 pi t / period + phase) of an end "
                                                 "that is not on a body; only dynamic analysis uses it."),
                                       "at rest")};
  append(rows, vector_rows({.group = required(group_row(m + ".amplitude", enters(&End::amplitude), "Amplitudes.")),
                            .shown = kLength,
                            .texts = {"To the east.", "To the north.", "Upwards."},
                            .all = false}));
  append(rows, {required(quantity_row(m + ".period", fills(&End::period), "Period.", kTime, kPositive)),
                quantity_row(m + ".phase", defaults(&End::phase), "Phase at t = 0.", kAngle, azimuth())});
  return rows;
}

/// Keys of a segment that is pipe.
std::vector<Field> pipe_of_segments() {
  const std::string s = "lines[].segments[]";
  std::vector<Field> rows = pipe_section_rows(s);
  for (Field& row : rows) {
    const bool below_another = row.path.find_first_of(".[", s.size() + 1) != std::string::npos;
    if (!below_another) row.member = through(&LineSegmentDescription::section, row.member);
  }
  return rows;
}

std::vector<Field> start() {
  const auto open = [](Line& line, const FieldValue&) -> Vec3& { return line.start.emplace(Vec3::Zero()); };
  std::vector<std::string> axis_texts = world_axis_texts();
  axis_texts.pop_back();
  return vector_rows({.group = otherwise(group_row("lines[].start", opened_by<Line>(open),
                                                   "Initial position of its first end before any lifting."),
                                         "straight on the seabed from the end that is held"),
                      .shown = kLength,
                      .texts = axis_texts});
}

}  // namespace

std::vector<Field> free_lines() {
  Field ends = required(list_row("lines[].ends", {}, "Attachments of its two ends.", ""));
  ends.min_items = ends.max_items = 2;
  std::vector<Field> rows = {
      list_row("lines", enters(&Description::lines), "Cables, chains and flexibles between two ends.", "none"),
      group_row("lines[]", appends_named<Line>("line"), "One line."),
      otherwise(
          row_of_kind(FieldKind::text, "lines[].name", fills(&Line::name), "Name in the results; must be unique."),
          "line 1, 2, ..."),
      ends,
      group_row(kEnd, opened_by<Line>(open_end),
                "One end: fixed, body with at, bed, water, free, or line with arc_length.")};
  append(rows, places());
  append(rows, direction());
  append(rows, motion());
  append(rows, line_body_rows<Line>("lines[]"));
  append(rows, pipe_of_segments());
  append(rows, point_rows<Line>("lines[]", "from its first end"));
  append(rows, start());
  append(rows, {otherwise(quantity_row("lines[].element", fills(&Line::element), "Length of its elements.", kLength,
                                       {.low = 0.02, .high = 1000.0}),
                          "chosen by the program")});
  return rows;
}

}  // namespace overbend::field_rows
