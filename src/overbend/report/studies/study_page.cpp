#include "report/studies/study_page.h"

#include "report/page/figure_list.h"
#include "report/page/make_front_page.h"
#include "report/page/quantity.h"
#include "report/page/sections.h"
#include "report/studies/study_data.h"
#include "report/studies/study_sections.h"

namespace overbend {
namespace {

const std::vector<Figure>& make_figures(StudyShape shape) {
  static const std::vector<Figure> kCurves = {
      {"study_curves", "Results over the varied key; bands show the range over the seeds", {"all"}, true}};
  static const std::vector<Figure> kMaps = {{"study_maps",
                                             "Results over the varied keys. The heavy line encloses the cases in "
                                             "which every governing check passes; hatched cells have no result",
                                             {"all"},
                                             true}};
  static const std::vector<Figure> kSwings = {
      {"study_swings",
       "Range of the results as one key at a time takes its values, the others as in the base case",
       {"all"},
       true}};
  static const std::vector<Figure> kSample = {
      {"study_correlations", "Rank correlation of the results with the keys (Spearman)", {"all"}, true},
      {"study_scatter", "Results over the sampled keys; open circles exceed a governing check", {"all"}, true}};
  static const std::vector<Figure> kNone;
  switch (shape) {
    case StudyShape::curves:
      return kCurves;
    case StudyShape::maps:
      return kMaps;
    case StudyShape::one_at_a_time:
      return kSwings;
    case StudyShape::sample:
      return kSample;
    default:
      return kNone;
  }
}

/// True if the chart has an axis of directions.
bool has_headings(const OperabilityResults& operability) {
  for (const StudyInput& axis : operability.axes) {
    if (axis.unit == "rad" && axis.value_texts.size() > 2) return true;
  }
  return false;
}

Blocks operability_figures(const OperabilityResults& operability) {
  const std::vector<Figure> figures = {
      {"operability_chart", "Limit with the criterion met for every seed", {"chart"}},
      {"operability_rose", "The same by direction; circles are levels of the limit", {"rose"}},
      {"workability", "Fraction of the time below the limit, by month", {"months"}}};
  return figure_list(figures, [&](const Figure&, const std::string& part) {
    if (part == "rose") return has_headings(operability);
    if (part == "months") return operability.workability && operability.workability->months.size() == 12;
    return !operability.axes.empty();
  });
}

Blocks figures(const StudyResults& results) {
  Blocks all;
  if (results.operability) all += operability_figures(*results.operability);
  if (!results.cases.empty()) all += figure_list(make_figures(study_shape(results)));
  return block::section("figures", "Charts", all);
}

Json study_front(const StudyResults& results) {
  const std::string kind = results.analysis.empty() ? "Study" : "Study, " + results.analysis + " analyses";
  FrontPage page = make_front_page(kind, results.title, std::nullopt, results.findings);
  auto& entries = page.entries;
  if (!results.cases.empty()) entries.emplace_back("Cases", std::to_string(results.cases.size()));
  if (results.operability) entries.emplace_back("Analyses of the chart", std::to_string(results.operability->runs));
  if (results.wall_time > 0.0) entries.emplace_back("Computed in", readable_duration(results.wall_time));
  if (results.threads > 0) entries.emplace_back("Threads", std::to_string(results.threads));
  entries.emplace_back("Program", "Overbend " + results.version);
  entries.emplace_back("Written", written_now());
  Json front = front_page(page);
  if (!results.cases.empty()) front["verdict"] = verdict_json(study_verdict(results));
  return front;
}

}  // namespace

Document study_document(const StudyResults& stored) {
  const StudyResults results = convert_to_shown_units(stored);
  return {results.title + " - study",
          study_front(results),
          study_inputs_section(results) + figures(results) + operability_section(results) +
              study_extremes_section(results) + failed_cases_section(results) + study_cases_section(results) +
              assumptions_section(results.assumptions),
          {{"study", study_data(results)}}};
}

void write_study_report(const StudyResults& results, const std::filesystem::path& file) {
  write_page(study_document(results), file);
}

}  // namespace overbend
