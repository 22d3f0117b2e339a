/// Short forms of frequent rows of the field table.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "modelfile/fields/field_rows.h"

namespace overbend::field_rows {

inline constexpr Range kPositive = {.low = 0.0, .low_open = true};
inline constexpr Range kNotNegative = {.low = 0.0};

/// Dimension with its display unit.
struct Shown {
  const char *unit, *show;
};
inline constexpr Shown kLength = {"m", "m"}, kForce = {"N", "kN"}, kMoment = {"N*m", "kN*m"}, kTime = {"s", "s"},
                       kAngle = {"rad", "deg"}, kMass = {"kg", "t"}, kArea = {"m^2", "m^2"}, kSpeed = {"m/s", "m/s"};

inline Field quantity_row(std::string path, Member member, std::string text, const Shown& shown, Range range = {}) {
  return {.path = std::move(path),
          .member = std::move(member),
          .kind = FieldKind::quantity,
          .text = std::move(text),
          .unit = shown.unit,
          .show = shown.show,
          .range = range};
}

inline Field row_of_kind(FieldKind kind, std::string path, Member member, std::string text, Range range = {}) {
  return {.path = std::move(path), .member = std::move(member), .kind = kind, .text = std::move(text), .range = range};
}

inline Field group_row(std::string path, Member member, std::string text) {
  return row_of_kind(FieldKind::map, std::move(path), std::move(member), std::move(text));
}

inline Field list_row(std::string path, Member member, std::string text, std::string otherwise) {
  Field row = row_of_kind(FieldKind::list, std::move(path), std::move(member), std::move(text));
  row.fallback_text = std::move(otherwise);
  return row;
}

inline Field required(Field row) {
  row.required = true;
  return row;
}

/// Row of a list with a minimum number of items.
inline Field at_least(int entries, Field row) {
  row.min_items = entries;
  return row;
}

/// Row with the meaning of a missing key.
inline Field otherwise(Field row, std::string text) {
  row.fallback_text = std::move(text);
  return row;
}

/// Member of a vector component.
inline Member component(int i) {
  return taken_by<Vec3>([i](Vec3& vector, const FieldValue& value) { vector[i] = value.number; });
}

/// Vector as a group of x, y and z: `group` is its own row, whose member opens a Vec3.
struct VectorRows {
  Field group;
  Shown shown;
  std::vector<std::string> texts;  ///< Descriptions of x, y and z.
  bool all = true;                 ///< True: all components are required; false: the default is 0.
};

inline std::vector<Field> vector_rows(const VectorRows& vector) {
  constexpr const char* kKeys[] = {".x", ".y", ".z"};
  std::vector<Field> rows = {vector.group};
  for (int i = 0; i < static_cast<int>(vector.texts.size()); ++i) {
    const Member member = vector.all ? component(i) : with_default(component(i), 0.0);
    rows.push_back(quantity_row(vector.group.path + kKeys[i], member, vector.texts[i], vector.shown));
    rows.back().required = vector.all;
  }
  return rows;
}

/// Descriptions of the coordinates in the vessel frame V, and in the world frame W.
inline std::vector<std::string> vessel_axis_texts() {
  return {"From midship, forward positive.", "From the centreline, positive to port.", "Above the water line."};
}
inline std::vector<std::string> world_axis_texts() {
  return {"To the east, from below midship of the vessel in its position.", "To the north.",
          "Above the mean water level."};
}

}  // namespace overbend::field_rows
