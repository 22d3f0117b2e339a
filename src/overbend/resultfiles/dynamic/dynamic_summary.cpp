#include "resultfiles/dynamic/dynamic_writer.h"
#include "resultfiles/static/case_summary.h"
#include "resultfiles/summary/summary_fields.h"
#include "resultfiles/summary/summary_json.h"
#include "results/findings.h"
#include "results/verdict.h"

namespace overbend {

Json dynamic_summary_json(const StaticResults& statics, const DynamicResults& results) {
  Json summary = static_summary_json(statics);
  summary["dynamic"] = dynamic_part(SummaryStyle{}, statics, results);
  summary["dynamic"]["verdict"] = verdict_json(make_verdict(results.checks, all_findings(statics, results)));
  add_moored_dynamics(results, summary);
  add_stinger_dynamics(results, summary);
  add_fatigue(results, summary);
  add_lines_in_time(results, summary);
  add_bodies_in_time(results, summary);
  return summary;
}

std::string dynamic_summary(const StaticResults& statics, const DynamicResults& results) {
  return summary_text(dynamic_summary_json(statics, results));
}

}  // namespace overbend
