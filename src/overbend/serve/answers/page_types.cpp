#include <fmt/format.h>

#include <algorithm>

#include "serve/answers/page_fields.h"
#include "serve/answers/page_operation.h"
#include "serve/answers/type_style.h"

namespace overbend {
namespace {

using Type = Json;

constexpr const char* kHead =
    "// Types of the results sent by the program, and the units they are shown in. Generated from the program's table "
    "of\n"
    "// quantities: do not edit, run `overbend schema --types > web/src/api/results.ts`. SI units, frame W.\n"
    "\n"
    "export type Vector = [number, number, number];\n";

/// Returns results in which every optional part is present.
StaticResults example_statics() {
  StaticResults r;
  r.stations.resize(1);
  r.checks.along.governing.resize(1);
  r.supports.resize(1);
  r.supports[0].has_sides = true;
  r.last_support = "stinger 1";
  r.stinger_tip_clearance = 0.0;
  r.ramp_fitted_radius = r.stinger_fitted_radius = 0.0;
  r.moorings.emplace();
  return r;
}

std::string unit_text(const ShownUnit& unit) {
  return fmt::format("{{ unit: '{}', factor: {}, digits: {}, more: {} }}", unit.name.empty() ? "–" : unit.name,
                     unit.factor, unit.digits, unit.more);
}

/// Rows of the table `quantities`: quantities along the pipe with their usual names and units.
struct QuantityRows {
  std::string text;

  void over_time(const ResultField& f, const Envelope&, const std::vector<double>&) {
    if (f.key(Output::page)) add(std::string(*f.key(Output::page)), quantity_label(f), std::string(f.units));
  }
  template <class Other>
  void operator()(const ResultField&, const Other&) {}
  void spread(const ResultField&, const Envelope&) {}
  void add(const std::string& key, const std::string& name, const std::string& si) {
    const auto in = [&](UnitSystem system) { return unit_text(shown_unit(key, si, system)); };
    text += fmt::format("  {{ key: '{}', name: '{}', metric: {}, us: {} }},\n", key, name, in(UnitSystem::metric),
                        in(UnitSystem::us));
  }

 private:
  /// Returns the heading, with "effective" for the tension.
  static std::string quantity_label(const ResultField& f) {
    std::string name(f.name == "effective_tension" ? "effective tension" : f.heading);
    if (!name.starts_with("von Mises")) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return name;
  }
};

std::string quantity_table() {
  QuantityRows rows;
  const DynamicResults example;
  visit_dynamic_stations(example, rows);
  rows.add("utilisation", "von Mises stress / yield stress", "1");
  rows.add("checks", "Utilisation of code checks", "1");
  return "/** Quantities along the pipe: key in the lists, name, and how SI values are shown. */\n"
         "export const quantities = [\n" +
         rows.text + "] as const;\n";
}

std::string unit_table(const char* system, std::span<const ShownUnit> units) {
  std::string text = fmt::format("  {}: {{\n", system);
  for (const ShownUnit& unit : units) text += fmt::format("    '{}': {},\n", unit.si, unit_text(unit));
  return text + "  },\n";
}

std::string unit_tables() {
  return "/** Unit in which values are shown: value times `factor`, with `digits` decimals, `more` than for metric "
         "units. */\n"
         "export interface ShownUnit { unit: string; factor: number; digits: number; more: number }\n\n"
         "/** By system and SI unit. */\n"
         "export const shownUnits: Record<'metric' | 'us', Record<string, ShownUnit>> = {\n" +
         unit_table("metric", shown_units(UnitSystem::metric)) + unit_table("us", shown_units(UnitSystem::us)) + "};\n";
}

std::string member(const std::string& key, const Type& type) {
  return "  " + key + ": " + type_text(type) + ";\n";
}

std::string interface_text(const std::string& name, const Type& members) {
  std::string text = "export interface " + name + " {\n";
  for (const auto& [key, type] : members.items()) text += member(key, type);
  return text + "}\n";
}

}  // namespace

std::string type_text(const Type& type) {
  if (type.is_string()) return type.get<std::string>();
  if (type.is_array()) {
    const std::string element = type.empty() ? "unknown" : type_text(type.front());
    return (element.find(" | ") == std::string::npos ? element : "(" + element + ")") + "[]";
  }
  std::string text = "{";
  for (const auto& [key, inner] : type.items()) text += " " + key + ": " + type_text(inner) + ";";
  return text + " }";
}

std::string page_types() {
  NamedTypes types;
  const StaticResults statics = example_statics();
  const TypeStyle<Output::page> page{&types};
  const TypeStyle<Output::summary> summary{&types};
  const DynamicResults dynamics;
  page.named("Statics", page_statics(page, statics, nullptr));
  page.named("Operation", page_operation(page, OperationResults{}, 0.0));
  page_envelopes(page, dynamics, true);
  page_impact(page, dynamics, Impact{});
  summary.named("DynamicSummary", dynamic_part(summary, statics, dynamics));
  std::string text = kHead;
  for (const auto& [name, members] : types) text += "\n" + interface_text(name, members);
  return text + "\n" + unit_tables() + "\n" + quantity_table();
}

}  // namespace overbend
