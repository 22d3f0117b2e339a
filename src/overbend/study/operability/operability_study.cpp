#include "study/operability/operability_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>

#include "base/constants.h"
#include "base/finding.h"
#include "base/interruption.h"
#include "base/ranges.h"
#include "base/text.h"
#include "base/units.h"
#include "resultfiles/summary/named_results.h"
#include "runstore/claim_file.h"
#include "study/operability/trial_record.h"
#include "study/operability/workability.h"

namespace overbend {
namespace {

using SteadyClock = std::chrono::steady_clock;

/// Utilisation of the limit of a result: above 1 if exceeded.
double criterion_utilisation(double value, const SeekCondition& condition) {
  const bool is_upper_limit = condition.relation == SeekRelation::at_most;
  const bool exceeded = is_upper_limit ? value > condition.value : value < condition.value;
  const double demand = is_upper_limit ? value : condition.value, capacity = is_upper_limit ? condition.value : value;
  if (demand > 0.0 && capacity > 0.0) return demand / capacity;
  return exceeded ? 2.0 : 0.0;  // values around zero have no ratio
}

/// "dynamic.top_tension.max at most 350 kN"
std::string condition_label(const SeekCondition& condition) {
  const std::vector<std::string> units = usual_units(condition.unit);
  const std::string limit =
      units.empty() ? format_number(condition.value) : format_quantity(condition.value, condition.unit, units.front());
  return condition.result + (condition.relation == SeekRelation::at_most ? " at most " : " at least ") + limit;
}

std::vector<double> find_values(const Json& summary, const std::string& result) {
  if (parsed_result_name(result).function == ResultFunction::none) return named_values(summary, result);
  const std::optional<double> value = named_result(summary, result);
  return value ? std::vector<double>{*value} : std::vector<double>{};
}

void take_worse(TrialResult& result, double utilisation, const std::string& governing) {
  if (utilisation > 1.0) result.end = TrialStatus::exceeded;
  if (result.utilisation && utilisation <= *result.utilisation) return;
  result.utilisation = utilisation;
  result.governing = governing;
}

/// Shared work of the threads.
class TrialRunner {
 public:
  TrialRunner(const CaseBase& base, const OperabilityPlan& plan, const OperabilityOptions& conduct)
      : base_(base), plan_(plan), conduct_(conduct), neighbours_(operability_chains(plan.grid())) {
    if (conduct.gather) return;
    if (base.study().analysis == StudyAnalysis::statics) start_ = base_start(base);
    worker_.emplace(conduct.folder / "workers");
    claims_.resize(neighbours_.size());
  }
  ~TrialRunner() {
    for (std::size_t chain = 0; chain < claims_.size(); ++chain) {
      if (claims_[chain].value_or(false)) release_claims(study_claim_path(chain));
    }
  }
  TrialRunner(const TrialRunner&) = delete;
  TrialRunner& operator=(const TrialRunner&) = delete;

  TrialResult answer(std::size_t cell, std::size_t value, std::size_t seed) {
    const CaseInput question = plan_.question(cell, value, seed);
    const std::filesystem::path folder = conduct_.folder / plan_.folder(cell, value, seed);
    if (std::optional<TrialRecord> known = read_trial(folder, question)) {
      report_trial({cell, value, seed, known->result, known->wall_time, true});
      return known->result;
    }
    const std::size_t chain = chain_of_cell(plan_.grid(), cell);
    if (conduct_.gather || chain % conduct_.tasks != conduct_.task) return open("not run yet");
    if (conduct_.stop && conduct_.stop()) return open("interrupted");
    if (!claimed(chain)) return open("at work in another process");
    return run({cell, value, seed, {}, 0.0, false}, question, folder, neighbours_[chain]);
  }

  double wall_time() const { return wall_time_; }

 private:
  std::filesystem::path study_claim_path(std::size_t chain) const {
    return conduct_.folder / "trials" / ("chain-" + std::to_string(chain));
  }

  /// Only one of the processes that share the folder searches a chain.
  bool claimed(std::size_t chain) {
    std::optional<bool>& claim = claims_[chain];
    if (!claim) {
      std::error_code ignored;
      std::filesystem::create_directories(conduct_.folder / "trials", ignored);
      claim = worker_->claim(study_claim_path(chain));
    }
    return *claim;
  }

  static TrialResult open(std::string why) { return {TrialStatus::open, std::nullopt, "", std::move(why)}; }

  TrialResult run(TrialReport trial, const CaseInput& question, const std::filesystem::path& folder,
                  CaseWarmStart& neighbour) {
    const SteadyClock::time_point begun = SteadyClock::now();
    const OperabilityDescription& wanted = *base_.study().operability;
    CaseEvaluationOptions conduct;
    conduct.folder = folder;
    conduct.checkpoint_every = conduct_.checkpoint_every;
    conduct.stop = conduct_.stop;
    conduct.abandon = conduct_.abandon;
    conduct.progress = [this](const DynamicProgress&, double) {
      if (conduct_.on_advance) conduct_.on_advance();
    };
    conduct.files = &hdf5_lock();
    conduct.until_exceeded = wanted.checks;
    neighbour.start = start_;
    const CaseResult answer = evaluate_case(base_, question, neighbour, conduct);
    trial.result = judged_trial(answer, wanted, trial.value == 0);
    trial.wall_time = std::chrono::duration<double>(SteadyClock::now() - begun).count();
    if (trial.result.end != TrialStatus::open) write_trial({trial.result, trial.wall_time}, question, folder);
    report_trial(trial);
    return trial.result;
  }

  void report_trial(const TrialReport& trial) {
    const std::lock_guard<std::mutex> hold(report_mutex_);
    wall_time_ += trial.wall_time;
    if (conduct_.on_trial) conduct_.on_trial(trial);
  }

  const CaseBase& base_;
  const OperabilityPlan& plan_;
  const OperabilityOptions& conduct_;
  std::vector<CaseWarmStart> neighbours_;    ///< By chain, one thread at a time each.
  std::vector<std::optional<bool>> claims_;  ///< By chain; empty until tried.
  std::optional<WorkerFile> worker_;
  std::shared_ptr<const LayWarmStart> start_;
  std::mutex report_mutex_;
  double wall_time_ = 0.0;
};

OperabilityCell make_cell(const SearchedCell& found, const OperabilityPlan& plan, std::size_t number) {
  OperabilityCell cell;
  cell.value_indices = plan.at(number);
  if (found.limit) cell.limit = plan.values().at(*found.limit);
  cell.beyond = found.beyond;
  cell.decided = found.decided;
  cell.governing = found.governing;
  cell.below = found.below.value_or(0.0);
  cell.above = found.above.value_or(0.0);
  cell.runs = found.runs;
  cell.reason = found.decided ? found.remark : found.reason;
  return cell;
}

void add_workability(const OperabilityDescription& wanted, OperabilityResults& results) {
  if (!wanted.scatter) return;
  if (!wanted.scatter->remark.empty()) results.remarks.push_back(wanted.scatter->remark);
  const auto of_limits = workability(*wanted.scatter, results);
  if (const auto* why = std::get_if<std::string>(&of_limits)) {
    results.remarks.push_back("no workability: " + *why);
    return;
  }
  results.workability = std::get<Workability>(of_limits);
  if (wanted.alpha) {
    results.forecast_workability = std::get<Workability>(workability(*wanted.scatter, results, *wanted.alpha));
  }
  if (results.workability->outside > 0.0) {
    results.remarks.push_back(fmt::format("seas outside the chart occur {:.1f} % of the time and count as not workable",
                                          100.0 * results.workability->outside));
  }
}

/// Remarks on contents of the study file that a limit search ignores.
void add_ignored_remarks(const StudyDescription& study, const OperabilityPlan& plan, OperabilityResults& results) {
  if (!study.gather.empty()) {
    results.remarks.emplace_back(
        "gather is ignored: a limit search has no table of cases; it reports limits, utilisations and governing "
        "checks");
  }
  const double slack = 1e-6 * study.operability->resolution;  // values and resolution come from decimal text
  const auto is_tried = [&](double value) {
    return ranges::any_of(plan.values(), [&](double tried) { return std::abs(tried - value) < slack; });
  };
  std::vector<std::string> left;
  for (std::size_t i = 0; i < plan.over().values.size(); ++i) {
    if (!is_tried(plan.over().values[i])) left.push_back(plan.over().value_texts[i]);
  }
  if (left.empty()) return;
  results.remarks.push_back(
      fmt::format("the minimum and the maximum value of {} are bounds, with trial values in steps of the resolution "
                  "between them; {} {} ignored",
                  plan.over().key, join_items(left, "and"), left.size() == 1 ? "is" : "are"));
}

void add_remarks(const CaseBase& base, OperabilityResults& results) {
  if (const std::vector<std::string>& accepted = base.model().checks.accepted_findings; !accepted.empty()) {
    results.remarks.push_back("findings accepted by name, which do not limit the range: " +
                              join_items(accepted, "and") + " (checks.accepted_findings)");
  }
  const auto open = ranges::count_if(results.cells, [](const OperabilityCell& cell) { return !cell.decided; });
  if (open > 0) results.remarks.push_back(fmt::format("{} of {} cells are not decided", open, results.cells.size()));
  if (base.study().analysis != StudyAnalysis::dynamic) return;
  const std::optional<DynamicSettings>& settings = base.model().dynamics;
  const double duration = base.study().duration.value_or(settings ? settings->duration : 0.0);
  if (duration >= kThreeHours) return;
  results.remarks.push_back(
      fmt::format("limits compare the maximum of {} of {:.3g} min with the criterion, not the most probable "
                  "maximum of three hours",
                  results.seeds.size() > 1 ? fmt::format("{} runs", results.seeds.size()) : "a run", duration / 60.0));
}

}  // namespace

TrialResult judged_trial(const CaseResult& answer, const OperabilityDescription& wanted, bool is_minimum) {
  switch (answer.ending) {
    case RunStatus::done:
      break;
    case RunStatus::no_solution:
      return {TrialStatus::no_solution, std::nullopt, answer.why, ""};
    case RunStatus::wrong_input:  // the sea may be too steep at this value
      if (!is_minimum) return {TrialStatus::no_solution, std::nullopt, answer.why, ""};
      [[fallthrough]];
    case RunStatus::interrupted:
    case RunStatus::error:
      return {TrialStatus::open, std::nullopt, "", answer.why};
  }
  TrialResult result{TrialStatus::passed, std::nullopt, "", ""};
  if (wanted.checks) {
    result.utilisation = answer.utilisation;
    result.governing = answer.governing;
    if (answer.verdict == VerdictKind::exceeded) result.end = TrialStatus::exceeded;
    if (result.end == TrialStatus::exceeded) return result;  // a run that ended early has no other results
    if (answer.governing.empty() && wanted.criterion.empty()) {
      return {TrialStatus::open, std::nullopt, "", "no code check could be evaluated"};
    }
  }
  for (const SeekCondition& condition : wanted.criterion) {
    const std::vector<double> values = find_values(answer.summary, condition.result);
    if (values.empty()) {
      return {TrialStatus::open, std::nullopt, "", "the result " + condition.result + " does not apply"};
    }
    for (const double value : values) {
      take_worse(result, criterion_utilisation(value, condition), condition_label(condition));
    }
  }
  Findings findings = answer.findings;
  if (!wanted.checks) std::erase_if(findings, [](const Finding& f) { return f.code == FindingCode::check_not_judged; });
  if (const std::string codes = serious_codes(findings); result.end == TrialStatus::passed && !codes.empty()) {
    result.end = TrialStatus::exceeded;
    result.governing = codes;
  }
  return result;
}

OperabilityResults run_operability(const CaseBase& base, const OperabilityOptions& conduct) {
  const OperabilityPlan plan(base.study());
  const OperabilityDescription& wanted = *base.study().operability;
  const InterruptionScope scope(conduct.abandon ? conduct.abandon : conduct.stop);
  TrialRunner runner(base, plan, conduct);
  const std::vector<SearchedCell> found = search_operability(
      plan.grid(),
      [&](std::size_t cell, std::size_t value, std::size_t seed) { return runner.answer(cell, value, seed); },
      conduct.threads);
  OperabilityResults results;
  results.over = plan.over().key;
  results.unit = plan.over().unit;
  results.show = plan.over().show;
  results.axes = plan.axes();
  results.min_value = plan.values().front();
  results.max_value = plan.values().back();
  results.resolution = wanted.resolution;
  results.seeds = plan.seeds();
  results.alpha = wanted.alpha;
  for (std::size_t i = 0; i < found.size(); ++i) {
    results.cells.push_back(make_cell(found[i], plan, i));
    results.runs += found[i].runs;
  }
  results.wall_time = runner.wall_time();
  add_workability(wanted, results);
  add_ignored_remarks(base.study(), plan, results);
  add_remarks(base, results);
  return results;
}

}  // namespace overbend
