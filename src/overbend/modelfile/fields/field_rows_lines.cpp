#include "modelfile/fields/field_rows_lines.h"

#include <cmath>
#include <limits>

#include "base/constants.h"
#include "model/description/description_enum_names.h"
#include "model/pipe/line_types.h"
#include "model/pipe/section.h"
#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {
namespace {

constexpr double kPending = std::numeric_limits<double>::quiet_NaN();  // placeholder until resolve_lines

/// A kind replaces all numbers; those given in addition are bound after it.
void take_kind(LineTypeDescription& type, LineTypeDescription kind) {
  kind.name = type.name;
  kind.weight_submerged = kPending;
  type = std::move(kind);
}

void take_rope(LineTypeDescription& type, const FieldValue& group) {
  take_kind(type, wire_rope(group.get_number("diameter").value_or(0.0),
                            group.get_word<RopeCore>("core").value_or(RopeCore::wire)));
}

void take_chain(LineTypeDescription& type, const FieldValue& group) {
  take_kind(type, chain(group.get_number("diameter").value_or(0.0),
                        group.get_word<ChainLink>("link").value_or(ChainLink::studless)));
}

/// Reads a text of a group into the group's own object.
template <HasEnumNames Enum>
Field word_of_kind(const std::string& path, const std::string& text, Enum standard) {
  Field row =
      row_of_kind(FieldKind::choice, path, with_default(read_elsewhere(), std::string(enum_name(standard))), text);
  row.choices = enum_names<Enum>();
  return row;
}

std::vector<Field> kinds(const std::string& p) {
  const Range diameter = {.low = 0.0, .high = 1.0, .low_open = true};
  return {
      otherwise(group_row(p + ".wire_rope", taken_by<LineTypeDescription>(take_rope),
                          "Six-strand wire rope by its diameter: mass, stiffness, breaking load and drag from tables."),
                "numbers are given"),
      required(quantity_row(p + ".wire_rope.diameter", read_elsewhere(), "Nominal diameter.", {"m", "mm"}, diameter)),
      word_of_kind(p + ".wire_rope.core", "Its core.", RopeCore::wire),
      otherwise(group_row(p + ".chain", taken_by<LineTypeDescription>(take_chain),
                          "Chain of grade R4 by the diameter of its bar: mass, stiffness, breaking load and drag from "
                          "tables."),
                "numbers are given"),
      required(quantity_row(p + ".chain.diameter", read_elsewhere(), "Diameter of the bar.", {"m", "mm"}, diameter)),
      word_of_kind(p + ".chain.link", "Its links.", ChainLink::studless),
  };
}

std::vector<Field> numbers(const std::string& p) {
  using Type = LineTypeDescription;
  const Shown weight = {"N/m", "N/m"};
  const auto take_mass = [](Type& type, const FieldValue& mass) { type.weight_in_air = mass.number * kGravity; };
  return {
      otherwise(quantity_row(p + ".diameter", fills(&Type::diameter), "Outside diameter.", {"m", "mm"},
                             {.low = 0.0, .high = 5.0, .low_open = true}),
                "that of wire_rope or chain"),
      otherwise(quantity_row(p + ".mass", taken_by<Type>(take_mass), "Mass per length, in place of weight_in_air.",
                             {"kg/m", "kg/m"}, kPositive),
                "weight_in_air is given"),
      otherwise(quantity_row(p + ".weight_in_air", fills(&Type::weight_in_air),
                             "Weight per length in air; 0 with weight_submerged 0: a straight wire without weight.",
                             weight, kNotNegative),
                "follows from mass, wire_rope or chain"),
      otherwise(quantity_row(p + ".weight_submerged", fills(&Type::weight_submerged),
                             "Weight per length under water; negative for a line that floats.", weight),
                "weight in air less that of the water displaced by a cylinder of its diameter"),
      otherwise(
          quantity_row(p + ".axial_stiffness", fills(&Type::axial_stiffness), "Axial stiffness EA.", kForce, kPositive),
          "that of wire_rope or chain"),
      quantity_row(p + ".bending_stiffness", defaults(&Type::bending_stiffness), "Bending stiffness EI.",
                   {"N*m^2", "kN*m^2"}, kNotNegative),
      otherwise(row_of_kind(FieldKind::choice, p + ".compression", fills(&Type::compression),
                            "Carries compression; if no, the line goes slack."),
                "yes if bending_stiffness is given; no for wire_rope and chain"),
      otherwise(quantity_row(p + ".breaking_load", fills(&Type::breaking_load),
                             "Minimum breaking load, for the utilisation.", kForce, kPositive),
                "none, or that of wire_rope or chain"),
  };
}

std::vector<Field> water_forces(const std::string& p) {
  using Type = LineTypeDescription;
  const Range coefficient = {.low = 0.0, .high = 10.0};
  const auto number = [&](const std::string& key, double Type::*member, const std::string& text,
                          const std::string& standard) {
    return otherwise(row_of_kind(FieldKind::number, p + ".hydrodynamics." + key, fills(member), text, coefficient),
                     standard + "; that of wire_rope or chain");
  };
  return {
      group_row(p + ".hydrodynamics", {}, "Morison coefficients."),
      number("drag_normal", &Type::drag_normal, "Normal drag coefficient, on drag_diameter.", "1.2"),
      number("drag_axial", &Type::drag_axial,
             "Axial drag coefficient, on the circumference of drag_diameter: for chain the catalogue value, on the "
             "projected area, divided by pi.",
             "0"),
      otherwise(quantity_row(p + ".hydrodynamics.drag_diameter", fills(&Type::drag_diameter),
                             "Reference diameter of the drag coefficients.", {"m", "mm"},
                             {.low = 0.0, .high = 5.0, .low_open = true}),
                "the diameter; that of wire_rope or chain"),
      number("added_mass_normal", &Type::added_mass_normal, "Normal added mass over the displaced water.", "1"),
      number("added_mass_axial", &Type::added_mass_axial, "Axial added mass over the displaced water.", "0"),
      otherwise(row_of_kind(FieldKind::number, p + ".friction", fills(&Type::friction),
                            "Coulomb friction on the seabed.", {.low = 0.0, .high = 5.0}),
                "0.6 for wire_rope, 1 for chain, otherwise moorings.friction"),
  };
}

/// Key given for the line instead of its segments, for a line with a single one.
template <typename Line>
LineSegmentDescription& only_segment(Line& line) {
  return line.segments.empty() ? start_segment(line.segments) : line.segments.front();
}

LineSegmentDescription& add_segment(std::vector<LineSegmentDescription>& list, const FieldValue&) {
  return start_segment(list);
}

void name_type(LineSegmentDescription& segment, const FieldValue& name) {
  segment.type.name = name.text;
}

template <typename Line, PointKind kind>
LinePointDescription& add_point(Line& line, const FieldValue&) {
  LinePointDescription& point = line.points.emplace_back();
  point.kind = kind;
  point.volume = kind == PointKind::buoy ? kPending : 0.0;
  point.added_mass = kPending;
  int count = 0;
  for (const LinePointDescription& item : line.points) count += item.kind == kind ? 1 : 0;
  point.name = std::string(enum_name(kind)) + " " + std::to_string(count);
  return point;
}

/// Keys common to clumps and buoys.
std::vector<Field> common_point(const std::string& p) {
  using Point = LinePointDescription;
  return {
      otherwise(row_of_kind(FieldKind::text, p + ".name", fills(&Point::name), "Name in the results."),
                "clump or buoy 1, 2, ..."),
      required(quantity_row(p + ".at", fills(&Point::at),
                            "Unstressed length along the line from its first end, for a mooring line the fairlead.",
                            kLength, kNotNegative)),
      quantity_row(p + ".drag_area", defaults(&Point::drag_area), "Drag coefficient times area.", kArea, kNotNegative),
      otherwise(quantity_row(p + ".added_mass", fills(&Point::added_mass), "Added mass.", kMass, kNotNegative),
                "half the displaced water, as for a sphere"),
      quantity_row(p + ".tether", defaults(&Point::tether),
                   "Length of a tether between it and the line; 0: on the line.", kLength, kNotNegative),
  };
}

template <typename Line>
std::vector<Field> clumps(const std::string& p) {
  using Point = LinePointDescription;
  const std::string c = p + ".clumps[]";
  std::vector<Field> rows = {list_row(p + ".clumps", {}, "Clump weights on the line.", "none"),
                             group_row(c, opened_by<Line>(add_point<Line, PointKind::clump>), "One clump weight."),
                             required(quantity_row(c + ".mass", fills(&Point::mass), "Mass.", kMass, kPositive)),
                             quantity_row(c + ".volume", defaults(&Point::volume), "Volume of displaced water.",
                                          {"m^3", "m^3"}, kNotNegative)};
  append(rows, common_point(c));
  return rows;
}

template <typename Line>
std::vector<Field> buoys(const std::string& p) {
  using Point = LinePointDescription;
  const std::string b = p + ".buoys[]";
  std::vector<Field> rows = {
      list_row(p + ".buoys", {}, "Buoys on the line.", "none"),
      group_row(b, opened_by<Line>(add_point<Line, PointKind::buoy>), "One buoy."),
      required(quantity_row(b + ".net_buoyancy", fills(&Point::net_force),
                            "Upward force when submerged: buoyancy less weight.", kForce, kPositive)),
      quantity_row(b + ".mass", defaults(&Point::mass), "Mass.", kMass, kNotNegative),
      row_of_kind(FieldKind::choice, b + ".shape", defaults(&Point::shape),
                  "Shape, for the buoyancy lost at the surface."),
      quantity_row(b + ".height", defaults(&Point::height), "Height of a cylinder.", kLength, kNotNegative)};
  append(rows, common_point(b));
  return rows;
}

std::vector<Field> segments(const std::string& p) {
  const std::string s = p + ".segments[]";
  std::vector<Field> rows = {
      group_row(s, opened_by<std::vector<LineSegmentDescription>>(add_segment),
                "One segment: a type by its name, or properties in place."),
      otherwise(row_of_kind(FieldKind::text, s + ".name", fills(&LineSegmentDescription::name), "For the report."),
                "segment 1, 2, ..."),
      otherwise(row_of_kind(FieldKind::text, s + ".type", taken_by<LineSegmentDescription>(name_type),
                            "A name under moorings.types."),
                "properties are given in place"),
      otherwise(
          quantity_row(s + ".length", fills(&LineSegmentDescription::length), "Unstressed length.", kLength, kPositive),
          "for the first segment of a mooring line: follows from the tension")};
  std::vector<Field> type = line_type_rows(s);
  for (Field& row : type) {
    const bool below_another = row.path.find_first_of(".[", s.size() + 1) != std::string::npos;
    if (!below_another) row.member = through(&LineSegmentDescription::type, row.member);
  }
  append(rows, type);
  return rows;
}

}  // namespace

LineTypeDescription make_open_line_type() {
  LineTypeDescription type;
  type.weight_submerged = type.volume_diameter = type.drag_diameter = kPending;
  return type;
}

LineSegmentDescription& start_segment(std::vector<LineSegmentDescription>& list) {
  LineSegmentDescription& segment = list.emplace_back();
  segment.name = "segment " + std::to_string(list.size());
  segment.type = make_open_line_type();
  return segment;
}

std::vector<Field> line_type_rows(const std::string& p) {
  std::vector<Field> rows = kinds(p);
  append(rows, numbers(p));
  append(rows, water_forces(p));
  return rows;
}

template <typename Line>
std::vector<Field> line_body_rows(const std::string& p) {
  const auto take_type = [](Line& line, const FieldValue& name) { name_type(only_segment(line), name); };
  const auto take_length = [](Line& line, const FieldValue& length) { only_segment(line).length = length.number; };
  std::vector<Field> rows = {
      otherwise(row_of_kind(FieldKind::text, p + ".type", taken_by<Line>(take_type),
                            "Type of a line without segments, a name under moorings.types."),
                "segments are given"),
      otherwise(quantity_row(p + ".length", taken_by<Line>(take_length),
                             "Unstressed length of a line without segments.", kLength, kPositive),
                "segments are given, or a tension"),
      at_least(1, list_row(p + ".segments", enters(&Line::segments),
                           "Segments from the first end, for a mooring line the fairlead.",
                           "a single segment of type and length"))};
  append(rows, segments(p));
  append(rows, clumps<Line>(p));
  append(rows, buoys<Line>(p));
  return rows;
}
namespace {

/// Clump or buoy by weight and displacement; resolve_lines() converts the force stored here to a volume.
template <typename Holder>
LinePointDescription& add_point_by_weight(Holder& holder, const FieldValue&) {
  LinePointDescription& point = holder.points.emplace_back();
  point.kind = PointKind::buoy;
  point.by_weight = true;
  point.added_mass = kPending;
  point.name = "point " + std::to_string(holder.points.size());
  return point;
}

}  // namespace

template <typename Holder>
std::vector<Field> point_rows(const std::string& p, const std::string& from) {
  using Point = LinePointDescription;
  const std::string points = p + ".points[]";
  return {
      list_row(p + ".points", {}, "Clumps and buoys by weight and buoyancy.", "none"),
      group_row(points, opened_by<Holder>(add_point_by_weight<Holder>), "One clump or buoy."),
      otherwise(row_of_kind(FieldKind::text, points + ".name", fills(&Point::name), "Name in the results."),
                "point 1, 2, ..."),
      required(quantity_row(points + ".arc_length", fills(&Point::at), "Unstressed length along the line " + from + ".",
                            kLength, kNotNegative)),
      quantity_row(points + ".weight_in_air",
                   with_default(taken_by<Point>([](Point& point, const FieldValue& weight) {
                                  point.mass = weight.number / kGravity;
                                }),
                                0.0),
                   "Weight in air.", kForce, kNotNegative),
      quantity_row(points + ".buoyancy", with_default(fills(&Point::net_force), 0.0),
                   "Weight of the water that it displaces when submerged.", kForce, kNotNegative),
      quantity_row(points + ".drag_area", defaults(&Point::drag_area), "Drag coefficient times area.", kArea,
                   kNotNegative),
  };
}

template std::vector<Field> point_rows<FreeLineDescription>(const std::string& p, const std::string& from);
template std::vector<Field> point_rows<PipeDescription>(const std::string& p, const std::string& from);
template std::vector<Field> line_body_rows<MooringLineDescription>(const std::string& p);
template std::vector<Field> line_body_rows<FreeLineDescription>(const std::string& p);

}  // namespace overbend::field_rows
