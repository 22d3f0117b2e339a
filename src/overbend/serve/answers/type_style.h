/// Style that writes TypeScript types instead of values; see resultfiles/summary/json_fields.h.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/finding.h"
#include "resultfiles/summary/json_fields.h"

namespace overbend {

/// Named types in order of their first use.
using NamedTypes = std::vector<std::pair<std::string, Json>>;

/// Returns a type in TypeScript syntax. An object is given by the types of its members, a list by that of its first
/// element.
std::string type_text(const Json& type);

/// Visits also members that are missing or empty in the results at hand.
template <Output kWhere>
struct TypeStyle {
  static constexpr Output kOutput = kWhere;
  static constexpr bool kTypes = true;
  static constexpr bool kWhole = true;

  NamedTypes* types = nullptr;

  Json number(double) const { return "number"; }
  Json text(const std::string&) const { return "string"; }
  Json texts(const std::vector<std::string>&) const { return "string[]"; }
  Json findings(const Findings&) const {
    return type_text(named("Finding", {{"code", "string"},
                                       {"severity", "'serious' | 'caution' | 'note'"},
                                       {"message", "string"},
                                       {"object?", "string"},
                                       {"from_top?", "number"},
                                       {"time?", "number"},
                                       {"accepted?", "boolean"}})) +
           "[]";
  }
  Json flag(bool) const { return "boolean"; }
  template <class Integer>
  Json count(Integer) const {
    return "number";
  }
  template <HasResultEnumNames Enum>
  Json word(Enum) const {
    std::string all;
    for (const auto& [value, text] : ResultEnumNames<Enum>::list) {
      all.append(all.empty() ? "" : " | ").append("'").append(text).append("'");
    }
    return all;
  }
  Json vector(const Vec3& v) const {
    if (kWhere == Output::page) return "Vector";
    Json place = SummaryStyle{}.vector(v);
    for (Json& component : place) component = "number";
    return place;
  }
  double along(double s) const { return s; }
  Vec3 moved(const ResultField&, const Vec3& v) const { return v; }

  Json named(const char* name, Json members) const {
    for (const auto& [known, type] : *types) {
      if (known == name) return name;
    }
    types->emplace_back(name, std::move(members));
    return name;
  }
  template <class Make>
  Json maybe(bool, Make make) const {
    return type_text(make()) + " | null";
  }
  template <class Row, class Make>
  Json rows(const std::vector<Row>&, Make make_json) const {
    return Json::array({make_json(Row{})});
  }
};

/// Returns the text of web/src/api/results.ts: types of all results sent to the page, and the units they are shown in.
std::string page_types();

}  // namespace overbend
