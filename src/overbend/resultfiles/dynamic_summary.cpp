#include "resultfiles/dynamic_writer.h"
#include "resultfiles/summary_fields.h"
#include "resultfiles/summary_json.h"

namespace overbend {

std::string dynamic_summary(const StaticResults& statics, const DynamicResults& results) {
  Json summary = static_summary_json(statics);
  summary["dynamic"] = dynamic_part(SummaryStyle{}, statics, results);
  add_moored_dynamics(results, summary);
  return summary_text(summary);
}

}  // namespace overbend
