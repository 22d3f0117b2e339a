#include "serve/runs/study_json.h"

#include <utility>
#include <vector>

#include "base/finding.h"
#include "resultfiles/studies/seeds_writer.h"

namespace overbend {
namespace {

Json summary_of(const RunInfo& study, const std::filesystem::path& folder) {
  Json summary = read_json_file(folder / study_files(study).summary);
  const char* key = study.kind.c_str();
  if (!summary.is_object() || !summary.contains(key)) throw HttpFault(404, "the study has no results");
  return std::move(summary[key]);
}

/// Name, words and units of a quantity, and its value in every case.
Json quantity_json(const std::string& name, const Json& about, const Json& cases) {
  const ShownUnit unit = table_unit({name, about["units"].get<std::string>(), "", SeedExtreme::none});
  Json values = Json::array();
  for (const Json& one : cases) values.push_back(one.value(name, Json()));
  return {{"name", name},
          {"text", about["description"]},
          {"unit", unit.name},
          {"factor", unit.factor},
          {"values", std::move(values)}};
}

Json case_json(const RunInfo& study, const std::string& name, const std::string& words) {
  return {{"id", study.id + "~" + name}, {"name", name}, {"words", words}};
}

/// Those of the study as a whole, and what cases have in common once, with how many have it.
Json findings_json(const Json& cases, const Json& own) {
  std::vector<Findings> of_cases;
  for (const Json& one : cases) of_cases.push_back(read_findings(one["findings"]));
  Json list = Json::array();
  const auto add = [&](const Finding& finding, const std::string& message, std::size_t number) {
    Json json = finding_json(finding);
    json["message"] = message;
    json["cases"] = number;
    list.push_back(std::move(json));
  };
  for (const Finding& finding : read_findings(own)) add(finding, finding.message, cases.size());
  for (const SharedFinding& one : shared_findings(of_cases)) add(one.worst, one.text(), one.runs.size());
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
  if (!study.is_study()) throw HttpFault(404, "the run has no cases");
  const Json summary = summary_of(study, folder);
  return study.kind == "seeds" ? seeds_json(study, summary) : comparison_json(study, summary);
}

}  // namespace overbend
