/// What a quantity of the results is: one description, from which every file, the page and the report are written.
///
/// The tables beside this file hand every member of a row with its ResultField to `visit`. A visitor writes, reads or
/// checks the members; rows may be const (writing) or not (reading). results.h5 holds every member; where else one
/// appears, and under which name, its line in the table says.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/shown_unit.h"
#include "results/result_words.h"

namespace overbend {

inline constexpr const char* kNoFrame = "none";
inline constexpr const char* kWorldFrame = "W: x east, y north, z up; origin midship at the mean water level";
inline constexpr const char* kBoxFrame =
    "box: longitudinal along the box axis astern, lateral to port, vertical is W z";
/// Units of a column whose rows have units of their own.
inline constexpr const char* kVaries = "see column units";
/// As the key of a vector: its components stand in the object itself, as x, y and z.
inline constexpr const char* kComponents = "/";

/// The JSON texts beside results.h5.
enum class Output {
  summary,  ///< summary.json
  page,     ///< What `overbend serve` answers.
  report,   ///< Data of the diagrams in report.html.
};

/// Units, description and frame outlive the field: they are literals, or belong to the caller's statement.
struct ResultField {
  std::string name;
  std::string_view units = "1";  ///< SI.
  std::string_view description = {};
  const char* frame = kNoFrame;

  std::string_view aspect = {};      ///< Behind the description, where the field is a part of another: ", largest".
  std::string_view heading = {};     ///< In tables of text, without the unit; empty: not there.
  std::string_view title = {};       ///< In tables for people, where it is not the heading.
  std::optional<int> decimals = {};  ///< In tables for people, of metric values; none: not there.
  bool in_si = false;                ///< Shown in SI in tables of text.
  bool from_anchor = false;          ///< An arc length from the anchor: page and report count from the tensioner.
  std::string_view place = {};       ///< Of an extreme: key in summary.json of where it is.
  std::array<std::optional<std::string_view>, 3> keys = {};  ///< By Output; empty: the name itself.

  /// Title of its column in tables for people: "Fairlead tension".
  std::string shown_title() const {
    std::string text(title.empty() ? heading : title);
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
  }

  /// Key in a JSON text, its levels parted by '/'; none where the field is not in it.
  std::optional<std::string_view> key(Output output) const {
    const std::optional<std::string_view>& own = keys[static_cast<std::size_t>(output)];
    return own && own->empty() ? std::string_view(name) : own;
  }

  ResultField csv(std::string_view text) && {
    heading = text;
    return std::move(*this);
  }
  /// `text`: the title there, where it is not the heading. Of words the decimals do not matter.
  ResultField shown(int digits, std::string_view text = {}) && {
    decimals = digits;
    title = text;
    return std::move(*this);
  }
  /// `alias`: the key where it is not the name. In that of a quantity over time `*` is min, max, mean and std.
  ResultField summary(std::string_view alias = {}) && { return std::move(*this).in(Output::summary, alias); }
  ResultField page(std::string_view alias = {}) && { return std::move(*this).in(Output::page, alias); }
  ResultField report(std::string_view alias = {}) && { return std::move(*this).in(Output::report, alias); }
  ResultField at(std::string_view key) && {
    place = key;
    return std::move(*this);
  }
  ResultField si() && {
    in_si = true;
    return std::move(*this);
  }
  ResultField along() && {
    from_anchor = true;
    return std::move(*this);
  }

 private:
  ResultField in(Output output, std::string_view alias) && {
    keys[static_cast<std::size_t>(output)] = alias;
    return std::move(*this);
  }
};

/// What people read the field in.
inline ShownUnit shown_unit(const ResultField& field) {
  if (field.units == kVaries) return {field.units, "", 1.0, 3};
  if (field.in_si) return {field.units, field.units == "1" ? "" : field.units, 1.0, 3};
  return shown_unit(field.name, field.units);
}

/// The name of one component of a vector: "normal_x"; a vector without a name gives "x".
inline std::string component_name(const ResultField& field, int axis) {
  const std::string letter(1, "xyz"[axis]);
  return field.name.empty() ? letter : field.name + "_" + letter;
}

/// The part of a quantity over time that is named `part`: "top_tension_min".
inline ResultField part_of(const ResultField& whole, const char* part, const char* aspect) {
  return {whole.name.empty() ? part : whole.name + "_" + part, whole.units, whole.description, whole.frame, aspect};
}

/// A quantity over time. Visitors with a member `spread` get it whole, the others its four values.
template <class SpreadType, class Visit>
void visit_spread(const ResultField& field, SpreadType& spread, Visit& visit) {
  if constexpr (requires { visit.spread(field, spread); }) {
    visit.spread(field, spread);
  } else {
    visit(part_of(field, "min", ", least"), spread.min);
    visit(part_of(field, "max", ", largest"), spread.max);
    visit(part_of(field, "mean", ", mean over time"), spread.mean);
    visit(part_of(field, "std", ", standard deviation over time"), spread.std);
  }
}

}  // namespace overbend
