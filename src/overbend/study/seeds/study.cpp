#include "study/seeds/study.h"

#include <algorithm>

#include "base/interruption.h"
#include "base/ranges.h"
#include "model/site/wave_groups.h"
#include "report/studies/comparison_page.h"
#include "resultfiles/dynamic/dynamic_reader.h"
#include "resultfiles/studies/comparison_writer.h"
#include "resultfiles/studies/seeds_writer.h"
#include "results/findings.h"
#include "runstore/staged_folder.h"
#include "study/run/run_folder.h"
#include "study/run/seeds_gather.h"
#include "study/seeds/compare_gather.h"
#include "study/seeds/compare_variants.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

/// Prepares the runs; cases of the same model share the preparation. Stops at the first that cannot be run.
RunResult prepare(const Description& base, const StudyPlan& plan, const fs::path& folder, std::vector<CaseRun>& runs) {
  const std::vector<fs::path> folders = case_folders(plan, folder);
  std::shared_ptr<const PreparedCase> prepared;
  for (std::size_t i = 0; i < plan.cases.size(); ++i) {
    const Case& study_case = plan.cases[i];
    if (i == 0 || !same_model(plan.cases[i - 1], study_case)) {
      std::variant<std::shared_ptr<const PreparedCase>, RunResult> made;
      try {
        const Description description = describe(base, study_case);
        const std::optional<RunResult> calm =
            study_case.controllers.empty() ? reject_calm_run(description) : std::nullopt;
        made = calm ? *calm : prepare_case(description, study_case.controllers);
      } catch (const std::runtime_error& error) {  // the text cannot be edited in this way
        return {RunStatus::wrong_input, error.what()};
      }
      if (const auto* error = std::get_if<RunResult>(&made)) return *error;
      prepared = std::move(std::get<std::shared_ptr<const PreparedCase>>(made));
    }
    runs.push_back(
        {study_case.name, prepared, study_case.seed.value_or(dynamic_options(prepared->model).seed), folders[i]});
  }
  return {};
}

/// Keeps the table with the higher governing utilisation.
void keep_worse(CheckTable& worst, CheckTable&& candidate) {
  const CheckRow *a = find_governing_check(worst), *b = find_governing_check(candidate);
  if (b != nullptr && (a == nullptr || b->utilisation > a->utilisation)) worst = std::move(candidate);
}

SeedsResults gather_seed_results(const std::vector<CaseRun>& runs, CheckTable& worst) {
  const PreparedCase& shared = *runs.front().prepared;
  SeedsResults results;
  results.build_up = shared.description.dynamics->build_up;
  results.quantities = seed_quantities(shared.statics, shared.description.fatigue.has_value());
  std::vector<std::vector<HistoryPeaks>> peaks;
  for (const CaseRun& run : runs) {
    if (run.end.ending != RunStatus::done) {
      results.failed.push_back({run.seed, run.end.why});
      continue;
    }
    const fs::path h5 = run.folder / "results.h5";
    DynamicResults read = read_dynamic_results(h5).results;
    peaks.push_back(find_run_peaks(h5));
    results.duration = read.duration;
    Findings findings = all_findings(shared.statics, read);
    const VerdictKind verdict = verdict_kind(read.checks, findings);
    results.runs.push_back({run.seed, run.name, seed_values(shared.statics, read, read.fatigue.has_value()),
                            std::move(findings), verdict});
    keep_worse(worst, std::move(read.checks));
  }
  fill_statistics(results);
  add_acer(results, peaks);
  if (!is_random(shared.description.environment.waves)) {
    results.findings.push_back({FindingCode::sea_not_random, "the sea is not random: all seeds give the same results"});
  }
  return results;
}

/// Calls `write` on a temporary folder, which then replaces the contents of the study's.
template <class Write>
void put(const fs::path& folder, const std::string& last, const StudyPlan& plan, Write write) {
  StagedFolder staged(folder);
  write(staged.path());
  std::vector<std::string> names;
  for (const Case& study_case : plan.cases) names.push_back(study_case.name);
  staged.commit(last, names);
}

void keep_record(const StudyOutcome& end, const StudyPlan& plan, const fs::path& folder) {
  change_record(folder, [&](RunRecord& record) {
    const bool seeds = plan.kind == StudyKind::seeds;
    record.kind = seeds ? "seeds" : "comparison";
    record.of = seeds ? "" : enum_name(plan.of);
    record.seeds.clear();
    for (const Case& study_case : plan.cases) {
      if (study_case.seed) record.seeds.push_back(*study_case.seed);
    }
    record.title = end.statics.title;
    record.duration = plan.cases.front().duration.value_or(0.0);
    record.state = RunState::done;
    record.progress = 1.0;
  });
}

void gather_seeds(StudyOutcome& end, const StudyPlan& plan, const std::vector<CaseRun>& runs, const fs::path& folder) {
  end.seeds = gather_seed_results(runs, end.worst);
  if (!end.failed.empty()) end.ending = RunStatus::no_solution;
  if (end.seeds->runs.empty()) return;
  put(folder, "summary.json", plan, [&](const fs::path& place) { write_seeds_files(end.statics, *end.seeds, place); });
  keep_record(end, plan, folder);
}

void gather_variants(StudyOutcome& end, const StudyPlan& plan, const std::vector<CaseRun>& runs, const fs::path& folder,
                     const Description& base) {
  if (!end.failed.empty()) {
    end.ending = RunStatus::no_solution;
    end.why = "no comparison is written";
    return;
  }
  std::vector<FinishedVariant> finished;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    finished.push_back({plan.cases[i].name, plan.cases[i].label, runs[i].folder});
  }
  end.comparison = gather_comparison(plan.of, runs.front().prepared->description, end.statics, finished);
  put(folder, "comparison.json", plan, [&](const fs::path& place) {
    write_comparison_files(end.statics, *end.comparison, place);
    write_comparison_page(end.statics, *end.comparison, base.source_text, place / "comparison.html");
  });
  keep_record(end, plan, folder);
}

/// True if every case failed because of its input.
bool all_wrong(const std::vector<CaseRun>& runs) {
  return ranges::all_of(runs, [](const CaseRun& run) { return run.end.ending == RunStatus::wrong_input; });
}

void gather(StudyOutcome& end, const StudyPlan& plan, const std::vector<CaseRun>& runs, const fs::path& folder,
            const Description& base) {
  if (all_wrong(runs)) {
    end.ending = RunStatus::wrong_input;
    end.why = runs.front().end.why;
    std::error_code ignored;
    if (fs::is_directory(folder, ignored)) fs::remove(folder, ignored);  // only if it is empty
    return;
  }
  for (const CaseRun& run : runs) {
    if (run.end.ending != RunStatus::done) end.failed.push_back({run.name, run.end.why});
  }
  if (plan.kind == StudyKind::seeds) return gather_seeds(end, plan, runs, folder);
  gather_variants(end, plan, runs, folder, base);
}

}  // namespace

namespace {

StudyOutcome run_to_end(const Description& base, const StudyPlan& plan, const fs::path& folder,
                        const CaseOptions& options, CaseObserver& watch, FileLock& files) {
  StudyOutcome end;
  std::vector<CaseRun> runs;
  static_cast<RunResult&>(end) = prepare(base, plan, folder, runs);
  if (end.ending != RunStatus::done) return end;
  end.statics = runs.front().prepared->statics;
  static_cast<RunResult&>(end) = run_cases(runs, options, watch, files);
  if (end.ending != RunStatus::done) return end;
  if (plan.kind == StudyKind::single) {
    const RunResult& ended = runs.front().end;
    static_cast<RunResult&>(end) = ended;
    end.single = std::move(runs.front());
    return end;
  }
  const std::lock_guard hold(files);
  try {
    gather(end, plan, runs, folder, base);
  } catch (const UnusableFolder& error) {  // the results of the cases stay, and a second attempt writes the missing
                                           // files
    static_cast<RunResult&>(end) = {RunStatus::wrong_input, error.what()};
  }
  return end;
}

}  // namespace

StudyOutcome run_study(const Description& base, const StudyPlan& plan, const fs::path& folder,
                       const CaseOptions& options, CaseObserver& watch, FileLock& files) {
  const InterruptionScope scope([&] { return watch.abandon(); });
  try {
    return run_to_end(base, plan, folder, options, watch, files);
  } catch (const Interrupted&) {  // before or after the runs
    StudyOutcome end;
    static_cast<RunResult&>(end) = {RunStatus::interrupted, "interrupted"};
    return end;
  }
}

}  // namespace overbend
