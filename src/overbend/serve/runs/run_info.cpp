#include "serve/runs/run_info.h"

#include <algorithm>
#include <chrono>

#include "base/file_time.h"
#include "base/ranges.h"
#include "report/page/json_number.h"
#include "runstore/run_store.h"
#include "runstore/staged_folder.h"
#include "study/seeds/compare_variants.h"
#include "study/seeds/study.h"

namespace overbend {
namespace fs = std::filesystem;
namespace {

double modified(const fs::path& file) {
  std::error_code error;
  return seconds_since_1970(fs::last_write_time(file, error));
}

/// True if the results are those of a cancelled run, which still has a checkpoint.
bool was_cancelled(const RunInfo& run, const fs::path& folder) {
  std::error_code error;
  return run.state == RunState::cancelled && fs::exists(folder / ".run", error);
}

/// Completes the record from the summary, for folders without a record or with that of an older program.
void complete_from_summary(RunInfo& run, const Json& summary) {
  run.title = summary.value("title", "");
  run.kind = summary.contains("comparison") ? "comparison"
             : summary.contains("seeds")    ? "seeds"
             : summary.contains("dynamic")  ? "dynamic"
                                            : "static";
  if (run.kind == "comparison") run.of = summary["comparison"].value("of", "");
  if (run.kind != "seeds" || !run.seeds.empty()) return;
  for (const char* list : {"runs", "failed"}) {
    for (const Json& seed : summary["seeds"][list]) run.seeds.push_back(seed["seed"].get<std::uint64_t>());
  }
}

std::optional<RunInfo> find_run(const fs::path& folder) {
  std::error_code none;
  const fs::path compared = folder / "comparison.json";
  const fs::path gathered = folder / kStudyFolder / "summary.json";
  const fs::path summary_file = fs::exists(compared, none)   ? compared
                                : fs::exists(gathered, none) ? gathered
                                                             : folder / "summary.json";
  const std::optional<RunRecord> record = read_record(folder);
  const Json summary = read_json_file(summary_file);
  if (!record && !summary.is_object()) return std::nullopt;
  RunInfo run;
  run.id = folder.filename().string();
  if (record) static_cast<RunRecord&>(run) = *record;
  if (summary.is_object()) {
    if (!run.is_campaign()) complete_from_summary(run, summary);
    run.has_results = true;
    add_verdict(run, summary);
    if (!was_cancelled(run, folder)) {
      run.state = RunState::done;
      run.progress = 1.0;
    }
    if (run.started == 0.0) run.started = modified(summary_file);
  } else if (!run.ended()) {
    run.state = RunState::cancelled;
    run.message = "the program ended before the run started";
  }
  run.resumable = run.state != RunState::done && can_be_resumed(run, folder.parent_path());
  return run;
}

/// Returns the cases with the state found in their folders.
std::vector<RunInfo> find_cases(const RunInfo& study, const fs::path& runs) {
  std::vector<RunInfo> cases = make_study_cases(study);
  for (RunInfo& case_run : cases) {
    case_run.state = RunState::cancelled;
    std::optional<RunInfo> found = find_run(find_run_folder(case_run, runs));
    if (!found) continue;
    found->id = case_run.id;
    found->parent = case_run.parent;
    found->title = case_run.title;
    found->model_path = case_run.model_path;
    found->started = case_run.started;
    found->resumable = false;  // only the study can be resumed
    case_run = std::move(*found);
  }
  return cases;
}

bool has_checkpoint(const fs::path& folder) {
  const std::optional<StoredRun> stored = RunStore::find(folder);
  return stored && stored->error.empty();
}

}  // namespace

std::vector<RunInfo> make_study_cases(const RunInfo& study) {
  std::vector<Case> cases;
  if (study.kind == "seeds") cases = seed_cases(study.seeds);
  if (study.kind == "comparison") {
    cases = make_variants(from_enum_name<ComparisonType>(study.of).value_or(ComparisonType::tensioner));
  }
  std::vector<RunInfo> list;
  for (const Case& study_case : cases) {
    RunInfo run;
    run.id = study.id + "~" + study_case.name;
    run.parent = study.id;
    run.kind = "dynamic";
    run.title = study_case.label;
    run.model_path = study.model_path;
    run.started = study.started;
    list.push_back(std::move(run));
  }
  return list;
}

fs::path find_run_folder(const RunInfo& run, const fs::path& runs) {
  return run.parent.empty() ? runs / run.id : runs / run.parent / run.id.substr(run.parent.size() + 1);
}

Json run_json(const RunInfo& run) {
  Json json = {{"id", run.id},
               {"parent", run.parent},
               {"title", run.title},
               {"kind", run.kind},
               {"of", run.of},
               {"state", word(run.state)},
               {"progress", seven_digits(run.progress)},
               {"started", run.started},
               {"message", run.message},
               {"name", run.name},
               {"note", run.note},
               {"changed", run.changed},
               {"has_results", run.has_results},
               {"resumable", run.resumable},
               {"duration", seven_digits(run.duration)}};
  if (!run.verdict.empty()) json["verdict"] = {{"kind", run.verdict}, {"words", run.verdict_text}};
  if (run.utilisation) json["utilisation"] = seven_digits(*run.utilisation);
  if (run.live_progress) {
    json["time"] = seven_digits(run.live_progress->time);
    json["end"] = seven_digits(run.live_progress->end);
    json["top_tension"] = seven_digits(run.live_progress->top_tension);
    json["worst_stress"] = seven_digits(run.live_progress->worst_stress);
  }
  return json;
}

void add_verdict(RunInfo& run, const Json& summary) {
  const Json& judged = summary.contains("dynamic") ? summary["dynamic"] : summary;
  if (judged.contains("verdict")) {
    run.verdict = judged["verdict"].value("kind", "");
    run.verdict_text = judged["verdict"].value("words", "");
  }
  const Json::json_pointer worst("/checks/worst/utilisation");
  if (judged.contains(worst) && judged[worst].is_number()) run.utilisation = judged[worst].get<double>();
}

void read_verdict(RunInfo& run, const fs::path& folder) {
  const Json summary = read_json_file(folder / "summary.json");
  if (summary.is_object()) add_verdict(run, summary);
}

bool can_be_resumed(const RunInfo& run, const fs::path& runs) {
  std::error_code ignored;
  if (!fs::exists(find_run_folder(run, runs) / kModelCopy, ignored)) return false;
  if (run.is_campaign()) return fs::exists(find_run_folder(run, runs) / kStudyFolder, ignored);
  if (!run.is_study()) return has_checkpoint(find_run_folder(run, runs));
  return ranges::any_of(make_study_cases(run), [&](const RunInfo& case_run) {
    const fs::path folder = find_run_folder(case_run, runs);
    const std::optional<RunRecord> record = read_record(folder);
    return has_checkpoint(folder) || (record && !record->input.empty());
  });
}

double seconds_since_1970() {
  const auto since_epoch = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<double>(std::chrono::duration_cast<std::chrono::seconds>(since_epoch).count());
}

void keep_record(const RunInfo& run, const fs::path& folder) {
  change_record(folder, [&](RunRecord& record) {
    const std::string input = std::move(record.input), program = std::move(record.program);
    const RunRecord& current = run;
    record = current;
    record.input = input;
    record.program = program;
  });
}

std::vector<RunInfo> find_runs(const fs::path& folder) {
  std::vector<RunInfo> runs;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (!entry.is_directory(error)) continue;
    clear_leftovers(entry.path());  // of a killed program; no program writes into an old run
    try {
      const std::optional<RunInfo> run = find_run(entry.path());
      if (!run) continue;
      const std::vector<RunInfo> cases = find_cases(*run, folder);
      runs.push_back(*run);
      runs.insert(runs.end(), cases.begin(), cases.end());
    } catch (const std::exception&) {
      continue;  // not a valid results file
    }
  }
  return runs;
}

}  // namespace overbend
