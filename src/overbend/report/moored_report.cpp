// The report of a hull on its mooring lines, without a pipe.
#include "report/front_of.h"
#include "report/hull_section.h"
#include "report/mooring_verdict.h"
#include "report/moorings_section.h"
#include "report/page.h"
#include "report/report.h"
#include "report/report_data.h"
#include "report/sections.h"

namespace overbend {
namespace {

FrontPage moored_front(const MooringResults& results, const std::optional<Description>& description) {
  FrontPage front = front_of("Mooring analysis", results.title, description, results.warnings);
  front.reach = "Static states only: the effect of waves needs a dynamic analysis.";
  front.more = mooring_bars(results, working_load_of(description));
  if (description) front.entries.emplace_back("Vessel", description->vessel.name);
  front.entries.emplace_back("Mooring lines", std::to_string(results.rest.moorings.size()));
  front.entries.emplace_back("Status", status_words("converged", front.warnings.size()));
  front.entries.emplace_back("Program", "Overbend " + results.version);
  front.entries.emplace_back("Written", written_now());
  return front;
}

}  // namespace

std::string report_html(const MooringResults& results, const std::string& model_text) {
  const std::optional<Description> description = description_of(model_text);
  int figure = 0;
  const std::string moorings = moorings_section(results, figure);  // before the next: figures are numbered on
  const std::string rest = moorings + operation_section(results, figure) +
                           (results.hull ? hull_section(*results.hull) : "") +
                           (description ? inputs_section(*description) : "") +
                           assumptions_section(results.assumptions) + model_text_section(model_text);
  const FrontPage front = moored_front(results, description);
  return page_without_pipe(results.title + " - mooring analysis",
                           front_page(front, load_verdict(front.more, front.warnings),
                                      "The mark on the bar is the full capacity, without safety factors.", rest),
                           report_data(results, description));
}

void write_report(const MooringResults& results, const std::string& model_text, const std::filesystem::path& file) {
  write_page(report_html(results, model_text), file);
}

}  // namespace overbend
