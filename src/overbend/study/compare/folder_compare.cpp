#include "study/compare/folder_compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/json.h"
#include "base/ranges.h"
#include "modelfile/yaml/model_differences.h"
#include "resultfiles/dynamic/dynamic_reader.h"
#include "resultfiles/stages/operation_reader.h"
#include "results/fields/check_fields.h"
#include "results/findings.h"
#include "study/compare/dynamic_values.h"
#include "study/compare/folder_figures.h"
#include "study/compare/moored_values.h"
#include "study/sensitivity/result_values.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

/// Contents read from a folder.
struct Read {
  ComparedFolder folder;
  std::string model_text;
  std::vector<ResultValue> values;
  FolderCurves curves;
};

const char* kind_label(ResultsKind kind) {
  switch (kind) {
    case ResultsKind::statics:
      return "a static analysis";
    case ResultsKind::dynamics:
      return "a dynamic analysis";
    case ResultsKind::seeds:
      return "several seeds";
    default:
      return "a lay operation";
  }
}

Json read_summary(const fs::path& folder) {
  return read_json_file(folder / "summary.json");
}

/// Utilisations by the names of the checks: their positions in lists depend on the model.
void take_checks(Read& read, const std::string& front, const CheckTable& checks) {
  for (const CheckRow& row : checks.rows) {
    if (!row.judged()) continue;
    const std::string where = word(row.region);
    read.values.push_back({fmt::format("{}checks.{}[{}].utilisation", front, row.id, where),
                           row.name + ", " + row.code + ", " + where, "1", row.utilisation, false});
  }
}

void append(std::vector<ResultValue>& values, std::vector<ResultValue>&& more) {
  ranges::move(more, std::back_inserter(values));
}

void take_pipe(Read& read, const StaticResults& results) {
  if (const CheckRow* worst = find_governing_check(results.checks)) read.folder.governing = worst->name;
  read.values = result_values(results);
  std::erase_if(read.values, [](const ResultValue& value) { return value.name.starts_with("checks.list["); });
  take_checks(read, "", results.checks);
  add_curves(read.curves, results);
}

void take_statics(Read& read, const StoredStatics& stored) {
  read.model_text = stored.model_text;
  read.folder.title = stored.results.title;
  read.folder.version = stored.results.version;
  read.folder.findings = stored.results.findings;
  if (stored.results.has_pipe()) take_pipe(read, stored.results);
  if (stored.results.moorings) append(read.values, mooring_values(*stored.results.moorings));
}

void take_dynamics(Read& read, const fs::path& h5) {
  const StoredDynamics stored = read_dynamic_results(h5);
  take_statics(read, stored.statics);
  if (stored.statics.results.has_pipe()) append(read.values, dynamic_values(stored.statics.results, stored.results));
  append(read.values, moored_dynamic_values(stored.results));
  take_checks(read, "dynamic.", stored.results.checks);
  read.folder.findings = all_findings(stored.statics.results, stored.results);
  if (const CheckRow* worst = find_governing_check(stored.results.checks)) read.folder.governing = worst->name;
  add_curves(read.curves, stored.statics.results, stored.results);
}

void take_run(Read& read, const fs::path& h5) {
  if (has_dynamic(h5)) {
    read.folder.kind = ResultsKind::dynamics;
    take_dynamics(read, h5);
  } else {
    take_statics(read, read_static_results(h5));
  }
}

/// Key values of the stages that have results.
void take_operation(Read& read, const fs::path& h5) {
  const StoredOperation stored = read_operation_results(h5);
  read.model_text = stored.model_text;
  read.folder.title = stored.results.title;
  read.folder.version = stored.results.version;
  read.folder.findings = operation_findings(stored.results);
  for (const StageResult& stage : stored.results.stages) {
    if (!stage.lay) continue;
    for (ResultValue value : result_values(*stage.lay)) {
      if (!value.key) continue;
      value.name = "operation.stages[" + stage.stage.name + "]." + value.name;
      value.text = stage.stage.name + ": " + value.text;
      read.values.push_back(std::move(value));
    }
  }
}

void take_seeds(Read& read, const fs::path& folder, const Json& summary) {
  const Json& seeds = summary["seeds"];
  for (const Json& run : seeds["runs"]) {
    read.folder.findings = merge(std::move(read.folder.findings), read_findings(run["findings"]));
  }
  if (seeds["runs"].empty()) throw std::runtime_error(folder.string() + ": none of its seeds has results");
  const fs::path first = folder / seeds["runs"][0]["folder"].get<std::string>() / "results.h5";
  const Findings findings = read.folder.findings;
  take_statics(read, read_static_results(first));
  read.folder.findings.insert(read.folder.findings.end(), findings.begin(), findings.end());
  for (const auto& item : seeds["statistics"].items()) {
    const std::string& name = item.key();
    const Json& statistics = item.value();
    const auto put = [&](const std::string& part, const std::string& label, const Json& value) {
      if (!value.is_number()) return;
      read.values.push_back({fmt::format("seeds.statistics.{}.{}", name, part),
                             statistics["description"].get<std::string>() + ", " + label,
                             statistics["units"].get<std::string>(), value.get<double>(), part == "mean"});
    };
    put("mean", "mean over the seeds", statistics["mean"]);
    put("max", "largest of the seeds", statistics["max"]);
    put("min", "smallest of the seeds", statistics["min"]);
    for (const char* fit : {"gumbel", "acer"}) {
      if (!statistics.contains(fit) || !statistics[fit].is_object()) continue;
      const std::string label = fit == std::string("acer") ? "three hours by ACER" : "three hours by Gumbel";
      put(std::string(fit) + ".estimate", label, statistics[fit]["estimate"]);
    }
  }
}

Read read_folder(const fs::path& place) {
  const fs::path folder = fs::is_directory(place) ? place : place.parent_path();
  Read read;
  read.folder.path = place.string();
  const Json summary = read_summary(folder);
  if (summary.is_object() && summary.contains("seeds")) {
    read.folder.kind = ResultsKind::seeds;
    take_seeds(read, folder, summary);
    return read;
  }
  const fs::path h5 = fs::is_directory(place) ? place / "results.h5" : place;
  if (!fs::exists(h5)) throw std::runtime_error(place.string() + ": no results.h5 in it, nothing to compare");
  try {
    if (has_lay_operation(h5)) {
      read.folder.kind = ResultsKind::operation;
      take_operation(read, h5);
    } else {
      take_run(read, h5);
    }
  } catch (const std::runtime_error& error) {
    const std::string what = error.what();
    throw std::runtime_error(what.find(h5.string()) == std::string::npos ? place.string() + ": " + what : what);
  }
  return read;
}

/// Names the folders by as few final parts of their paths as distinguish them.
void name_folders(std::vector<Read>& all) {
  const auto last_parts = [](const std::string& path, std::size_t count) {
    fs::path full = fs::absolute(path).lexically_normal(), name;
    if (!full.has_filename()) full = full.parent_path();
    for (std::size_t i = 0; i < count && full.has_filename(); ++i, full = full.parent_path()) {
      name = name.empty() ? full.filename() : full.filename() / name;
    }
    return name.string();
  };
  for (std::size_t parts = 1; parts < 12; ++parts) {
    for (Read& read : all) read.folder.name = last_parts(read.folder.path, parts);
    const bool apart = ranges::all_of(all, [&](const Read& read) {
      return ranges::count_if(all, [&](const Read& candidate) { return candidate.folder.name == read.folder.name; }) ==
             1;
    });
    if (apart) return;
  }
}

std::vector<ComparedKey> compared_keys(const std::vector<Read>& all) {
  std::vector<std::string> texts;
  for (const Read& read : all) texts.push_back(read.model_text);
  std::vector<ComparedKey> keys;
  for (DifferingKey& key : differing_keys(texts)) keys.push_back({std::move(key.key), std::move(key.values)});
  return keys;
}

std::vector<ComparedResult> compared_results(const std::vector<Read>& all) {
  std::vector<ComparedResult> results;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const ResultValue& value : all[i].values) {
      auto found = ranges::find_if(results, [&](const auto& known) { return known.name == value.name; });
      if (found == results.end()) {
        results.push_back({value.name, value.text, value.unit, value.key, {}});
        results.back().values.resize(all.size());
        found = std::prev(results.end());
      }
      if (std::isfinite(value.value)) found->values[i] = value.value;
    }
  }
  // Results of one folder only cannot be compared.
  std::erase_if(results, [](const ComparedResult& result) {
    return ranges::count_if(result.values, [](const auto& value) { return value.has_value(); }) < 2;
  });
  ranges::stable_sort(results, std::greater<>(), &ComparedResult::max_relative_change);
  return results;
}

std::vector<std::string> make_notes(const std::vector<Read>& all) {
  const bool mixed = ranges::any_of(all, [&](const Read& read) { return read.folder.kind != all.front().folder.kind; });
  if (!mixed) return {};
  std::string kinds;
  for (const Read& read : all) {
    kinds += (kinds.empty() ? "" : "; ") + read.folder.name + " is " + kind_label(read.folder.kind);
  }
  return {"The folders hold results of different analyses (" + kinds +
          "). Only results that at least two of them have are compared; for dynamic analyses and seeds this includes "
          "their static state."};
}

}  // namespace

FolderComparison compare_folders(const std::vector<fs::path>& folders) {
  std::vector<Read> all;
  for (const fs::path& folder : folders) all.push_back(read_folder(folder));
  name_folders(all);
  FolderComparison comparison;
  comparison.keys = compared_keys(all);
  comparison.results = compared_results(all);
  comparison.notes = make_notes(all);
  std::vector<FolderCurves> curves;
  for (Read& read : all) {
    comparison.folders.push_back(std::move(read.folder));
    curves.push_back(std::move(read.curves));
  }
  comparison.figures = overlaid(curves);
  if (comparison.results.empty()) {
    throw std::runtime_error(comparison.folders.at(0).path + " and the others have no result in common");
  }
  return comparison;
}

}  // namespace overbend
