#include "study/cases/case_evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "base/interruption.h"
#include "checks/run_checks.h"
#include "dynamics/integrator/dynamics.h"
#include "modelfile/reading/seek_reader.h"
#include "resultfiles/static/case_summary.h"
#include "resultfiles/studies/seek_writer.h"
#include "results/findings.h"
#include "results/worst_stage.h"
#include "runstore/run_store.h"
#include "runstore/staged_folder.h"
#include "study/goal_seek/seek_run.h"
#include "study/run/dynamic_realisation.h"
#include "study/run/exceeded_early.h"
#include "study/run/static_run.h"
#include "study/stages/lay_operation.h"

namespace overbend {
namespace {

using SteadyClock = std::chrono::steady_clock;

CaseAnswer ended(RunEnding how, std::string why) {
  return {{how, std::move(why)}};
}

std::unique_lock<FileLock> held(FileLock* files) {
  return files != nullptr ? std::unique_lock(*files) : std::unique_lock<FileLock>();
}

void judge(const CheckTable& checks, const Findings& findings, CaseAnswer& answer) {
  answer.verdict = verdict_kind(checks, findings);
  answer.findings = findings;
  const CheckRow* worst = worst_check(checks);
  if (worst == nullptr) return;
  answer.governing = worst->name;
  answer.utilisation = worst->utilisation;
}

CaseAnswer answer_statics(const CaseBase& base, const CaseQuestion& question, CaseNeighbour& neighbour,
                          const CaseConduct& conduct) {
  neighbour.found.reset();
  const Description description = base.described(question.keys, !conduct.keep);
  Model model = build_model(description);
  // Files that stay are those of a solution by itself.
  std::vector<const LayStart*> starts = {neighbour.start.get(), neighbour.other.get()};
  if (conduct.keep) starts.clear();
  StaticRun found = solve_beside(model, starts, &neighbour.found);
  if (found.failure) return {failed_end(*found.failure, description)};
  CaseAnswer answer;
  tell_hull(model, *found.results);
  judge(found.results->checks, found.results->findings, answer);
  answer.summary = static_summary_json(*found.results);
  if (conduct.keep) {
    const auto hold = held(conduct.files);
    write_static_run(*found.results, description, conduct.folder);
  }
  return answer;
}

CaseAnswer answer_dynamics(const CaseBase& base, const CaseQuestion& question, CaseNeighbour& neighbour,
                           const CaseConduct& conduct) {
  if (RunEnd end = prepare_neighbour(base, question, neighbour); end.ending != RunEnding::done) return {end};
  const PreparedCase& prepared = *neighbour.prepared;
  const std::uint64_t seed = question.seed.value_or(dynamic_options(prepared.model).seed);
  SteadyClock::time_point last = SteadyClock::now();
  const double from = -prepared.description.dynamics->build_up;
  ExceededEarly exceeded_early(prepared.model, prepared.statics);
  bool exceeded = false;
  const auto control = [&](const DynamicProgress& at) {
    if (conduct.progress) conduct.progress(at, from);
    if (conduct.stop && conduct.stop()) return DynamicControl::stop;
    if (conduct.until_exceeded && exceeded_early(at)) {
      exceeded = true;
      return DynamicControl::stop;
    }
    if (std::chrono::duration<double>(SteadyClock::now() - last).count() < conduct.checkpoint_every) {
      return DynamicControl::go_on;
    }
    last = SteadyClock::now();
    return DynamicControl::checkpoint;
  };
  FileLock own;
  const RunFiles files = conduct.keep ? RunFiles::all : RunFiles::none;
  RealisationEnd end = run_realisation(prepared, conduct.folder, seed, true, control,
                                       conduct.files != nullptr ? *conduct.files : own, {}, files);
  if (exceeded && end.ending == RunEnding::interrupted) {  // there is nothing to go on with
    static_cast<RunEnd&>(end) = {};
    keep_lasting_checks(end.results->checks);
    if (auto left = RunStore::resume(conduct.folder, prepared.input, seed)) left->store.remove();
  }
  CaseAnswer answer{static_cast<const RunEnd&>(end)};
  if (end.ending != RunEnding::done) return answer;
  judge(end.results->checks, all_findings(prepared.statics, *end.results), answer);
  answer.peaks = std::move(end.peaks);
  answer.summary = dynamic_summary_json(prepared.statics, *end.results);
  return answer;
}

/// The stages' table, and the worst stage as a lay of its own.
Json worst_stage_summary(const OperationResults& results) {
  Json summary = operation_summary_json(results);
  const StageResult* worst = worst_stage(results);
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

/// By the worst stage; the verdict is that some stages cannot be where there are such. Why the first of them cannot.
std::string judge_stages(const OperationResults& results, CaseAnswer& answer) {
  const Findings findings = operation_findings(results);
  if (const StageResult* worst = worst_stage(results)) judge(worst->lay->checks, findings, answer);
  answer.findings = findings;
  answer.summary = worst_stage_summary(results);
  const auto failed = std::ranges::find_if(results.stages, [](const StageResult& stage) { return !stage.lay; });
  if (failed == results.stages.end()) return "";
  answer.verdict = VerdictKind::exceeded;
  return fmt::format("no equilibrium at stage {}: {}", failed->stage.name, failed->failure->why);
}

CaseAnswer answer_operation(const CaseBase& base, const CaseQuestion& question, const CaseConduct& conduct) {
  const Description description = base.described(question.keys, false);
  if (const auto obstacle = operation_obstacle(description)) return {failed_end(*obstacle, description)};
  bool stopped = false;
  const OperationResults results = solve_operation(description, [&](const StageResult&, std::size_t) {
    stopped = conduct.stop && conduct.stop();
    return !stopped;
  });
  if (stopped) return ended(RunEnding::interrupted, "interrupted");
  CaseAnswer answer;
  const std::string failed = judge_stages(results, answer);
  if (std::ranges::none_of(results.stages, [](const StageResult& stage) { return stage.lay.has_value(); })) {
    return ended(RunEnding::no_solution, "no solution: " + failed);
  }
  if (conduct.keep) {
    const auto hold = held(conduct.files);
    write_operation_run(results, description, conduct.folder);
  }
  return answer;
}

CaseAnswer answer_seek(const CaseBase& base, const CaseQuestion& question, const CaseConduct& conduct) {
  const Description description = base.described(question.keys, false);
  const std::optional<SeekDescription> wanted = read_seek(description);
  if (!wanted) return ended(RunEnding::wrong_input, "the base model has no key seek");
  const SeekRun run = run_seek(description, *wanted);
  if (!run.results.found) return ended(RunEnding::no_solution, "no solution: " + run.results.why);
  CaseAnswer answer;
  if (run.operation) {
    judge_stages(*run.operation, answer);
  } else {
    judge(run.statics.results->checks, run.statics.results->findings, answer);
    answer.summary = static_summary_json(*run.statics.results);
  }
  answer.summary["seek"] = seek_json(run.results);
  if (conduct.keep) {
    const auto hold = held(conduct.files);
    write_seek_run(run, description, conduct.folder);
  }
  return answer;
}

CaseAnswer answer_of(const CaseBase& base, const CaseQuestion& question, CaseNeighbour& neighbour,
                     const CaseConduct& conduct) {
  switch (base.study().analysis) {
    case StudyAnalysis::statics:
      return answer_statics(base, question, neighbour, conduct);
    case StudyAnalysis::dynamic:
      return answer_dynamics(base, question, neighbour, conduct);
    case StudyAnalysis::operation:
      return answer_operation(base, question, conduct);
    case StudyAnalysis::seek:
      break;
  }
  return answer_seek(base, question, conduct);
}

}  // namespace

std::shared_ptr<const LayStart> base_start(const CaseBase& base) {
  std::shared_ptr<const LayStart> found;
  try {
    Model model = build_model(base.model());
    solve_beside(model, {}, &found);
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception&) {  // the cases say themselves what is wrong
  }
  return found;
}

RunEnd prepare_neighbour(const CaseBase& base, const CaseQuestion& question, CaseNeighbour& neighbour) {
  if (neighbour.prepared && neighbour.keys == question.keys) return {};
  try {
    const Description description = base.described(question.keys, false);
    if (const std::optional<RunEnd> calm = refuse_calm_run(description)) return *calm;
    auto made = prepare_case(description);
    if (const RunEnd* fault = std::get_if<RunEnd>(&made)) return *fault;
    neighbour.prepared = std::get<std::shared_ptr<const PreparedCase>>(std::move(made));
    neighbour.keys = question.keys;
    return {};
  } catch (const std::runtime_error& fault) {
    return {RunEnding::wrong_input, fault.what()};
  }
}

CaseAnswer evaluate_case(const CaseBase& base, const CaseQuestion& question, CaseNeighbour& neighbour,
                         const CaseConduct& conduct) {
  const InterruptionScope scope(conduct.stop);
  try {
    return answer_of(base, question, neighbour, conduct);
  } catch (const Interrupted&) {
    return ended(RunEnding::interrupted, "interrupted");
  } catch (const FileFault& fault) {
    return ended(RunEnding::fault, fault.what());
  } catch (const UnusableFolder& fault) {
    return ended(RunEnding::fault, fault.what());
  } catch (const std::runtime_error& fault) {
    return ended(RunEnding::wrong_input, fault.what());
  } catch (const std::exception& fault) {
    return ended(RunEnding::fault, std::string("internal fault: ") + fault.what());
  }
}

}  // namespace overbend
