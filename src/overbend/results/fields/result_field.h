/// Description of a quantity of the results: the single source for every file, the page and the report.
///
/// The tables in this folder pass every member of a row with its ResultField to `visit`. A visitor writes, reads or
/// checks the members; rows may be const (writing) or not (reading). results.h5 holds every member; the table states in
/// which other outputs a member appears, and under which name.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/shown_unit.h"
#include "results/result_enum_names.h"

namespace overbend {

inline constexpr const char* kNoFrame = "none";
inline constexpr const char* kWorldFrame = "W: x east, y north, z up; origin midship at the mean water level";
inline constexpr const char* kBoxFrame =
    "box: longitudinal along the box axis astern, lateral to port, vertical is W z";
/// Units of a column whose rows have different units.
inline constexpr const char* kVaries = "see column units";
/// Key of a vector whose components are written to the object itself, as x, y and z.
inline constexpr const char* kComponents = "/";

/// The JSON texts in addition to results.h5.
enum class Output {
  summary,  ///< summary.json
  page,     ///< Answers of `overbend serve`.
  report,   ///< Data of the diagrams in report.html.
};

/// Units, description and frame must outlive the field: they are literals, or belong to the caller's statement.
struct ResultField {
  std::string name;
  std::string_view units = "1";  ///< SI.
  std::string_view description = {};
  const char* frame = kNoFrame;

  std::string_view aspect = {};      ///< Suffix of the description if the field is a part of another: ", largest".
  std::string_view heading = {};     ///< Column heading in text tables, without the unit; empty: no column.
  std::string_view title = {};       ///< Column heading in tables for readers, if different from `heading`.
  std::optional<int> decimals = {};  ///< Decimals of metric values in tables for readers; none: no column.
  bool in_si = false;                ///< True if shown in SI in text tables.
  bool from_anchor = false;          ///< True for an arc length from the anchor: page and report count from the
                                     ///< tensioner.
  std::string_view place = {};       ///< Key in summary.json of the position of an extreme.
  std::array<std::optional<std::string_view>, 3> keys = {};  ///< By Output; empty: the name itself.

  /// Returns the title of the column in tables for readers: "Fairlead tension".
  std::string shown_title() const {
    std::string text(title.empty() ? heading : title);
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
  }

  /// Returns the key in a JSON text, its levels separated by '/'; none if the text does not contain the field.
  std::optional<std::string_view> key(Output output) const {
    const std::optional<std::string_view>& output_key = keys[static_cast<std::size_t>(output)];
    return output_key && output_key->empty() ? std::string_view(name) : output_key;
  }

  /// Sets the heading of the column in text tables.
  ResultField csv(std::string_view text) && {
    heading = text;
    return std::move(*this);
  }
  /// Sets decimals and title (`text`, if different from the heading) for tables for readers. The decimals of text
  /// columns are ignored.
  ResultField shown(int digits, std::string_view text = {}) && {
    decimals = digits;
    title = text;
    return std::move(*this);
  }
  /// `alias`: the key if different from the name. For a quantity over time `*` stands for min, max, mean and std.
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

/// Returns the unit in which the field is shown to readers.
inline ShownUnit shown_unit(const ResultField& field) {
  if (field.units == kVaries) return {field.units, "", 1.0, 3};
  if (field.in_si) return {field.units, field.units == "1" ? "" : field.units, 1.0, 3};
  return shown_unit(field.name, field.units);
}

/// Returns the name of one component of a vector: "normal_x"; "x" for a vector without a name.
inline std::string component_name(const ResultField& field, int axis) {
  const std::string letter(1, "xyz"[axis]);
  return field.name.empty() ? letter : field.name + "_" + letter;
}

/// Returns the part `part` of a quantity over time: "top_tension_min".
inline ResultField statistics_part(const ResultField& total, const char* part, const char* aspect) {
  return {total.name.empty() ? part : total.name + "_" + part, total.units, total.description, total.frame, aspect};
}

/// Visits a quantity over time. Visitors with a member `spread` receive the whole, others its four values.
template <class SpreadType, class Visit>
void visit_spread(const ResultField& field, SpreadType& spread, Visit& visit) {
  if constexpr (requires { visit.spread(field, spread); }) {
    visit.spread(field, spread);
  } else {
    visit(statistics_part(field, "min", ", minimum"), spread.min);
    visit(statistics_part(field, "max", ", maximum"), spread.max);
    visit(statistics_part(field, "mean", ", mean over time"), spread.mean);
    visit(statistics_part(field, "std", ", standard deviation over time"), spread.std);
  }
}

}  // namespace overbend
