#include "report/page/key_statistics.h"

#include "report/page/history_name.h"
#include "results/fields/dynamic_scalars.h"

namespace overbend {
namespace {

/// Finds the quantity over time with a given name.
struct NamedStatistics {
  std::string name;
  std::optional<SummaryStatistics> found;

  void spread(const ResultField& field, const SummaryStatistics& spread) {
    if (field.name == name) found = spread;
  }
  template <class Other>
  void operator()(const ResultField&, const Other&) {}
};

std::optional<SummaryStatistics> of_region(const DynamicRegion& region, const std::string& prefix,
                                           const std::string& name) {
  std::optional<SummaryStatistics> found;
  visit_dynamic_region(region, [&](const ResultField& field, const DynamicExtreme& extreme) {
    if (name == prefix + field.name) found = extreme.over_time;
  });
  return found;
}

}  // namespace

std::optional<SummaryStatistics> key_statistics(const DynamicResults& results, const std::string& name) {
  for (const LineDynamics& line : results.lines) {
    if (name == "line/" + line.name + "/first_tension") return line.first_tension;
    if (name == "line/" + line.name + "/second_tension") return line.second_tension;
  }
  NamedStatistics of_line{history_quantity(name), {}};
  visit_dynamic_keys(results, of_line, true);
  if (of_line.found) return of_line.found;
  if (const auto spread = of_region(results.overbend, "overbend_", of_line.name)) return spread;
  if (const auto spread = of_region(results.sagbend, "sagbend_", of_line.name)) return spread;
  for (const SupportDynamics& box : results.supports) {
    if (name == "support/" + box.name + "/reaction") return box.reaction;
    if (name == "support/" + box.name + "/separation") return box.separation;
  }
  return std::nullopt;
}

}  // namespace overbend
