#include "resultfiles/summary/summary_json.h"

#include "resultfiles/summary/lift_json.h"
#include "resultfiles/summary/result_objects.h"
#include "resultfiles/summary/summary_fields.h"
#include "results/verdict.h"

namespace overbend {

Json static_summary_json(const StaticResults& r) {
  const SummaryStyle style;
  Json sections = Json::array();
  for (const DerivedSection& section : r.sections) {
    sections.push_back(make_object(style, [&](auto& visitor) { visit_section(section, visitor); }));
  }
  JsonWriter json(style);
  json["status"] = "converged";
  visit_heading(r, json);
  json["units"] = r.has_pipe() || !r.moorings
                      ? "SI: m, N, Pa, rad, s; angles from horizontal"
                      : "SI: m, N, rad; angles of the vessel by Rz(yaw) Ry(pitch) Rx(roll) along the nominal axes";
  json["frame"] = kWorldFrame;
  if (!sections.empty()) {
    json["derived"] = sections.front();
    json["sections"] = sections;
  }
  json["verdict"] = verdict_json(make_verdict(r.checks, r.findings));
  json["checks"] = summary_checks(style, r.checks);
  json["static"] = r.has_pipe() ? static_part(style, r) : Json::object();
  Json summary = json.take();
  if (r.moorings) add_moorings(*r.moorings, summary);
  if (r.hull) add_hull(*r.hull, summary);
  add_lines(r, summary);
  add_bodies(r, summary);
  if (r.lift) summary["static"]["lift"] = lift_json(*r.lift);
  return summary;
}

std::string summary_text(const Json& summary) {
  // A title may contain bytes that are not UTF-8; they become the replacement character.
  return json_text(with_objects(summary), 2) + "\n";
}

std::string static_summary(const StaticResults& results) {
  return summary_text(static_summary_json(results));
}

}  // namespace overbend
