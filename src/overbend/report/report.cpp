#include "report/report.h"

#include <algorithm>
#include <stdexcept>

#include "report/dynamic/dynamic_sections.h"
#include "report/dynamic/fatigue_section.h"
#include "report/moored/hull_section.h"
#include "report/moored/moored_dynamics_section.h"
#include "report/moored/moorings_section.h"
#include "report/page/calculation_sheet.h"
#include "report/page/figures.h"
#include "report/page/front_of.h"
#include "report/page/html.h"
#include "report/page/page.h"
#include "report/page/quantity.h"
#include "report/page/sections.h"
#include "report/report_without_pipe.h"
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

void require_stations(bool any) {
  if (!any) {
    throw std::logic_error("a report needs results with stations");
  }
}

std::string static_tables(const StaticResults& results) {
  return html::section("summary", "Static summary", static_summary_table(results)) +
         (results.supports.empty() ? "" : html::section("supports", "Supports", support_table(results))) +
         stinger_section(results) + structures_section(results) + laid_pipe_section(results) +
         friction_section(results);
}

std::string hull_part(const StaticResults& results) {
  return results.hull ? hull_section(*results.hull) : "";
}

/// Figures are numbered in the order of the page, so that parts with figures are made one after the other.
std::string moorings_part(const StaticResults& results, int& figure) {
  if (!results.moorings) return "";
  std::string part = moorings_section(*results.moorings, figure);
  part += operation_section(*results.moorings, figure);
  return part;
}

}  // namespace

std::string report_html(const StaticResults& results, const std::string& model_text, const StaticExtras& extras) {
  if (!results.has_pipe()) return report_without_pipe(results, model_text);
  require_stations(!results.stations.empty());
  const std::optional<Description> description = description_of(model_text);
  int figure = 0;
  const std::string sought = extras.seek != nullptr ? seek_section(*extras.seek, figure) : "";
  const std::string checks = checks_section(results, results.checks, figure);
  const std::string figures = figures_section(results, "figures", "Figures", figure);
  const std::string sensitivity =
      extras.sensitivities != nullptr ? sensitivity_section(*extras.sensitivities, figure) : "";
  const std::string moorings = moorings_part(results, figure);
  const std::string rest =
      sought + key_results(results, "results", "Key results") + lay_setting_section(results, description, nullptr) +
      criteria_section(results.checks, description) + checks + figures + sensitivity + static_tables(results) +
      moorings + hull_part(results) + inputs_section(results, description, nullptr) +
      assumptions_section(results.assumptions) + rollers_section(results) + calculation_sheet_section(results.checks) +
      check_inputs_section(results.checks) + balance_section(results) + model_text_section(model_text);
  FrontPage front = front_of("Static pipelay analysis", results.title, description, results.findings);
  front.reach = "Checks of the static state only: the effect of waves needs a dynamic analysis.";
  front.entries = subject_entries(results);
  front.entries.emplace_back("Status", status_words("converged", front.findings.size()));
  front.entries.emplace_back("Program", "Overbend " + results.version);
  front.entries.emplace_back("Written", written_now());
  return whole_page(results.title + " - static analysis", front_page(front, results, results.checks, rest),
                    report_data(results, nullptr, description, extras.seek));
}

std::string report_html(const StaticResults& statics, const DynamicResults& results, const std::string& model_text) {
  if (!statics.has_pipe()) return report_without_pipe(statics, results, model_text);
  require_stations(!statics.stations.empty() && !results.station_s.empty());
  const std::optional<Description> description = description_of(model_text);
  int figure = 0;
  const std::string checks = checks_section(statics, results.checks, figure);
  const std::string figures = dynamic_figures_section(statics, results, figure);
  const std::string fatigue = fatigue_section(statics, results, figure);
  const std::string moored = moored_dynamics_section(results, figure);
  const std::string static_figures = figures_section(statics, "figures", "Figures of the static state", figure);
  const std::string moorings = moorings_part(statics, figure);
  const std::string dynamic = dynamic_key_results(statics, results) +
                              lay_setting_section(statics, description, &results) +
                              criteria_section(results.checks, description) + checks + figures + fatigue +
                              dynamic_statistics_section(statics, results) + dynamic_supports_section(results) +
                              impacts_section(statics, results) + tensioner_section(statics, results) + moored;
  const std::string before = key_results(statics, "static-results", "Initial static state") + static_figures +
                             static_tables(statics) + moorings + hull_part(statics);
  const std::string closing = inputs_section(statics, description, &results) +
                              assumptions_section(merge(statics.assumptions, results.assumptions)) +
                              dynamic_rollers_section(results) + rollers_section(statics) +
                              calculation_sheet_section(results.checks) + check_inputs_section(results.checks) +
                              dynamic_run_section(results) + balance_section(statics) + model_text_section(model_text);
  const std::string rest = dynamic + before + closing;
  FrontPage front = front_of("Dynamic pipelay analysis", statics.title, description, all_findings(statics, results));
  front.reach = "Maxima of a single run of " + duration_words(results.duration) + ".";
  front.entries = dynamic_entries(statics, results, description, written_now());
  return whole_page(statics.title + " - dynamic analysis", front_page(front, statics, results.checks, rest),
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
