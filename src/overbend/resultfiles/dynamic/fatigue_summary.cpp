#include "resultfiles/summary/summary_fields.h"
#include "resultfiles/summary/summary_json.h"
#include "results/fields/fatigue_fields.h"

namespace overbend {

void add_fatigue(const DynamicResults& results, Json& summary) {
  if (!results.fatigue) return;
  const SummaryStyle style;
  Json& fatigue = summary["dynamic"]["fatigue"];
  fatigue = make_object(style, [&](auto& visitor) { visit_fatigue(*results.fatigue, visitor); });
  fatigue["spots"] = style.rows(results.fatigue->spots, [&](const FatigueSpot& spot) {
    return make_object(style, [&](auto& visitor) { visit_fatigue_spot(spot, visitor); });
  });
}

}  // namespace overbend
