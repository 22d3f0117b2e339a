// The report of a hull on its mooring lines, without a pipe.
#include <algorithm>

#include "report/dynamic/dynamic_sections.h"
#include "report/dynamic/history_data.h"
#include "report/moored/hull_section.h"
#include "report/moored/moored_dynamics_section.h"
#include "report/moored/moorings_section.h"
#include "report/moored_report.h"
#include "report/page/figure_list.h"
#include "report/page/front_of.h"
#include "report/page/page.h"
#include "report/page/quantity.h"
#include "report/page/sea_words.h"
#include "report/page/sections.h"
#include "report/report.h"
#include "report/static/criteria_section.h"
#include "report/studies/report_data.h"
#include "results/findings.h"

namespace overbend {
namespace {

void add_subject(const MooringResults& results, const std::optional<Description>& description, FrontPage& front) {
  if (description) front.entries.emplace_back("Vessel", description->vessel.name);
  front.entries.emplace_back("Mooring lines", std::to_string(results.rest.moorings.size()));
}

void add_closing(const MooringResults& results, const std::string& status, FrontPage& front) {
  front.entries.emplace_back("Status", status_words(status, front.findings.size()));
  front.entries.emplace_back("Program", "Overbend " + results.version);
  front.entries.emplace_back("Written", written_now());
}

FrontPage moored_front(const MooringResults& results, const std::optional<Description>& description) {
  FrontPage front = front_of("Mooring analysis", results.title, description, results.findings);
  front.reach = "Static states only: the effect of waves needs a dynamic analysis.";
  add_subject(results, description, front);
  add_closing(results, "converged", front);
  return front;
}

FrontPage front_in_time(const StaticResults& statics, const DynamicResults& results,
                        const std::optional<Description>& description) {
  const MooringResults& rest = *statics.moorings;
  FrontPage front = front_of("Dynamic mooring analysis", rest.title, description, all_findings(statics, results));
  front.reach = "Maxima of a single run of " + duration_words(results.duration) + ".";
  add_subject(rest, description, front);
  add_run_entries(results, description, front.entries);
  add_closing(rest, "completed", front);
  return front;
}

std::string figures_in_time(const StaticResults& statics, const DynamicResults& results, int& number) {
  static const std::vector<Figure> kFigures = {
      {"history", "Pull-ahead in time: the vessel from as drawn; the build-up is shaded", {"operation"}},
      {"history", "Time histories of the vessel's motion; the build-up is shaded", {"motions"}, true},
      {"history", "Time history of wave elevation at midship", {"wave"}},
      {"spectra", "Spectra of motions and tensions; the upper scale is the period", {"all"}, true}};
  const Json histories = history_data(statics, results);
  const auto makes_sense = [&](const Figure& figure, const std::string& part) {
    if (std::string(figure.id) == "spectra") return !spectrum_data(results).empty();
    return std::any_of(histories.begin(), histories.end(), [&](const Json& one) { return one["group"] == part; });
  };
  return figure_section("dynamic-figures", "Motion of the vessel and sea", figure_list(kFigures, makes_sense, number));
}

}  // namespace

std::string report_html(const MooringResults& results, const std::string& model_text) {
  const std::optional<Description> description = description_of(model_text);
  int figure = 0;
  const std::string moorings = moorings_section(results, figure);  // before the next: figures are numbered on
  const std::string rest = criteria_section(results.checks, description) + moorings +
                           operation_section(results, figure) + (results.hull ? hull_section(*results.hull) : "") +
                           (description ? inputs_section(*description) : "") +
                           assumptions_section(results.assumptions) + model_text_section(model_text);
  const FrontPage front = moored_front(results, description);
  return page_without_pipe(results.title + " - mooring analysis", front_page(front, results.checks, rest),
                           report_data(results, nullptr, description));
}

std::string moored_report_in_time(const StaticResults& statics, const DynamicResults& results,
                                  const std::string& model_text) {
  const std::optional<Description> description = description_of(model_text);
  const MooringResults& rest = *statics.moorings;
  int figure = 0;
  const std::string moved = moored_dynamics_section(results, figure);
  const std::string figures = figures_in_time(statics, results, figure);
  const std::string statistics = dynamic_statistics_section(statics, results);
  const std::string before =
      moorings_section(rest, figure) + operation_section(rest, figure) + (rest.hull ? hull_section(*rest.hull) : "");
  const std::string closing = (description ? inputs_section(*description) : "") +
                              assumptions_section(merge(rest.assumptions, results.assumptions)) +
                              dynamic_run_section(results) + model_text_section(model_text);
  const FrontPage front = front_in_time(statics, results, description);
  return page_without_pipe(
      rest.title + " - dynamic mooring analysis",
      front_page(front, results.checks,
                 criteria_section(results.checks, description) + moved + figures + statistics + before + closing),
      report_data(rest, &results, description));
}

void write_report(const MooringResults& results, const std::string& model_text, const std::filesystem::path& file) {
  write_page(report_html(results, model_text), file);
}

}  // namespace overbend
