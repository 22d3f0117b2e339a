#include "study/cases/case_evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "base/interruption.h"
#include "base/ranges.h"
#include "checks/run_checks.h"
#include "dynamics/integrator/dynamics.h"
#include "modelfile/reading/seek_reader.h"
#include "resultfiles/static/case_summary.h"
#include "resultfiles/studies/seek_writer.h"
#include "results/findings.h"
#include "results/governing_stage.h"
#include "runstore/append_file.h"
#include "runstore/run_store.h"
#include "runstore/staged_folder.h"
#include "study/goal_seek/seek_run.h"
#include "study/run/dynamic_realisation.h"
#include "study/run/early_termination.h"
#include "study/run/static_analysis.h"
#include "study/stages/lay_operation.h"

namespace overbend {
namespace {

using SteadyClock = std::chrono::steady_clock;

CaseResult ended(RunStatus how, std::string why) {
  return {{how, std::move(why)}};
}

std::unique_lock<FileLock> lock_files(FileLock* files) {
  return files != nullptr ? std::unique_lock(*files) : std::unique_lock<FileLock>();
}

void judge(const CheckTable& checks, const Findings& findings, CaseResult& answer) {
  answer.verdict = verdict_kind(checks, findings);
  answer.findings = findings;
  const CheckRow* worst = find_governing_check(checks);
  if (worst == nullptr) return;
  answer.governing = worst->name;
  answer.utilisation = worst->utilisation;
}

CaseResult evaluate_statics(const CaseBase& base, const CaseInput& question, CaseWarmStart& neighbour,
                            const CaseEvaluationOptions& conduct) {
  neighbour.found.reset();
  const Description description = base.described(question.keys, !conduct.keep);
  Model model = build_model(description);
  // Files that are kept are those of a cold start.
  std::vector<const LayWarmStart*> starts = {neighbour.start.get(), neighbour.fallback_start.get()};
  if (conduct.keep) starts.clear();
  StaticRun found = solve_with_warm_starts(model, starts, &neighbour.found);
  if (found.failure) return {failure_result(*found.failure, description)};
  CaseResult answer;
  add_hull_results(model, *found.results);
  judge(found.results->checks, found.results->findings, answer);
  answer.summary = static_summary_json(*found.results);
  if (conduct.keep) {
    const auto hold = lock_files(conduct.files);
    write_static_run(*found.results, description, conduct.folder);
  }
  return answer;
}

CaseResult evaluate_dynamics(const CaseBase& base, const CaseInput& question, CaseWarmStart& neighbour,
                             const CaseEvaluationOptions& conduct) {
  if (RunResult end = prepare_warm_start(base, question, neighbour); end.ending != RunStatus::done) return {end};
  const PreparedCase& prepared = *neighbour.prepared;
  const std::uint64_t seed = question.seed.value_or(dynamic_options(prepared.model).seed);
  SteadyClock::time_point last = SteadyClock::now();
  const double from = -prepared.description.dynamics->build_up;
  EarlyTermination exceeded_early(prepared.model, prepared.statics);
  bool exceeded = false;
  const auto control = [&](const DynamicProgress& progress) {
    if (conduct.progress) conduct.progress(progress, from);
    if (conduct.stop && conduct.stop()) return DynamicControl::stop;
    if (conduct.until_exceeded && exceeded_early(progress)) {
      exceeded = true;
      return DynamicControl::stop;
    }
    if (std::chrono::duration<double>(SteadyClock::now() - last).count() < conduct.checkpoint_every) {
      return DynamicControl::go_on;
    }
    last = SteadyClock::now();
    return DynamicControl::checkpoint;
  };
  FileLock local_lock;
  const RunFiles files = conduct.keep ? RunFiles::all : RunFiles::none;
  RealisationResult end = run_realisation(prepared, conduct.folder, seed, true, control,
                                          conduct.files != nullptr ? *conduct.files : local_lock, {}, files);
  if (exceeded && end.ending == RunStatus::interrupted) {  // there is nothing to resume
    static_cast<RunResult&>(end) = {};
    keep_irreversible_checks(end.results->checks);
    if (auto left = RunStore::resume(conduct.folder, prepared.input, seed)) left->store.remove();
  }
  CaseResult answer{static_cast<const RunResult&>(end)};
  if (end.ending != RunStatus::done) return answer;
  judge(end.results->checks, all_findings(prepared.statics, *end.results), answer);
  answer.peaks = std::move(end.peaks);
  answer.summary = dynamic_summary_json(prepared.statics, *end.results);
  return answer;
}

/// Summary of all stages, with the worst stage as a static lay.
Json worst_stage_summary(const OperationResults& results) {
  Json summary = operation_summary_json(results);
  const StageResult* worst = find_governing_stage(results);
  const Json& stages = summary["operation"]["stages"];
  for (std::size_t i = 0; i < results.stages.size(); ++i) {
    const StageResult& stage = results.stages[i];
    if (!stage.lay || (worst != nullptr && worst != &stage)) continue;
    summary["static"] = stages[i];
    summary["checks"] = stages[i]["checks"];
    break;
  }
  return summary;
}

/// Judges by the worst stage; exceeded if some stages have no solution. Returns the reason of the first of them.
std::string judge_stages(const OperationResults& results, CaseResult& answer) {
  judge(operation_checks(results), operation_findings(results), answer);
  answer.summary = worst_stage_summary(results);
  const auto failed = ranges::find_if(results.stages, [](const StageResult& stage) { return !stage.lay; });
  if (failed == results.stages.end()) return "";
  answer.verdict = VerdictKind::exceeded;
  return fmt::format("no equilibrium at stage {}: {}", failed->stage.name, failed->failure->why);
}

CaseResult evaluate_operation(const CaseBase& base, const CaseInput& question, const CaseEvaluationOptions& conduct) {
  const Description description = base.described(question.keys, false);
  if (const auto unsupported = unsupported_in_operation(description)) {
    return {failure_result(*unsupported, description)};
  }
  bool stopped = false;
  const OperationResults results = solve_operation(description, [&](const StageResult&, std::size_t) {
    stopped = conduct.stop && conduct.stop();
    return !stopped;
  });
  if (stopped) return ended(RunStatus::interrupted, "interrupted");
  CaseResult answer;
  const std::string failed = judge_stages(results, answer);
  if (ranges::none_of(results.stages, [](const StageResult& stage) { return stage.lay.has_value(); })) {
    return ended(RunStatus::no_solution, "no solution: " + failed);
  }
  if (conduct.keep) {
    const auto hold = lock_files(conduct.files);
    write_operation_run(results, description, conduct.folder);
  }
  return answer;
}

CaseResult evaluate_seek(const CaseBase& base, const CaseInput& question, const CaseEvaluationOptions& conduct) {
  const Description description = base.described(question.keys, false);
  const std::optional<SeekDescription> wanted = read_seek(description);
  if (!wanted) return ended(RunStatus::wrong_input, "the base model has no key seek");
  const SeekRun run = run_seek(description, *wanted);
  if (!run.results.found) return ended(RunStatus::no_solution, "no solution: " + run.results.why);
  CaseResult answer;
  if (run.operation) {
    judge_stages(*run.operation, answer);
  } else {
    judge(run.statics.results->checks, run.statics.results->findings, answer);
    answer.summary = static_summary_json(*run.statics.results);
  }
  answer.summary["seek"] = seek_json(run.results);
  if (conduct.keep) {
    const auto hold = lock_files(conduct.files);
    write_seek_run(run, description, conduct.folder);
  }
  return answer;
}

CaseResult evaluate_analysis(const CaseBase& base, const CaseInput& question, CaseWarmStart& neighbour,
                             const CaseEvaluationOptions& conduct) {
  switch (base.study().analysis) {
    case StudyAnalysis::statics:
      return evaluate_statics(base, question, neighbour, conduct);
    case StudyAnalysis::dynamic:
      return evaluate_dynamics(base, question, neighbour, conduct);
    case StudyAnalysis::operation:
      return evaluate_operation(base, question, conduct);
    case StudyAnalysis::seek:
      break;
  }
  return evaluate_seek(base, question, conduct);
}

}  // namespace

std::shared_ptr<const LayWarmStart> base_start(const CaseBase& base) {
  std::shared_ptr<const LayWarmStart> found;
  try {
    Model model = build_model(base.model());
    solve_with_warm_starts(model, {}, &found);
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception&) {  // the cases report the errors
  }
  return found;
}

RunResult prepare_warm_start(const CaseBase& base, const CaseInput& question, CaseWarmStart& neighbour) {
  if (neighbour.prepared && neighbour.keys == question.keys) return {};
  try {
    const Description description = base.described(question.keys, false);
    if (const std::optional<RunResult> calm = reject_calm_run(description)) return *calm;
    auto made = prepare_case(description);
    if (const RunResult* error = std::get_if<RunResult>(&made)) return *error;
    neighbour.prepared = std::get<std::shared_ptr<const PreparedCase>>(std::move(made));
    neighbour.keys = question.keys;
    return {};
  } catch (const std::runtime_error& error) {
    return {RunStatus::wrong_input, error.what()};
  }
}

CaseResult evaluate_case(const CaseBase& base, const CaseInput& question, CaseWarmStart& neighbour,
                         const CaseEvaluationOptions& conduct) {
  const InterruptionScope scope(conduct.abandon ? conduct.abandon : conduct.stop);
  try {
    return evaluate_analysis(base, question, neighbour, conduct);
  } catch (const Interrupted&) {
    return ended(RunStatus::interrupted, "interrupted");
  } catch (const FileError& error) {
    return ended(RunStatus::error, error.what());
  } catch (const UnusableFolder& error) {
    return ended(RunStatus::error, error.what());
  } catch (const std::runtime_error& error) {
    return ended(RunStatus::wrong_input, error.what());
  } catch (const std::exception& error) {
    return ended(RunStatus::error, std::string("internal error: ") + error.what());
  }
}

}  // namespace overbend
