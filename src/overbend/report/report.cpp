#include "report/report.h"

#include "report/dynamic/dynamic_sections.h"
#include "report/dynamic/fatigue_section.h"
#include "report/moored/bodies_section.h"
#include "report/moored/hull_section.h"
#include "report/moored/lines_section.h"
#include "report/moored/moored_dynamics_section.h"
#include "report/moored/moorings_section.h"
#include "report/page/calculation_sheet.h"
#include "report/page/figures.h"
#include "report/page/make_front_page.h"
#include "report/page/page.h"
#include "report/page/quantity.h"
#include "report/page/sections.h"
#include "report/static/checks_section.h"
#include "report/static/criteria_section.h"
#include "report/static/friction_section.h"
#include "report/static/sensitivity_section.h"
#include "report/static/stinger_report.h"
#include "report/studies/report_data.h"
#include "report/studies/seek_section.h"
#include "results/findings.h"

namespace overbend {
namespace {

Blocks static_tables(const StaticResults& results) {
  return (results.has_pipe() ? block::section("summary", "Static summary", static_summary_table(results)) : Blocks()) +
         block::section("supports", "Supports", support_table(results)) + stinger_section(results) +
         structures_section(results) + attachments_section(results) + laid_pipe_section(results) +
         friction_section(results);
}

/// Static results of moorings, operation stages and hull.
Blocks moored_part(const StaticResults& results) {
  Blocks part;
  if (results.moorings) part += moorings_section(*results.moorings) + operation_section(*results.moorings);
  if (results.hull) part += hull_section(*results.hull);
  return part;
}

/// Title by the subject of the analysis: "Static pipelay analysis". `dynamic`: true for a dynamic analysis.
std::string analysis_name(const StaticResults& results, bool dynamic) {
  if (results.moorings && !results.has_pipe()) return dynamic ? "Dynamic mooring analysis" : "Mooring analysis";
  return std::string(dynamic ? "Dynamic" : "Static") +
         (results.has_pipe() ? " pipelay analysis" : " analysis of lines");
}

}  // namespace

Document report_document(const StaticResults& results, const std::string& model_text, const StaticExtras& extras) {
  const std::optional<Description> description = read_description(model_text);
  Blocks body;
  if (extras.seek != nullptr) body += seek_section(*extras.seek);
  body += key_results(results, "results", "Key results");
  body += lay_setting_section(results, description, nullptr);
  body += criteria_section(results.checks, description);
  body += checks_section(results, results.checks);
  body += lines_section(results, nullptr);
  body += bodies_section(results, nullptr);
  body += figures_section(results, "figures", "Figures");
  if (extras.sensitivities != nullptr) body += sensitivity_section(*extras.sensitivities);
  body += static_tables(results);
  body += moored_part(results);
  body += inputs_section(results, description, nullptr);
  body += assumptions_section(results.assumptions);
  body += rollers_section(results);
  body += calculation_sheet_section(results.checks);
  body += check_inputs_section(results.checks);
  body += balance_section(results);
  body += model_text_section(model_text);
  FrontPage front = make_front_page(analysis_name(results, false), results.title, description, results.findings);
  front.reach = "Checks of the static state only: the effect of waves needs a dynamic analysis.";
  front.entries = subject_entries(results, description);
  front.entries.emplace_back("Status", status_label("converged", front.findings.size()));
  front.entries.emplace_back("Program", "Overbend " + results.version);
  front.entries.emplace_back("Written", written_now());
  return {results.title + " - static analysis", front_page(front, results, results.checks), body,
          report_data(results, nullptr, description, extras.seek)};
}

Document report_document(const StaticResults& statics, const DynamicResults& results, const std::string& model_text) {
  const std::optional<Description> description = read_description(model_text);
  Blocks body = dynamic_key_results(statics, results);
  body += lay_setting_section(statics, description, &results);
  body += criteria_section(results.checks, description);
  body += checks_section(statics, results.checks);
  body += lines_section(statics, &results);
  body += bodies_section(statics, &results);
  body += dynamic_figures_section(statics, results);
  body += fatigue_section(statics, results);
  body += dynamic_statistics_section(statics, results);
  body += dynamic_supports_section(results);
  body += impacts_section(statics, results);
  body += tensioner_section(statics, results);
  body += moored_dynamics_section(results);
  body += key_results(statics, "static-results", "Initial static state");
  body += figures_section(statics, "figures", "Figures of the static state");
  body += static_tables(statics);
  body += moored_part(statics);
  body += inputs_section(statics, description, &results);
  body += assumptions_section(merge(statics.assumptions, results.assumptions));
  body += dynamic_rollers_section(results);
  body += rollers_section(statics);
  body += calculation_sheet_section(results.checks);
  body += check_inputs_section(results.checks);
  body += dynamic_run_section(results);
  body += balance_section(statics);
  body += model_text_section(model_text);
  FrontPage front =
      make_front_page(analysis_name(statics, true), statics.title, description, all_findings(statics, results));
  front.reach = "Maxima of a single run of " + readable_duration(results.duration) + ".";
  front.entries = dynamic_entries(statics, results, description, written_now());
  return {statics.title + " - dynamic analysis", front_page(front, statics, results.checks), body,
          report_data(statics, &results, description)};
}

void write_report(const StaticResults& results, const std::string& model_text, const std::filesystem::path& file,
                  const StaticExtras& extras) {
  write_page(report_document(results, model_text, extras), file);
}

void write_report(const StaticResults& statics, const DynamicResults& results, const std::string& model_text,
                  const std::filesystem::path& file) {
  write_page(report_document(statics, results, model_text), file);
}

}  // namespace overbend
