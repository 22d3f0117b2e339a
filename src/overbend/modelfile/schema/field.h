/// One key of the model file: the single place that says what it means and what it fills. The reader, the description,
/// `overbend schema`, the reference page and forms are all made from the table of these
/// (modelfile/fields/field_table.h).
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "modelfile/schema/member.h"

namespace overbend {

enum class FieldKind { map, list, quantity, number, integer, text, choice };

template <>
inline constexpr std::array kWords<FieldKind> = {
    Word{FieldKind::map, "map"},       Word{FieldKind::list, "list"},       Word{FieldKind::quantity, "quantity"},
    Word{FieldKind::number, "number"}, Word{FieldKind::integer, "integer"}, Word{FieldKind::text, "text"},
    Word{FieldKind::choice, "choice"},
};

/// Bounds of a number; quantities in SI.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;  ///< The bound itself is outside.

  bool contains(double value) const {
    return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
  }
};

/// Items of a list, keys of a map: more are a mistake, and would keep whoever reads them busy.
inline constexpr int kMaxItems = 10000;

/// A row of the table. Paths read `pipe.coatings[].thickness` (an item of a list) and `rollers.*.bottom` (any name).
///
/// A key may have two rows of different shape, `vessel.motion` as a word or as a map: what stands in the file decides.
struct Field {
  std::string path;
  Member member = {};  ///< Of the description, that the value fills.
  FieldKind kind = FieldKind::map;
  bool file = false;      ///< A text that names a file, beside the model file where the path is not absolute.
  std::string text = {};  ///< One line for the user.
  std::string unit = {};  ///< Of a quantity, or of a choice that may be one instead: the SI unit of its dimension.
  std::string show = {};  ///< Unit to show it in.
  bool required = false;
  std::string fallback = {};       ///< Value when left out, as it would be written: the member's own; empty = none.
  std::string fallback_text = {};  ///< What being left out means when no fixed value stands for it.
  Range range = {};
  Range usual = {};                       ///< Outside is accepted with a warning: mostly a slip of units.
  std::vector<std::string> choices = {};  ///< Where not given: the words of the member's enumeration.
  int least = 0, most = kMaxItems;        ///< Items of a list, keys of a map.
};

/// Fills in what the member settles: the default, written as a user would, and the choices.
void complete_from_member(Field& field);

/// The range in the field's own unit, "> 0 mm", "0 to 1"; empty when unbounded.
std::string range_words(const Field& field, const Range& range);

/// What a value of this field looks like, "a length in mm", "one of none, airy, ...".
std::string kind_words(const Field& field);

/// Largest magnitude [SI] accepted for a dimension whatever the field: beyond it the value is a slip.
double largest_sensible(const std::string& si_unit);

}  // namespace overbend
