/// Key of the model file: the only definition of its meaning and its target. The reader, the description, `overbend
/// schema`, the reference page and forms are all generated from the table of these (modelfile/fields/field_table.h).
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "modelfile/schema/member.h"

namespace overbend {

enum class FieldKind { map, list, quantity, number, integer, text, choice };

template <>
inline constexpr std::array kEnumNames<FieldKind> = {
    Word{FieldKind::map, "map"},       Word{FieldKind::list, "list"},       Word{FieldKind::quantity, "quantity"},
    Word{FieldKind::number, "number"}, Word{FieldKind::integer, "integer"}, Word{FieldKind::text, "text"},
    Word{FieldKind::choice, "choice"},
};

/// Bounds of a number; quantities in SI.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;  ///< True if the bound itself is excluded.

  bool contains(double value) const {
    return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
  }
};

/// Max. number of items of a list and keys of a map; limits the effort for invalid files.
inline constexpr int kMaxItems = 10000;

/// Row of the table. Paths read `pipe.coatings[].thickness` (an item of a list) and `rollers.*.bottom` (any name).
///
/// A key may have two rows of different shape, such as `vessel.motion` as a word or as a map; the value in the file
/// selects one.
struct Field {
  std::string path;
  Member member = {};  ///< Member of the description that the value fills.
  FieldKind kind = FieldKind::map;
  bool file = false;      ///< True if the text names a file, relative to the model file.
  std::string text = {};  ///< One-line description for the user.
  std::string unit = {};  ///< SI unit of the dimension, for a quantity or a choice that may be one.
  std::string show = {};  ///< Display unit.
  bool required = false;
  std::string fallback = {};       ///< Default as it would be written, from the member; empty = none.
  std::string fallback_text = {};  ///< Meaning of a missing value without a fixed default.
  Range range = {};
  Range usual = {};                          ///< Values outside are accepted with a warning: mostly wrong units.
  std::vector<std::string> choices = {};     ///< If empty: the texts of the member's enumeration.
  int min_items = 0, max_items = kMaxItems;  ///< Number of items of a list or keys of a map.
};

/// Fills in the properties that follow from the member: the default, written as a user would, and the choices.
void complete_from_member(Field& field);

/// Returns the range in the field's own unit, "> 0 mm", "0 to 1"; empty when unbounded.
std::string field_range_label(const Field& field, const Range& range);

/// Returns a description of valid values, "a length in mm", "one of none, airy, ...".
std::string field_kind_label(const Field& field);

/// Returns the maximum magnitude [SI] accepted for a dimension in any field: a larger value is an input error.
double max_sensible_value(const std::string& si_unit);

}  // namespace overbend
