#include "report/report_without_pipe.h"

#include <algorithm>

#include "report/dynamic/dynamic_sections.h"
#include "report/dynamic/history_data.h"
#include "report/moored/hull_section.h"
#include "report/moored/lines_section.h"
#include "report/moored/moored_dynamics_section.h"
#include "report/moored/moorings_section.h"
#include "report/page/figure_list.h"
#include "report/page/front_of.h"
#include "report/page/page.h"
#include "report/page/quantity.h"
#include "report/page/sea_words.h"
#include "report/page/sections.h"
#include "report/static/criteria_section.h"
#include "report/studies/report_data.h"
#include "results/findings.h"

namespace overbend {
namespace {

/// "mooring", "lines": of what the analysis is.
std::string analysis_of(const StaticResults& results, const char* how) {
  const bool of_time = std::string(how) == "Dynamic";
  if (results.moorings) return of_time ? "Dynamic mooring analysis" : "Mooring analysis";
  return std::string(how) + " analysis of lines";
}

void add_subject(const StaticResults& results, const std::optional<Description>& description, FrontPage& front) {
  if (results.moorings) {
    if (description) front.entries.emplace_back("Vessel", description->vessel.name);
    front.entries.emplace_back("Mooring lines", std::to_string(results.moorings->rest.moorings.size()));
  }
  if (!results.lines.empty()) front.entries.emplace_back("Lines", std::to_string(results.lines.size()));
}

void add_closing(const StaticResults& results, const std::string& status, FrontPage& front) {
  front.entries.emplace_back("Status", status_words(status, front.findings.size()));
  front.entries.emplace_back("Program", "Overbend " + results.version);
  front.entries.emplace_back("Written", written_now());
}

FrontPage front_at_rest(const StaticResults& results, const std::optional<Description>& description) {
  FrontPage front = front_of(analysis_of(results, "Static"), results.title, description, results.findings);
  front.reach = "Static states only: the effect of waves needs a dynamic analysis.";
  add_subject(results, description, front);
  add_closing(results, "converged", front);
  return front;
}

FrontPage front_in_time(const StaticResults& statics, const DynamicResults& results,
                        const std::optional<Description>& description) {
  FrontPage front =
      front_of(analysis_of(statics, "Dynamic"), statics.title, description, all_findings(statics, results));
  front.reach = "Maxima of a single run of " + duration_words(results.duration) + ".";
  add_subject(statics, description, front);
  add_run_entries(results, description, front.entries);
  add_closing(statics, "completed", front);
  return front;
}

std::string page_title(const StaticResults& results, const FrontPage& front) {
  std::string kind = front.kind;
  kind.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(kind.front())));
  return results.title + " - " + kind;
}

/// What lies at rest: moorings, stages of an operation, the hull. Figures are numbered in the order of the page.
std::string moored_parts(const StaticResults& results, int& figure) {
  std::string parts;
  if (results.moorings) {
    parts += moorings_section(*results.moorings, figure);
    parts += operation_section(*results.moorings, figure);
  }
  if (results.hull) parts += hull_section(*results.hull);
  return parts;
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
  const bool moves = std::ranges::any_of(kFigures, [&](const Figure& figure) {
    return figure.id != std::string("spectra") && makes_sense(figure, figure.parts.front());
  });
  return figure_section("dynamic-figures", moves ? "Motion of the vessel and sea" : "Spectra",
                        figure_list(kFigures, makes_sense, number));
}

}  // namespace

std::string report_without_pipe(const StaticResults& results, const std::string& model_text) {
  const std::optional<Description> description = description_of(model_text);
  int figure = 0;
  const std::string moored = moored_parts(results, figure);
  const std::string rest = criteria_section(results.checks, description) + moored +
                           lines_section(results, nullptr, figure) + (description ? inputs_section(*description) : "") +
                           assumptions_section(results.assumptions) + model_text_section(model_text);
  const FrontPage front = front_at_rest(results, description);
  return page_without_pipe(page_title(results, front), front_page(front, results.checks, rest),
                           report_data(results, nullptr, description));
}

std::string report_without_pipe(const StaticResults& statics, const DynamicResults& results,
                                const std::string& model_text) {
  const std::optional<Description> description = description_of(model_text);
  int figure = 0;
  const std::string lines = lines_section(statics, &results, figure);
  const std::string moved = moored_dynamics_section(results, figure);
  const std::string figures = figures_in_time(statics, results, figure);
  const std::string statistics = dynamic_statistics_section(statics, results);
  const std::string before = moored_parts(statics, figure);
  const std::string closing = (description ? inputs_section(*description) : "") +
                              assumptions_section(merge(statics.assumptions, results.assumptions)) +
                              dynamic_run_section(results) + model_text_section(model_text);
  const FrontPage front = front_in_time(statics, results, description);
  return page_without_pipe(page_title(statics, front),
                           front_page(front, results.checks,
                                      criteria_section(results.checks, description) + lines + moved + figures +
                                          statistics + before + closing),
                           report_data(statics, &results, description));
}

}  // namespace overbend
