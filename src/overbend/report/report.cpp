#include "report/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "report/dynamic/dynamic_sections.h"
#include "report/dynamic/fatigue_section.h"
#include "report/moored/bodies_section.h"
#include "report/moored/hull_section.h"
#include "report/moored/lines_section.h"
#include "report/moored/moored_dynamics_section.h"
#include "report/moored/moorings_section.h"
#include "report/page/calculation_sheet.h"
#include "report/page/figures.h"
#include "report/page/front_of.h"
#include "report/page/html.h"
#include "report/page/page.h"
#include "report/page/quantity.h"
#include "report/page/sections.h"
#include "report/static/checks_section.h"
#include "report/static/criteria_section.h"
#include "report/static/friction_section.h"
#include "report/static/sensitivity_section.h"
#include "report/static/stinger_section.h"
#include "report/studies/report_data.h"
#include "report/studies/seek_section.h"
#include "results/findings.h"

namespace overbend {
namespace {

std::string static_tables(const StaticResults& results) {
  return (results.has_pipe() ? html::section("summary", "Static summary", static_summary_table(results)) : "") +
         (results.supports.empty() ? "" : html::section("supports", "Supports", support_table(results))) +
         stinger_section(results) + structures_section(results) + attachments_section(results) +
         laid_pipe_section(results) + friction_section(results);
}

/// Moorings, stages of an operation and hull at rest. Figures are numbered in the order of the page, so that parts with
/// figures are made one after the other.
std::string moored_part(const StaticResults& results, int& figure) {
  std::string part;
  if (results.moorings) {
    part += moorings_section(*results.moorings, figure);
    part += operation_section(*results.moorings, figure);
  }
  return results.hull ? part + hull_section(*results.hull) : part;
}

/// "Static pipelay analysis": by what is analysed. `dynamic` or static.
std::string analysis_name(const StaticResults& results, bool dynamic) {
  if (results.moorings && !results.has_pipe()) return dynamic ? "Dynamic mooring analysis" : "Mooring analysis";
  return std::string(dynamic ? "Dynamic" : "Static") +
         (results.has_pipe() ? " pipelay analysis" : " analysis of lines");
}

/// `sections`: in their order, empty where the model does not have the object; a list in braces is made from left to
/// right, as its figures are numbered.
std::string joined(const std::vector<std::string>& sections) {
  return fmt::format("{}", fmt::join(sections, ""));
}

}  // namespace

std::string report_html(const StaticResults& results, const std::string& model_text, const StaticExtras& extras) {
  const std::optional<Description> description = description_of(model_text);
  int figure = 0;
  const std::string sections = joined(
      {extras.seek != nullptr ? seek_section(*extras.seek, figure) : "", key_results(results, "results", "Key results"),
       lay_setting_section(results, description, nullptr), criteria_section(results.checks, description),
       checks_section(results, results.checks, figure), lines_section(results, nullptr, figure),
       bodies_section(results, nullptr), figures_section(results, "figures", "Figures", figure),
       extras.sensitivities != nullptr ? sensitivity_section(*extras.sensitivities, figure) : "",
       static_tables(results), moored_part(results, figure), inputs_section(results, description, nullptr),
       assumptions_section(results.assumptions), rollers_section(results), calculation_sheet_section(results.checks),
       check_inputs_section(results.checks), balance_section(results), model_text_section(model_text)});
  FrontPage front = front_of(analysis_name(results, false), results.title, description, results.findings);
  front.reach = "Checks of the static state only: the effect of waves needs a dynamic analysis.";
  front.entries = subject_entries(results, description);
  front.entries.emplace_back("Status", status_words("converged", front.findings.size()));
  front.entries.emplace_back("Program", "Overbend " + results.version);
  front.entries.emplace_back("Written", written_now());
  return whole_page(results.title + " - static analysis", front_page(front, results, results.checks, sections),
                    report_data(results, nullptr, description, extras.seek));
}

std::string report_html(const StaticResults& statics, const DynamicResults& results, const std::string& model_text) {
  const std::optional<Description> description = description_of(model_text);
  int figure = 0;
  const std::string sections = joined({dynamic_key_results(statics, results),
                                       lay_setting_section(statics, description, &results),
                                       criteria_section(results.checks, description),
                                       checks_section(statics, results.checks, figure),
                                       lines_section(statics, &results, figure),
                                       bodies_section(statics, &results),
                                       dynamic_figures_section(statics, results, figure),
                                       fatigue_section(statics, results, figure),
                                       dynamic_statistics_section(statics, results),
                                       dynamic_supports_section(results),
                                       impacts_section(statics, results),
                                       tensioner_section(statics, results),
                                       moored_dynamics_section(results, figure),
                                       key_results(statics, "static-results", "Initial static state"),
                                       figures_section(statics, "figures", "Figures of the static state", figure),
                                       static_tables(statics),
                                       moored_part(statics, figure),
                                       inputs_section(statics, description, &results),
                                       assumptions_section(merge(statics.assumptions, results.assumptions)),
                                       dynamic_rollers_section(results),
                                       rollers_section(statics),
                                       calculation_sheet_section(results.checks),
                                       check_inputs_section(results.checks),
                                       dynamic_run_section(results),
                                       balance_section(statics),
                                       model_text_section(model_text)});
  FrontPage front = front_of(analysis_name(statics, true), statics.title, description, all_findings(statics, results));
  front.reach = "Maxima of a single run of " + duration_words(results.duration) + ".";
  front.entries = dynamic_entries(statics, results, description, written_now());
  return whole_page(statics.title + " - dynamic analysis", front_page(front, statics, results.checks, sections),
                    report_data(statics, &results, description));
}

void write_report(const StaticResults& results, const std::string& model_text, const std::filesystem::path& file,
                  const StaticExtras& extras) {
  write_page(report_html(results, model_text, extras), file);
}

void write_report(const StaticResults& statics, const DynamicResults& results, const std::string& model_text,
                  const std::filesystem::path& file) {
  write_page(report_html(statics, results, model_text), file);
}

}  // namespace overbend
