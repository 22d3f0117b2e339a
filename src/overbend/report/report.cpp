#include "report/report.h"

#include <algorithm>
#include <stdexcept>

#include "io/yaml_reader.h"
#include "report/checks_section.h"
#include "report/dynamic_sections.h"
#include "report/figures.h"
#include "report/html.h"
#include "report/page.h"
#include "report/report_data.h"
#include "report/sections.h"

namespace overbend {
namespace {

/// The inputs are told as the program understands them; what it can not read any more is still printed at the end.
std::optional<Description> description_of(const std::string& model_text) {
  return read_model_text(model_text, "model.yaml").description;
}

void require_stations(bool any) {
  if (!any) {
    throw std::logic_error("a report needs results with stations");
  }
}

std::string static_tables(const StaticResults& results) {
  return "<div class=\"wide\">\n" + html::section("summary", "Static summary", static_summary_table(results)) +
         "</div>\n" +
         (results.supports.empty()
              ? ""
              : html::section("supports", "Supports", support_table(results) + roller_table(results)));
}

/// Each once, in the order in which they come.
std::vector<std::string> together(std::vector<std::string> all, const std::vector<std::string>& more) {
  for (const std::string& text : more) {
    if (std::find(all.begin(), all.end(), text) == all.end()) {
      all.push_back(text);
    }
  }
  return all;
}

}  // namespace

std::string report_html(const StaticResults& results, const std::string& model_text) {
  require_stations(!results.stations.empty());
  const std::optional<Description> description = description_of(model_text);
  const std::vector<std::string> remarks = static_remarks(results);
  std::vector<std::pair<std::string, std::string>> entries = subject_entries(results);
  entries.emplace_back("Status", status_words("converged", remarks.size()));
  entries.emplace_back("Program", "Overbend " + results.version);
  entries.emplace_back("Written", written_now());
  int figure = 0;
  const std::string checks = checks_section(results, results.checks, figure);
  const std::string body = title_block("Static pipelay analysis", results.title, entries) +
                           key_results(results, "results", "Key results") + warnings_section(remarks) + checks +
                           figures_section(results, "figures", "Figures", figure) + static_tables(results) +
                           inputs_section(results, description, nullptr) + assumptions_section(results.assumptions) +
                           balance_section(results) + model_text_section(model_text);
  return whole_page(results.title + " - static analysis", body, report_data(results));
}

std::string report_html(const StaticResults& statics, const DynamicResults& results, const std::string& model_text) {
  require_stations(!statics.stations.empty() && !results.station_s.empty());
  const std::optional<Description> description = description_of(model_text);
  int figure = 0;
  const std::string checks = checks_section(statics, results.checks, figure);
  const std::string dynamic =
      dynamic_title_block(statics, results, description, written_now()) + dynamic_key_results(statics, results) +
      warnings_section(dynamic_remarks(statics, results)) + checks + dynamic_figures_section(statics, results, figure) +
      dynamic_statistics_section(statics, results) + dynamic_supports_section(results) +
      impacts_section(statics, results) + tensioner_section(statics, results) + dynamic_run_section(results);
  const std::string before = key_results(statics, "static-results", "The static state from which the run starts") +
                             figures_section(statics, "figures", "Figures of the static state", figure) +
                             static_tables(statics);
  const std::string closing = inputs_section(statics, description, &results) +
                              assumptions_section(together(statics.assumptions, results.assumptions)) +
                              balance_section(statics) + model_text_section(model_text);
  return whole_page(statics.title + " - dynamic analysis", dynamic + before + closing, report_data(statics, &results));
}

void write_report(const StaticResults& results, const std::string& model_text, const std::filesystem::path& file) {
  write_page(report_html(results, model_text), file);
}

void write_report(const StaticResults& statics, const DynamicResults& results, const std::string& model_text,
                  const std::filesystem::path& file) {
  write_page(report_html(statics, results, model_text), file);
}

}  // namespace overbend
