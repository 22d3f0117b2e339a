/// Writes results as JSON while their fields are visited; see results/fields/result_field.h.
///
/// A style selects the JSON text and the form of values: SummaryStyle here, those of page and report in their rooms,
/// and one that writes the types instead of the values (serve/answers/type_style.h).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/assumption.h"
#include "base/finding.h"
#include "base/json.h"
#include "results/dynamic_results.h"
#include "results/fields/result_field.h"

namespace overbend {

/// Base of the styles that write values.
template <Output kWhere>
struct ValueStyle {
  static constexpr Output kOutput = kWhere;
  static constexpr bool kTypes = false;  ///< True for a style that writes types.
  static constexpr bool kWhole = false;  ///< True for a style that writes one of everything that may exist.

  Json text(const std::string& value) const { return value; }
  Json texts(const std::vector<std::string>& values) const { return values; }
  Json findings(const Findings& values) const { return findings_json(values); }
  Json flag(bool value) const { return value; }
  template <class Integer>
  Json count(Integer value) const {
    return value;
  }
  template <HasResultEnumNames Enum>
  Json word(Enum value) const {
    return overbend::word(value);
  }
  /// An object of a named kind.
  Json named(const char*, Json members) const { return members; }
  /// A value that may be missing: null.
  template <class Make>
  Json maybe(bool present, Make make) const {
    return present ? Json(make()) : Json(nullptr);
  }
  template <class Row, class Make>
  Json rows(const std::vector<Row>& rows, Make make_json) const {
    Json list = Json::array();
    for (const Row& row : rows) list.push_back(make_json(row));
    return list;
  }
};

/// Style of summary.json: every digit.
struct SummaryStyle : ValueStyle<Output::summary> {
  Json number(double value) const { return value; }
  double along(double s) const { return s; }
  Vec3 moved(const ResultField&, const Vec3& vector) const { return vector; }
  Json vector(const Vec3& v) const { return {{"x", v.x()}, {"y", v.y()}, {"z", v.z()}}; }
};

/// Writes visited fields into an object, each under its key.
template <class Style>
class JsonWriter {
 public:
  explicit JsonWriter(Style style = {}) : style_(std::move(style)) {}

  void operator()(const ResultField& f, double value) {
    put(f, [&] { return number_json(f, f.from_anchor ? style_.along(value) : value); });
  }
  void operator()(const ResultField& f, const std::optional<double>& value) {
    put(f, [&] { return style_.maybe(value.has_value(), [&] { return number_json(f, value.value_or(0.0)); }); });
  }
  void operator()(const ResultField& f, bool value) {
    put(f, [&] { return style_.flag(value); });
  }
  void operator()(const ResultField& f, int value) {
    put(f, [&] { return style_.count(value); });
  }
  void operator()(const ResultField& f, std::int64_t value) {
    put(f, [&] { return style_.count(value); });
  }
  void operator()(const ResultField& f, std::uint64_t value) {
    put(f, [&] { return style_.count(value); });
  }
  void operator()(const ResultField& f, const std::string& value) {
    put(f, [&] { return style_.text(value); });
  }
  void operator()(const ResultField& f, const std::vector<std::string>& values) {
    put(f, [&] { return style_.texts(values); });
  }
  /// Writes the texts; in summary.json also the names of their ranks.
  void operator()(const ResultField& f, const Assumptions& values) {
    if (Style::kOutput == Output::summary) slot(kAssumptionRanks) = style_.texts(rank_names(values));
    put(f, [&] { return style_.texts(texts(values)); });
  }
  /// Writes the findings; in summary.json also their messages under "warnings", for scripts.
  void operator()(const ResultField& f, const Findings& values) {
    if (Style::kOutput == Output::summary) slot("warnings") = style_.texts(messages(values));
    put(f, [&] { return style_.findings(values); });
  }
  template <HasResultEnumNames Enum>
  void operator()(const ResultField& f, Enum value) {
    put(f, [&] { return style_.word(value); });
  }
  void operator()(const ResultField& f, const Vec3& value) {
    const std::optional<std::string_view> key = f.key(Style::kOutput);
    if (!key) return;
    const Vec3 moved = style_.moved(f, value);
    if (!key->ends_with(kComponents)) {
      slot(*key) = vector_json(f, moved);
      return;
    }
    const std::string before = *key == kComponents ? "" : std::string(*key);
    for (int axis = 0; axis < 3; ++axis) slot(before + "xyz"[axis]) = number_json(f, moved(axis));
  }
  void operator()(const ResultField& f, const Mat3& columns) {
    put(f, [&] {
      Json list = Json::array();
      for (int i = 0; i < 3; ++i) list.push_back(style_.vector(style_.moved(f, columns.col(i))));
      return list;
    });
  }
  void spread(const ResultField& f, const SummaryStatistics& s) {
    const std::optional<std::string_view> key = f.key(Style::kOutput);
    if (!key) return;
    const std::size_t star = key->find('*');
    if (star == std::string_view::npos) {
      slot(*key) = spread_json(s);
      return;
    }
    const std::string before(key->substr(0, star)), behind(key->substr(star + 1));
    for (const auto& [part, value] : parts(s)) {
      std::string name = before;
      name.append(part).append(behind);
      slot(name) = style_.number(value);
    }
  }

  /// Members that exist only if `present`.
  template <class Visit>
  void part(bool present, Visit visit_members) {
    if constexpr (Style::kTypes) {
      JsonWriter members(style_);
      visit_members(members);
      for (const auto& [key, type] : members.object_.items()) object_[key + "?"] = type;
    } else if (present || kUnits) {
      visit_members(*this);
    }
  }
  /// Sets a member to null unless `present`.
  void or_null(std::string_view key, bool present) {
    Json value = slot(key);
    slot(key) = style_.maybe(present, [&] { return value; });
  }
  /// Access to members without a field, derived from other results.
  Json& operator[](std::string_view key) { return slot(key); }
  const Style& style() const { return style_; }
  Json take() { return std::move(object_); }

 private:
  /// True for a style that writes units instead of values (resultfiles/summary/result_units.cpp).
  static constexpr bool kUnits = requires(const Style& style, const ResultField& field) { style.unit(field); };

  Json number_json(const ResultField& f, double value) const {
    if constexpr (kUnits) {
      return style_.unit(f);
    } else {
      return style_.number(value);
    }
  }
  Json vector_json(const ResultField& f, const Vec3& value) const {
    if constexpr (kUnits) {
      const Json unit = style_.unit(f);
      return {{"x", unit}, {"y", unit}, {"z", unit}};
    } else {
      return style_.vector(value);
    }
  }
  static std::array<std::pair<const char*, double>, 4> parts(const SummaryStatistics& s) {
    return {{{"min", s.min}, {"max", s.max}, {"mean", s.mean}, {"std", s.std}}};
  }
  Json spread_json(const SummaryStatistics& s) const {
    Json json = Json::object();
    for (const auto& [part, value] : parts(s)) json[part] = style_.number(value);
    return style_.named("Spread", std::move(json));
  }
  template <class Make>
  void put(const ResultField& f, Make make) {
    if (const std::optional<std::string_view> key = f.key(Style::kOutput)) slot(*key) = make();
  }
  Json& slot(std::string_view key) {
    Json* node = &object_;
    for (std::size_t end = key.find('/'); end != std::string_view::npos; end = key.find('/')) {
      node = &(*node)[std::string(key.substr(0, end))];
      key.remove_prefix(end + 1);
    }
    return (*node)[std::string(key)];
  }

  Style style_;
  Json object_ = Json::object();
};

/// Collects the members of rows in lists: {name: [values]}.
template <class Style>
class JsonLists {
 public:
  /// `wanted`: names of the lists; all if null. Arc lengths and positions are always included.
  explicit JsonLists(Style style = {}, const std::vector<std::string>* wanted = nullptr)
      : style_(std::move(style)), wanted_(wanted) {}

  void operator()(const ResultField& f, double value) {
    const std::optional<std::string_view> key = f.key(Style::kOutput);
    if (key && (f.from_anchor || is_wanted(*key))) {
      add(*key, style_.number(f.from_anchor ? style_.along(value) : value));
    }
  }
  void operator()(const ResultField& f, const Vec3& value) {
    if (f.key(Style::kOutput) != kComponents) return;
    const Vec3 moved = style_.moved(f, value);
    for (int axis = 0; axis < 3; ++axis) add(std::string_view("xyz").substr(axis, 1), style_.number(moved(axis)));
  }
  template <class Other>
  void operator()(const ResultField&, const Other&) {}

  void end_row() { next_ = 0; }
  Json take() {
    Json object = Json::object();
    for (Column& column : columns_) object[column.key] = std::move(column.values);
    return object;
  }

 private:
  struct Column {
    std::string key;
    Json values = Json::array();
  };
  bool is_wanted(std::string_view key) const {
    return wanted_ == nullptr || std::find(wanted_->begin(), wanted_->end(), key) != wanted_->end();
  }
  void add(std::string_view key, Json value) {  // every row has the same members in the same order
    if (next_ == columns_.size()) columns_.push_back({std::string(key)});
    columns_[next_++].values.push_back(std::move(value));
  }

  Style style_;
  const std::vector<std::string>* wanted_;
  std::size_t next_ = 0;
  std::vector<Column> columns_;
};

}  // namespace overbend
