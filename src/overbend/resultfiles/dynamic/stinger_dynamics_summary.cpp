#include "resultfiles/summary/summary_fields.h"
#include "resultfiles/summary/summary_json.h"
#include "results/fields/stinger_dynamics_fields.h"

namespace overbend {

/// A single section is the object itself; several are listed in addition to the first, as in static.stinger.
void add_stinger_dynamics(const DynamicResults& results, Json& summary) {
  if (results.stinger.empty()) return;
  const SummaryStyle style;
  const auto section_json = [&](const StingerSectionDynamics& section) {
    return make_object(style, [&](auto& visitor) { visit_stinger_dynamics(section, visitor); });
  };
  Json& stinger = summary["dynamic"]["stinger"];
  stinger = section_json(results.stinger.front());
  if (results.stinger.size() > 1) {
    stinger["sections"] = style.rows(results.stinger, section_json);
  }
}

}  // namespace overbend
