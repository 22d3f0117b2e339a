#include "resultfiles/dynamic/dynamic_writer.h"
#include "resultfiles/static/case_summary.h"
#include "resultfiles/summary/summary_fields.h"
#include "resultfiles/summary/summary_json.h"
#include "results/findings.h"
#include "results/verdict.h"

namespace overbend {

namespace {

/// Of a run without a pipe.
Json part_without_pipe(const DynamicResults& results) {
  const SummaryStyle style;
  JsonWriter json(style);
  visit_dynamic_settings(results, json);
  json["extremes"] = style.rows(results.extremes, [&](const ExtremeEstimate& estimate) {
    return object_of(style, [&](auto& one) { visit_estimate(estimate, one); });
  });
  json["energy_drift"] = style.number(results.energy.drift());
  visit_dynamic_run(results.run, json);
  json["checks"] = summary_checks(style, results.checks);
  return json.take();
}

}  // namespace

Json dynamic_summary_json(const StaticResults& statics, const DynamicResults& results) {
  Json summary = static_summary_json(statics);
  summary["dynamic"] = statics.has_pipe() ? dynamic_part(SummaryStyle{}, statics, results) : part_without_pipe(results);
  summary["dynamic"]["verdict"] = verdict_json(make_verdict(results.checks, all_findings(statics, results)));
  add_moored_dynamics(results, summary);
  add_stinger_dynamics(results, summary);
  add_fatigue(results, summary);
  add_lines_in_time(results, summary);
  return summary;
}

std::string dynamic_summary(const StaticResults& statics, const DynamicResults& results) {
  return summary_text(dynamic_summary_json(statics, results));
}

}  // namespace overbend
