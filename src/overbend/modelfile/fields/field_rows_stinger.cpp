#include "modelfile/fields/field_rows_stinger.h"

namespace overbend::field_rows {
namespace {

using Section = StingerSectionDescription;
using Body = StingerBodyDescription;
using Tank = StingerTankDescription;
using Spring = StingerSpringDescription;

constexpr double kRightAngle = std::numbers::pi / 2.0;

/// Section whose keys are read; the first key of a single section creates it.
Section& find_section(StructureKeys& keys) {
  std::vector<Section>& sections = keys.supports->sections;
  if (keys.section < 0) {
    keys.section = static_cast<int>(sections.size());
    sections.emplace_back();
  }
  return sections[static_cast<std::size_t>(keys.section)];
}

StructureKeys add_section(StructureKeys& stinger, const FieldValue&) {
  StructureKeys keys = stinger;
  keys.section = -1;
  Section& section = find_section(keys);
  section.name = "section " + std::to_string(keys.section + 1);
  return keys;
}

/// Row of a section's member under a group that belongs to the structure.
Member of_section(const Member& row) {
  Member outer = row;
  outer.owner = typeid(StructureKeys);
  outer.put = [put = row.put](Target& owner, const FieldValue& value) {
    Target section = &find_section(object<StructureKeys>(owner));
    return put(section, value);
  };
  return outer;
}

/// Point in the plane of the stinger, with both coordinates required.
std::vector<Field> point_rows(const Field& group, const std::string& place_text) {
  return {group,
          required(quantity_row(group.path + ".x", fills(&StingerPoint::x), place_text + ", astern of the stern shoe.",
                                kLength)),
          required(quantity_row(group.path + ".z", fills(&StingerPoint::z), place_text + ", above the stern shoe.",
                                kLength))};
}

std::vector<Field> body_rows(const std::string& p) {
  std::vector<Field> rows = {
      otherwise(group_row(p, of_section(enters(&Section::body)),
                          "Weight and constant buoyancy of the section, without its tanks: forces at points fixed in "
                          "it, as drawn. With body or tanks the section turns until the moments about its hinge "
                          "balance."),
                "no weight in addition to the tanks"),
      required(quantity_row(p + ".weight", fills(&Body::weight), "Weight in air.", kForce, kNotNegative))};
  append(rows, point_rows(required(group_row(p + ".at", enters(&Body::at), "Point of application of the weight.")),
                          "Point of application of the weight"));
  append(rows, {quantity_row(p + ".buoyancy", defaults(&Body::buoyancy),
                             "Buoyancy of the permanently submerged parts; constant.", kForce, kNotNegative)});
  append(rows, point_rows(otherwise(group_row(p + ".buoyancy_at", enters(&Body::buoyancy_at),
                                              "Point of application of the buoyancy."),
                                    "where the weight acts"),
                          "Point of application of the buoyancy"));
  append(rows,
         {otherwise(quantity_row(p + ".radius_of_gyration", fills(&Body::radius_of_gyration),
                                 "Radius of gyration of its mass about the point of application of the weight.",
                                 kLength, kPositive),
                    "that of a uniform rod from the hinge to the last box"),
          quantity_row(p + ".added_mass", defaults(&Body::added_mass),
                       "Added mass of the water that moves with it, at buoyancy_at.", kMass, kNotNegative),
          quantity_row(p + ".drag_area", defaults(&Body::drag_area),
                       "Drag coefficient times area for motion across it, at buoyancy_at.", kArea, kNotNegative)});
  return rows;
}

std::vector<Field> tank_rows(const std::string& p) {
  const std::string t = p + "[]";
  std::vector<Field> rows = {
      list_row(p, of_section(enters(&Section::tanks)),
               "Cylindrical buoyancy tanks, in addition to or in place of the buoyancy of the body. Buoyancy acts on "
               "the part of the axis below the water.",
               "none"),
      group_row(t, appends_named<Tank>("tank"), "One tank."),
      otherwise(row_of_kind(FieldKind::text, t + ".name", fills(&Tank::name), "Name in the results; must be unique."),
                "tank 1, 2, ...")};
  append(rows, point_rows(required(group_row(t + ".from", enters(&Tank::from), "One end of its axis, as drawn.")),
                          "One end"));
  append(rows, point_rows(required(group_row(t + ".to", enters(&Tank::to), "The other end of its axis, as drawn.")),
                          "The other end"));
  append(rows, {quantity_row(t + ".y", defaults(&Tank::y), "Transverse position of the axis, positive to starboard.",
                             kLength),
                required(quantity_row(t + ".diameter", fills(&Tank::diameter), "Outside diameter.", kLength,
                                      {.low = 0.0, .high = 50.0, .low_open = true})),
                quantity_row(t + ".weight", defaults(&Tank::weight), "Weight of the empty tank; acts at mid-length.",
                             kForce, kNotNegative),
                row_of_kind(FieldKind::number, t + ".ballast", defaults(&Tank::ballast),
                            "Fraction of its volume that is flooded; the water's weight acts at mid-length.",
                            {.low = 0.0, .high = 1.0}),
                row_of_kind(FieldKind::number, t + ".drag", defaults(&Tank::drag), "Drag coefficient across the axis.",
                            {.low = 0.0, .high = 10.0}),
                row_of_kind(FieldKind::number, t + ".added_mass", defaults(&Tank::added_mass),
                            "Added mass coefficient across the axis.", {.low = 0.0, .high = 10.0})});
  return rows;
}

/// Both stops, in a list of two.
struct LimitsTarget {
  StingerLimits* limits = nullptr;
  int taken = 0;
};

std::vector<Field> limit_rows(const std::string& p) {
  const auto open = [](Section& section, const FieldValue&) { return LimitsTarget{&section.limits.emplace()}; };
  const auto take = [](LimitsTarget& target, const FieldValue& value) {
    (target.taken++ == 0 ? target.limits->up : target.limits->down) = value.number;
  };
  Field list = list_row(p, of_section(opened_by<Section>(open)),
                        "Stops: minimum and maximum angle from where it is drawn, positive when the tip goes down. A "
                        "stop carries the moment that remains.",
                        "no stops");
  list.min_items = list.max_items = 2;
  return {list, quantity_row(p + "[]", taken_by<LimitsTarget>(take), "Minimum angle, then the maximum.", kAngle,
                             {.low = -kRightAngle, .high = kRightAngle})};
}

std::vector<Field> spring_rows(const std::string& p) {
  const std::string s = p + "[]";
  const auto kind = [](Spring& spring, const FieldValue& word) { spring.wire = word.text == "wire"; };
  Field type = row_of_kind(FieldKind::choice, s + ".type", with_default(taken_by<Spring>(kind), std::string("wire")),
                           "wire: pulls only; strut: pulls and pushes.");
  type.choices = {"wire", "strut"};
  std::vector<Field> rows = {
      list_row(p, of_section(enters(&Section::springs)),
               "Wires of a tower, or struts, between the vessel and the section.", "none"),
      group_row(s, appends_named<Spring>("spring"), "One wire or strut."),
      otherwise(row_of_kind(FieldKind::text, s + ".name", fills(&Spring::name), "Name in messages."),
                "spring 1, 2, ...")};
  append(rows, point_rows(required(group_row(s + ".on_barge", enters(&Spring::on_barge), "Its end on the vessel.")),
                          "End on the vessel"));
  append(rows, point_rows(required(group_row(s + ".on_stinger", enters(&Spring::on_stinger),
                                             "Its end on the section, as drawn.")),
                          "End on the section"));
  append(rows,
         {required(quantity_row(s + ".stiffness", fills(&Spring::stiffness), "Force per elongation.", {"N/m", "kN/m"},
                                kPositive)),
          quantity_row(s + ".pretension", defaults(&Spring::pretension), "Tension in it as drawn.", kForce), type});
  return rows;
}

}  // namespace

std::vector<Field> stinger_section_rows(const std::string& path) {
  const bool listed = path.ends_with("[]");
  Field hinge = group_row(path + ".hinge", of_section(enters(&Section::hinge)),
                          "Hinge about which the boxes below rotate as one body: on the vessel, for further sections "
                          "on the section before.");
  std::vector<Field> rows = point_rows(listed ? required(hinge) : otherwise(hinge, "the stinger is fixed"), "Hinge");
  append(rows, {otherwise(quantity_row(path + ".angle", of_section(fills(&Section::angle)),
                                       "Prescribed angle of the section, from where it is drawn and from the section "
                                       "before; positive when the tip goes down.",
                                       kAngle, {.low = -kRightAngle, .high = kRightAngle}),
                          "follows from equilibrium with body or tanks; otherwise 0 deg")});
  append(rows, body_rows(path + ".body"));
  append(rows, tank_rows(path + ".tanks"));
  append(rows, limit_rows(path + ".limits"));
  append(rows,
         {quantity_row(path + ".stop_stiffness", of_section(defaults(&Section::stop_stiffness)),
                       "Stiffness of the stops in a dynamic analysis, moment per angle.", {"N*m/rad", "kN*m/rad"},
                       kPositive),
          quantity_row(path + ".hinge_friction", of_section(defaults(&Section::hinge_friction)),
                       "Friction moment that the hinge resists before the section rotates.", kMoment, kNotNegative)});
  append(rows, spring_rows(path + ".springs"));
  return rows;
}

std::vector<Field> stinger_section_list() {
  const std::string p = "supports.stinger.sections";
  const std::string s = p + "[]";
  const auto open = [](StructureKeys& stinger, const FieldValue&) -> StructureKeys& { return stinger; };
  Field list = list_row(p, opened_by<StructureKeys>(open),
                        "Sections of an articulated stinger in order from the vessel astern, each on a hinge of its "
                        "own, in place of hinge, body, tanks and boxes of the stinger.",
                        "one section, or a fixed stinger");
  list.min_items = 1;
  std::vector<Field> rows = {list, group_row(s, opened_by<StructureKeys>(add_section), "One section."),
                             otherwise(row_of_kind(FieldKind::text, s + ".name", of_section(fills(&Section::name)),
                                                   "Name in the results; must be unique."),
                                       "section 1, 2, ...")};
  append(rows, stinger_section_rows(s));
  return rows;
}

}  // namespace overbend::field_rows
