#include "report/page/static_value.h"

#include "report/page/history_name.h"
#include "results/fields/static_scalars.h"

namespace overbend {
namespace {

/// Finds the number with a given name.
struct NamedNumber {
  std::string name;
  std::optional<double> found;

  void operator()(const ResultField& field, double value) {
    if (field.name == name) found = value;
  }
  void operator()(const ResultField& field, const std::optional<double>& value) {
    if (field.name == name) found = value;
  }
  template <class Other>
  void operator()(const ResultField&, const Other&) {}
};

std::optional<double> of_region(const RegionResult& region, const std::string& region_name, const std::string& name) {
  std::optional<double> found;
  visit_region(region, [&](const ResultField& field, const Extreme& extreme) {
    if (name == region_name + "_" + field.name) found = extreme.value;
  });
  return found;
}

std::optional<double> of_support(const DynamicResults& results, const std::string& name) {
  for (const SupportDynamics& box : results.supports) {
    if (name == "support/" + box.name + "/reaction") return box.static_reaction;
    if (name == "support/" + box.name + "/separation") return box.static_separation;
  }
  return std::nullopt;
}

std::optional<double> of_line_end(const StaticResults& statics, const std::string& name) {
  for (const LineResult& line : statics.lines) {
    if (name == "line/" + line.name + "/first_tension") return line.first.tension;
    if (name == "line/" + line.name + "/second_tension") return line.second.tension;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> static_value(const StaticResults& statics, const DynamicResults& results,
                                   const std::string& name) {
  if (const std::optional<double> value = of_line_end(statics, name)) return value;
  if (!statics.has_pipe()) return std::nullopt;
  NamedNumber of_line{history_quantity(name), {}};
  visit_lay(statics, of_line);
  if (of_line.found) return of_line.found;
  if (of_line.name == min_effective_tension_field().name) return statics.min_effective_tension.value;
  if (statics.overbend) {
    if (const auto value = of_region(*statics.overbend, "overbend", of_line.name)) return value;
  }
  if (statics.tower) {
    if (const auto value = of_region(*statics.tower, "tower", of_line.name)) return value;
  }
  if (const auto value = of_region(statics.sagbend, "sagbend", of_line.name)) return value;
  return of_support(results, name);
}

}  // namespace overbend
