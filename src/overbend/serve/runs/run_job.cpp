// Execution of a run by the queue, equivalent to the commands `static`, `dynamic` and `compare`.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "base/interruption.h"
#include "dynamics/setup/unsupported_in_dynamics.h"
#include "modelfile/reading/yaml_reader.h"
#include "platform/machine.h"
#include "serve/runs/run_queue.h"
#include "study/run/case.h"
#include "study/run/static_analysis.h"
#include "study/seeds/compare_variants.h"
#include "study/seeds/study.h"
#include "study/stages/stage_choice.h"

namespace overbend {
namespace {

using Clock = std::chrono::steady_clock;

/// Minimum interval between progress reports.
constexpr auto kProgressInterval = std::chrono::milliseconds(100);
/// Interval between checkpoints [s].
constexpr double kCheckpoint = 30.0;

/// Returns the maximum of the von Mises stress columns of a row [Pa].
double worst_stress(const std::vector<HistoryColumn>& columns, std::span<const double> values) {
  double worst = 0.0;
  for (std::size_t i = 0; i < columns.size() && i < values.size(); ++i) {
    if (columns[i].name.ends_with("_von_mises")) worst = std::max(worst, values[i]);
  }
  return worst;
}

/// Returns the description of the normal lay, or of the given stage of the operation.
Description read_description(const ModelText& model, const std::string& stage) {
  ModelReading reading = read_model_text(model.text, model.path);
  if (!reading.description) throw HttpError(422, "the model has errors");
  if (stage.empty()) return std::move(*reading.description);
  std::variant<Description, RunResult> chosen = choose_stage(*reading.description, stage);
  if (const RunResult* end = std::get_if<RunResult>(&chosen)) throw HttpError(422, end->why);
  return std::get<Description>(std::move(chosen));
}

StudyPlan make_run_plan(const RunInfo& run, const Description& description) {
  const std::optional<double> duration = run.duration > 0.0 ? std::optional(run.duration) : std::nullopt;
  if (!run.is_study()) return plan_single(duration);
  std::variant<StudyPlan, std::string> plan =
      run.kind == "seeds" ? plan_seeds(run.seeds, duration)
                          : plan_comparison(from_enum_name<ComparisonType>(run.of).value_or(ComparisonType::tensioner),
                                            description, duration);
  if (const auto* error = std::get_if<std::string>(&plan)) throw HttpError(422, *error);
  return std::get<StudyPlan>(plan);
}

/// Returns the command line that continues a run; empty if the model of the run is not in a file, or if the command
/// would run other seeds.
std::string resume_command(const ModelText& model, const RunInfo& run, const std::string& folder) {
  if (!model.saved || model.name.empty() || run.kind == "seeds") return "";
  const std::string command = run.kind == "comparison" ? "compare --of " + run.of : "dynamic";
  const std::string stage = run.stage.empty() ? "" : fmt::format(" --stage '{}'", run.stage);
  const std::string time = run.duration > 0.0 ? fmt::format(" --duration '{} s'", run.duration) : "";
  return fmt::format(", also with: overbend {} '{}' -o '{}'{}{} --resume", command, model.path, folder, stage, time);
}

/// Leaves one core for the page, whose statics are solved while a study runs.
int study_threads() {
  return std::max(1, static_cast<int>(hardware_threads()) - 1);
}

RunState run_state(RunStatus ending) {
  return ending == RunStatus::done          ? RunState::done
         : ending == RunStatus::interrupted ? RunState::cancelled
                                            : RunState::failed;
}

}  // namespace

/// Reports the progress of a study and its cases, or of a single run, to the page.
class RunQueue::Watch : public CaseObserver {
 public:
  Watch(RunQueue& queue, const Job& job) : queue_(queue), study_(job.run.id) {}

  bool stop() override { return queue_.must_pause(); }
  bool abandon() override { return queue_.must_abandon(); }

  void begin(const std::vector<CaseRun>& runs) override {
    const DynamicSettings& settings = *runs.front().prepared->description.dynamics;
    build_up_ = settings.build_up;
    total_time_ = settings.build_up + settings.duration;
    for (const CaseRun& run : runs) {
      cases_.push_back({run.name.empty() ? study_ : study_ + "~" + run.name, part(run.from), 0.0, {}});
      if (run.ended) queue_.end(cases_.back().id, RunState::done, "");
    }
  }

  void started(std::size_t run) override {
    if (is_single()) return;
    queue_.update(
        cases_[run].id, [](RunInfo& info) { info.state = RunState::running; }, false);
  }

  void progress(std::size_t run, const DynamicProgress& state) override {
    queue_.slice_.note_advance();
    const std::lock_guard<std::mutex> hold(mutex_);
    CaseProgress& followed = cases_[run];
    followed.progress = part(state.time);
    const Clock::time_point time = Clock::now();
    if (time - followed.last_report < kProgressInterval) return;
    followed.last_report = time;
    queue_.update(
        followed.id,
        [&](RunInfo& info) {
          info.progress = followed.progress;
          info.live_progress = RunProgress{state.time, state.end, state.top_tension, followed.worst_stress};
        },
        false);
    if (!is_single()) report_study_progress();
  }

  void row(std::size_t run, const std::vector<HistoryColumn>& columns, std::span<const double> values) override {
    if (is_single()) queue_.live_.add(columns, values);
    const std::lock_guard<std::mutex> hold(mutex_);
    cases_[run].worst_stress = worst_stress(columns, values);
  }

  /// Writes the partial results of a cancelled run, but not when the program ends, for lack of time.
  void ended(std::size_t run, const CaseRun& how) override {
    const std::string& id = cases_[run].id;
    std::string error;
    if (how.end.ending == RunStatus::interrupted && !queue_.stop_) return;  // the next slice continues it
    if (how.end.ending == RunStatus::interrupted && how.end.results && !queue_.closing()) {
      error = keep_partial_results(id, how);
    }
    if (!is_single()) return queue_.end(id, run_state(how.end.ending), error.empty() ? how.end.why : error);
    write_error_ = error;
  }

  /// Returns the reason why the partial results of a single run could not be written; empty if they were.
  const std::string& write_error() const { return write_error_; }

 private:
  struct CaseProgress {
    std::string id;
    double progress = 0.0, worst_stress = 0.0;  ///< [-], [Pa]
    Clock::time_point last_report;
  };

  std::string keep_partial_results(const std::string& id, const CaseRun& how) {
    try {
      write_partial_results(*how.prepared, *how.end.results, how.folder, queue_.files_);
    } catch (const std::exception& error) {  // disk error of this case
      return error.what();
    }
    queue_.update(
        id, [](RunInfo& info) { info.has_results = true; }, false);
    return "";
  }

  bool is_single() const { return cases_.size() == 1 && cases_.front().id == study_; }
  double part(double time) const { return std::clamp((time + build_up_) / total_time_, 0.0, 1.0); }

  void report_study_progress() {
    double sum = 0.0;
    for (const CaseProgress& followed : cases_) sum += followed.progress;
    queue_.update(
        study_, [&](RunInfo& info) { info.progress = sum / static_cast<double>(cases_.size()); }, false);
  }

  RunQueue& queue_;
  std::string study_, write_error_;
  double build_up_ = 0.0, total_time_ = 1.0;  ///< [s]
  std::mutex mutex_;                          ///< Guards the members below, except the number and names of cases.
  std::vector<CaseProgress> cases_;
};

void RunQueue::run(const Job& job) {
  update(
      job.run.id, [](RunInfo&) {}, true);
  try {
    const InterruptionScope scope([this] { return must_abandon(); });
    if (job.run.kind == "static") {
      run_static(job);
    } else if (job.run.is_campaign()) {
      run_campaign(job);
    } else {
      run_dynamic(job);
    }
  } catch (const Interrupted&) {
    end_interrupted(job);
  } catch (const std::exception& error) {
    end(job.run.id, RunState::failed, error.what());
  }
}

void RunQueue::run_static(const Job& job) {
  const std::string& id = job.run.id;
  const Description description = read_description(job.model, job.run.stage);
  Model model = build_model(description);
  StaticRun found = run_statics(model);
  if (found.failure) return end(id, RunState::failed, failure_line(*found.failure));
  if (stop_) return end(id, RunState::cancelled, "cancelled");
  add_roller_friction_limits(model, *found.solution, *found.results);
  add_hull_results(model, *found.results);
  {
    const std::lock_guard hold(files_);
    write_static_run(*found.results, description, folder(job.run));
  }
  end(id, RunState::done, "");
}

void RunQueue::run_dynamic(const Job& job) {
  const Description description = read_description(job.model, job.run.stage);
  Watch watch(*this, job);
  const StudyOutcome ended = run_study(description, make_run_plan(job.run, description), folder(job.run),
                                       {job.resume, kCheckpoint, study_threads()}, watch, files_);
  if (!watch.write_error().empty()) return end(job.run.id, RunState::failed, watch.write_error());
  if (ended.ending == RunStatus::interrupted) return stop_ ? end_interrupted(job) : requeue(job);
  if (ended.seeds && !ended.seeds->runs.empty()) {  // failed seeds are listed among the cases
    const std::string failed =
        ended.failed.empty() ? "" : fmt::format("{} of {} seeds failed", ended.failed.size(), job.run.seeds.size());
    return end(job.run.id, RunState::done, failed);
  }
  end(job.run.id, run_state(ended.ending), ended.why);
}

void RunQueue::end_interrupted(const Job& job) {
  const std::string& id = job.run.id;
  if (closing()) {  // not cancelled by the user
    return end(
        id, RunState::cancelled,
        "the program ended; the run can be resumed" + resume_command(job.model, job.run, folder(job.run).string()));
  }
  if (job.run.kind == "static") return end(id, RunState::cancelled, "cancelled");
  if (job.run.is_study()) return end(id, RunState::cancelled, "cancelled; results computed by its cases are kept");
  end(id, RunState::cancelled,
      find(id).has_results ? "cancelled; results computed so far are kept" : "cancelled before t = 0");
}

}  // namespace overbend
