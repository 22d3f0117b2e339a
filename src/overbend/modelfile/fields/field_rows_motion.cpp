#include "modelfile/fields/field_rows.h"
#include "seafiles/rao_convention.h"

namespace overbend::field_rows {
namespace {

const std::string kPath = "vessel.motion.convention";

/// Component of a point.
Member component(int i) {
  return taken_by<Vec3>([i](Vec3& point, const FieldValue& value) { point[i] = value.number; });
}

Field length(const std::string& key, const Member& member, const std::string& text) {
  Field row;
  row.path = kPath + "." + key;
  row.member = member;
  row.kind = FieldKind::quantity;
  row.text = text;
  row.unit = row.show = "m";
  row.range = {.low = -1000.0, .high = 1000.0};
  return row;
}

Field group(const std::string& path, const Member& member, const std::string& text) {
  Field row;
  row.path = path;
  row.member = member;
  row.text = text;
  return row;
}

Field text_choice_row(const std::string& key, const Member& member, const std::string& text,
                      const std::vector<std::string>& choices, const std::string& otherwise) {
  Field row;
  row.path = kPath + "." + key;
  row.member = member;
  row.kind = FieldKind::choice;
  row.text = text;
  row.fallback_text = otherwise;
  row.choices = choices;
  return row;
}

Field name(const std::string& key, std::string RaoSettings::*member, const std::string& text) {
  Field row;
  row.path = kPath + "." + key;
  row.member = fills(member);
  row.kind = FieldKind::text;
  row.text = text;
  row.fallback_text = "the only one";
  return row;
}

Member point(std::optional<Vec3> RaoSettings::*member) {
  return opened_by<RaoSettings>(
      [member](RaoSettings& settings, const FieldValue&) -> Vec3& { return (settings.*member).emplace(Vec3::Zero()); });
}

Vec3& state_file_origin(RaoSettings& settings, const FieldValue&) {
  settings.file_origin_stated = true;
  return settings.file_origin;
}

/// Point of the vessel; without a height, a position in plan.
void add_point(std::vector<Field>& rows, const std::string& key, const Member& point, const std::string& text,
               bool with_height) {
  rows.push_back(group(kPath + "." + key, point, text));
  rows.push_back(length(key + ".x", component(0), "From midship, forward positive."));
  rows.back().required = true;
  rows.push_back(length(key + ".y", with_default(component(1), 0.0), "From the centreline, positive to port."));
  if (!with_height) return;
  rows.push_back(length(key + ".z", component(2), "Above the water."));
  rows.back().required = true;
}

}  // namespace

std::vector<Field> motion_convention() {
  std::vector<Field> rows;
  // Not part of the description; read by modelfile/reading/motion_files.h.
  rows.push_back(group(kPath, read_elsewhere(), "Conventions of the motion file."));
  rows.push_back(text_choice_row("set", fills(&RaoSettings::set),
                                 "Conventions of a program, used for all keys not given.", convention_sets(),
                                 "house for .csv, wamit for .4 and .out, aqwa for .LIS, orcaflex for .yml"));
  bool signs = false;
  for (const ConventionKey& key : convention_keys()) {
    if (!signs && key.key.rfind("positive.", 0) == 0) {
      rows.push_back(group(kPath + ".positive", {}, "Positive directions of the motions."));
      signs = true;
    }
    const Member word = taken_by<RaoSettings>(
        [name = key.key](RaoSettings& settings, const FieldValue& value) { settings.values[name] = value.text; });
    rows.push_back(
        text_choice_row(key.key, word, key.text, key.values, "as stated in the file, otherwise as in the set"));
  }
  add_point(rows, "reference", point(&RaoSettings::reference),
            "Point of the vessel whose motion is given, in the vessel's frame.", true);
  add_point(rows, "wave_origin", point(&RaoSettings::wave_origin),
            "Point at which the wave has the event to which phases refer.", false);
  add_point(rows, "file_origin", opened_by<RaoSettings>(state_file_origin),
            "Origin of the axes in which points in the file are given.", true);
  rows.push_back(length("length_scale", defaults(&RaoSettings::length_scale),
                        "ULEN of a WAMIT file: rotations are angle times this length per amplitude."));
  rows.back().range = {.low = 0.0, .high = 1000.0, .low_open = true};
  Field body;
  body.path = kPath + ".body";
  body.member = fills(&RaoSettings::body);
  body.kind = FieldKind::integer;
  body.text = "Number of the body in a file of several.";
  body.fallback_text = "the only one";
  body.range = {.low = 1.0, .high = 100.0};
  rows.push_back(body);
  rows.push_back(name("vessel_type", &RaoSettings::vessel_type, "Name, if an OrcaFlex file has several vessel types."));
  rows.push_back(name("draught", &RaoSettings::draught, "Name, if the vessel type has several draughts."));
  return rows;
}

}  // namespace overbend::field_rows
