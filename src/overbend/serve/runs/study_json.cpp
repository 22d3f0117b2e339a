#include "serve/runs/study_json.h"

#include <utility>
#include <vector>

#include "base/finding.h"
#include "resultfiles/studies/seeds_writer.h"

namespace overbend {
namespace {

Json read_study_summary(const RunInfo& study, const std::filesystem::path& folder) {
  Json summary = read_json_file(folder / study_files(study).summary);
  const char* key = study.kind.c_str();
  if (!summary.is_object() || !summary.contains(key)) throw HttpError(404, "the study has no results");
  return std::move(summary[key]);
}

/// Returns name, description and units of a quantity, and its value in every case.
Json quantity_json(const std::string& name, const Json& about, const Json& cases) {
  const ShownUnit unit = table_unit({name, about["units"].get<std::string>(), "", SeedExtreme::none});
  Json values = Json::array();
  for (const Json& case_values : cases) values.push_back(case_values.value(name, Json()));
  return {{"name", name},
          {"text", about["description"]},
          {"unit", unit.name},
          {"factor", unit.factor},
          {"values", std::move(values)}};
}

Json case_json(const RunInfo& study, const std::string& name, const std::string& label) {
  return {{"id", study.id + "~" + name}, {"name", name}, {"words", label}};
}

/// Returns the findings of the study, and those of its cases merged, with the number of cases that have them.
Json findings_json(const Json& cases, const Json& study_findings) {
  std::vector<Findings> of_cases;
  for (const Json& study_case : cases) of_cases.push_back(read_findings(study_case["findings"]));
  Json list = Json::array();
  const auto add = [&](const Finding& finding, const std::string& message, std::size_t number) {
    Json json = finding_json(finding);
    json["message"] = message;
    json["cases"] = number;
    list.push_back(std::move(json));
  };
  for (const Finding& finding : read_findings(study_findings)) add(finding, finding.message, cases.size());
  for (const SharedFinding& shared : shared_findings(of_cases)) add(shared.worst, shared.text(), shared.runs.size());
  return list;
}

Json seeds_json(const RunInfo& study, const Json& seeds) {
  Json cases = Json::array(), quantities = Json::array();
  for (const Json& run : seeds["runs"]) {
    const std::string number = std::to_string(run["seed"].get<std::uint64_t>());
    cases.push_back(case_json(study, run["folder"], "Seed " + number));
  }
  for (const auto& [name, statistics] : seeds["statistics"].items()) {
    Json quantity = quantity_json(name, statistics, seeds["runs"]);
    for (const char* value : {"mean", "std", "min", "max"}) quantity[value] = statistics[value];
    quantity["gumbel"] = statistics.value("gumbel", Json());
    quantity["acer"] = statistics.value("acer", Json());
    quantities.push_back(std::move(quantity));
  }
  return {{"kind", "seeds"},
          {"cases", std::move(cases)},
          {"quantities", std::move(quantities)},
          {"findings", findings_json(seeds["runs"], seeds["findings"])}};
}

Json comparison_json(const RunInfo& study, const Json& comparison) {
  Json cases = Json::array(), quantities = Json::array();
  for (const Json& variant : comparison["variants"]) {
    cases.push_back(case_json(study, variant["name"], variant["words"]));
  }
  for (const auto& [name, about] : comparison["quantities"].items()) {
    quantities.push_back(quantity_json(name, about, comparison["variants"]));
  }
  return {{"kind", "comparison"},
          {"of", comparison["of"]},
          {"cases", std::move(cases)},
          {"quantities", std::move(quantities)},
          {"findings", findings_json(comparison["variants"], Json::array())}};
}

}  // namespace

StudyFiles study_files(const RunInfo& study) {
  if (study.kind == "comparison") return {"comparison.json", "comparison.csv", "comparison.html"};
  return {"summary.json", "seeds.csv", ""};
}

Json study_json(const RunInfo& study, const std::filesystem::path& folder) {
  if (!study.is_study()) throw HttpError(404, "the run has no cases");
  const Json summary = read_study_summary(study, folder);
  return study.kind == "seeds" ? seeds_json(study, summary) : comparison_json(study, summary);
}

}  // namespace overbend
