#include "resultfiles/studies/seeds_writer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "resultfiles/hdf5/missing_values.h"
#include "resultfiles/static/results_writer.h"
#include "resultfiles/summary/summary_json.h"
#include "resultfiles/tables/csv_fields.h"
#include "results/result_enum_names.h"
#include "results/verdict_order.h"
#include "runstore/append_file.h"

namespace overbend {
namespace {

Json statistics_json(const SeedQuantity& quantity, const SeedStatistics& s) {
  Json json = {{"units", quantity.units},
               {"description", quantity.description},
               {"mean", s.mean},
               {"std", s.std},
               {"min", s.min},
               {"max", s.max}};
  if (quantity.extreme == SeedExtreme::none) return json;
  json["gumbel"] = nullptr;
  if (s.enough) {
    json["gumbel"] = {{"mode", s.mode}, {"scale", s.scale}, {"estimate", s.estimate}, {"low", s.low}, {"high", s.high}};
  }
  json["acer"] = nullptr;
  if (s.acer) {
    json["acer"] = {{"estimate", s.acer->estimate},
                    {"low", s.acer->low},
                    {"high", s.acer->high},
                    {"order", s.acer->order},
                    {"peaks", s.acer->peaks}};
  }
  return json;
}

Json run_json(const SeedRun& run, const std::vector<SeedQuantity>& quantities) {
  Json json = {{"seed", run.seed}, {"folder", run.folder}};
  for (std::size_t i = 0; i < quantities.size(); ++i) json[quantities[i].name] = run.values.at(i);
  json["warnings"] = messages(run.findings);
  json["findings"] = findings_json(run.findings);
  json["verdict"] = word(run.verdict);
  return json;
}

}  // namespace

void require_finite(const SeedsResults& results) {
  for (const SeedRun& run : results.runs) {
    for (std::size_t i = 0; i < results.quantities.size(); ++i) {
      if (std::isnan(run.values.at(i)) && may_be_missing(results.quantities[i].name)) continue;
      if (!std::isfinite(run.values.at(i))) {
        throw std::runtime_error(run.folder + ": " + results.quantities[i].name + " is not finite");
      }
    }
  }
}

ShownUnit table_unit(const SeedQuantity& quantity) {
  ShownUnit unit = shown_unit(quantity.name, quantity.units);
  if (unit.name.empty()) unit.name = "-";
  return unit;
}

VerdictKind worst_verdict(const SeedsResults& results) {
  VerdictKind worst = results.runs.empty() || !results.failed.empty() ? VerdictKind::not_judged : VerdictKind::passed;
  for (const SeedRun& run : results.runs) worst = std::max(worst, run.verdict, less_severe);
  return worst;
}

Json seeds_json(const SeedsResults& results) {
  Json runs = Json::array(), failed = Json::array(), over_seeds = Json::object();
  for (const SeedRun& run : results.runs) runs.push_back(run_json(run, results.quantities));
  for (const FailedSeed& seed : results.failed) failed.push_back({{"seed", seed.seed}, {"why", seed.why}});
  for (std::size_t i = 0; i < results.statistics.size(); ++i) {
    over_seeds[results.quantities.at(i).name] = statistics_json(results.quantities[i], results.statistics[i]);
  }
  return {{"duration", results.duration},
          {"build_up", results.build_up},
          {"runs", runs},
          {"failed", failed},
          {"statistics", over_seeds},
          {"warnings", messages(results.findings)},
          {"findings", findings_json(results.findings)},
          {"verdict", word(worst_verdict(results))}};
}

std::string seeds_summary(const StaticResults& statics, const SeedsResults& results) {
  Json summary = static_summary_json(statics);
  summary["seeds"] = seeds_json(results);
  return summary_text(summary);
}

std::string seeds_table(const SeedsResults& results) {
  std::vector<std::string> head = {"seed", "folder", "status"};
  std::vector<double> factors;
  for (const SeedQuantity& quantity : results.quantities) {
    const ShownUnit unit = table_unit(quantity);
    head.push_back(headed(quantity.name, unit.name));
    factors.push_back(unit.factor);
  }
  CsvTable table(head);
  for (const SeedRun& run : results.runs) {
    table.cell(std::to_string(run.seed)).cell(run.folder).cell(std::string("done"));
    for (std::size_t i = 0; i < factors.size(); ++i) table.cell(run.values.at(i) * factors[i]);
    table.end_row();
  }
  for (const FailedSeed& seed : results.failed) {
    table.cell(std::to_string(seed.seed)).cell(std::string()).cell("failed: " + seed.why);
    for (std::size_t i = 0; i < factors.size(); ++i) table.cell(std::string());
    table.end_row();
  }
  return table.text();
}

void write_seeds_files(const StaticResults& statics, const SeedsResults& results, const std::filesystem::path& folder) {
  require_finite(results);
  write_text(folder / "seeds.csv", seeds_table(results));
  write_text(folder / "summary.json", seeds_summary(statics, results));
}

}  // namespace overbend
