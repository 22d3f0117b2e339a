#include "modelfile/field_rows.h"
#include "seafiles/rao_convention.h"

namespace overbend::field_rows {
namespace {

const std::string kPath = "vessel.motion.convention";

Field length(const std::string& key, const std::string& text) {
  Field row;
  row.path = kPath + "." + key;
  row.kind = FieldKind::quantity;
  row.text = text;
  row.unit = row.show = "m";
  row.range = {.low = -1000.0, .high = 1000.0};
  return row;
}

Field group(const std::string& path, const std::string& text) {
  Field row;
  row.path = path;
  row.text = text;
  return row;
}

Field words(const std::string& key, const std::string& text, const std::vector<std::string>& choices,
            const std::string& otherwise) {
  Field row;
  row.path = kPath + "." + key;
  row.kind = FieldKind::choice;
  row.text = text;
  row.fallback_text = otherwise;
  row.choices = choices;
  return row;
}

Field name(const std::string& key, const std::string& text) {
  Field row;
  row.path = kPath + "." + key;
  row.kind = FieldKind::text;
  row.text = text;
  row.fallback_text = "the only one";
  return row;
}

/// A point of the vessel; without height a place in plan.
void add_point(std::vector<Field>& rows, const std::string& key, const std::string& text, bool with_height) {
  rows.push_back(group(kPath + "." + key, text));
  rows.push_back(length(key + ".x", "From midship, forward positive."));
  rows.back().required = true;
  rows.push_back(length(key + ".y", "From the centreline, positive to port."));
  rows.back().fallback = "0 m";
  if (!with_height) return;
  rows.push_back(length(key + ".z", "Above the water."));
  rows.back().required = true;
}

}  // namespace

std::vector<Field> motion_convention() {
  std::vector<Field> rows;
  rows.push_back(group(kPath, "Conventions of the motion file."));
  rows.push_back(words("set", "Conventions of a program, used for all keys not given.", convention_sets(),
                       "house for .csv, wamit for .4, orcaflex for .yml"));
  bool signs = false;
  for (const ConventionKey& key : convention_keys()) {
    if (!signs && key.key.rfind("positive.", 0) == 0) {
      rows.push_back(group(kPath + ".positive", "Positive directions of the motions."));
      signs = true;
    }
    rows.push_back(words(key.key, key.text, key.words, "as stated in the file, otherwise as in the set"));
  }
  add_point(rows, "reference", "Point of the vessel whose motion is given, in the vessel's frame.", true);
  add_point(rows, "wave_origin", "Point at which the wave has the event that phases refer to.", false);
  add_point(rows, "file_origin", "Origin of the axes in which points in the file are given.", true);
  rows.push_back(length("length_scale", "ULEN of a WAMIT file: rotations are angle times this length per amplitude."));
  rows.back().fallback = "1 m";
  rows.back().range = {.low = 0.0, .high = 1000.0, .low_open = true};
  rows.push_back(name("vessel_type", "Name, if an OrcaFlex file has several vessel types."));
  rows.push_back(name("draught", "Name, if the vessel type has several draughts."));
  return rows;
}

}  // namespace overbend::field_rows
