#include "base/constants.h"
#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {
namespace {

template <double StingerPoint::*Coordinate>
Member of_first() {
  return taken_by<BoxRowDescription>(
      [](BoxRowDescription& row, const FieldValue& value) { row.first.*Coordinate = value.number; });
}

}  // namespace

std::vector<Field> box_row(const std::string& path, const Member& open, bool continues) {
  Field first = group_row(
      path + ".first",
      opened_by<BoxRowDescription>([](BoxRowDescription& row, const FieldValue&) -> BoxRowDescription& { return row; }),
      "The first box of the row.");
  if (continues) {
    first = otherwise(std::move(first), "continues the curve of the ramp, one spacing behind its last box");
  } else {
    first = required(std::move(first));
  }
  return {
      group_row(path, open, "Roller boxes generated on an arc of `radius`: number, spacing and position of the first."),
      required(row_of_kind(FieldKind::integer, path + ".count", fills(&BoxRowDescription::count), "Number of boxes.",
                           {.low = 1.0, .high = 1000.0})),
      required(quantity_row(path + ".spacing", fills(&BoxRowDescription::spacing), "Arc length from box to box.",
                            kLength, {.low = 0.0, .high = 1000.0, .low_open = true})),
      quantity_row(path + ".length", defaults(&BoxRowDescription::length),
                   "Length of each box along the pipe; required with more than one row.", kLength,
                   {.low = 0.0, .high = 1000.0}),
      std::move(first),
      required(quantity_row(path + ".first.x", of_first<&StingerPoint::x>(),
                            "Point of the underside of the coated pipe at its middle, astern of the stern shoe.",
                            kLength)),
      required(quantity_row(path + ".first.z", of_first<&StingerPoint::z>(),
                            "Point of the underside of the coated pipe at its middle, above the stern shoe.", kLength)),
      otherwise(quantity_row(path + ".first.incline", fills(&BoxRowDescription::incline),
                             "Inclination of the arc there from horizontal, positive downwards astern.", kAngle,
                             {.low = -90.0 * kDegree, .high = 90.0 * kDegree, .low_open = true, .high_open = true}),
                continues ? "tangent of the ramp's curve at its last box" : "that of the pipe at the tensioner"),
  };
}

std::vector<Field> stinger_settings(const std::string& path, const Member& settings, const Member& setting) {
  const std::string s = path + ".settings";
  const Range angle = {.low = -90.0 * kDegree, .high = 90.0 * kDegree, .low_open = true, .high_open = true};
  const Member one_angle = taken_by<StingerSettingDescription>(
      [](StingerSettingDescription& owner, const FieldValue& value) { owner.angles = {value.number}; });
  return {
      list_row(s, settings, "Named settings of the angles of the stinger's sections, of which `setting` selects one.",
               "none"),
      group_row(s + "[]", appends<StingerSettingDescription>(), "One setting."),
      required(row_of_kind(FieldKind::text, s + "[].name", fills(&StingerSettingDescription::name),
                           "Name to which `setting` refers; must be unique.")),
      otherwise(quantity_row(s + "[].angle", one_angle,
                             "Angle of a single section, positive when the tip goes down from where it is drawn.",
                             kAngle, angle),
                "given by angles"),
      list_row(s + "[].angles", enters(&StingerSettingDescription::angles),
               "Angle of each section about its own hinge, from the barge astern.", "given by angle"),
      quantity_row(s + "[].angles[]", appends_value<double>(), "Angle of one section.", kAngle, angle),
      otherwise(row_of_kind(FieldKind::text, path + ".setting", setting, "Name of the selected setting."),
                "the sections have angles of their own, or follow from equilibrium"),
  };
}

}  // namespace overbend::field_rows
