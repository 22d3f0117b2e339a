// Execution of a run by the queue: the same as the commands `static`, `dynamic` and `compare`.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "base/interruption.h"
#include "dynamics/setup/dynamic_obstacle.h"
#include "modelfile/reading/yaml_reader.h"
#include "serve/runs/run_queue.h"
#include "study/run/case.h"
#include "study/run/static_run.h"
#include "study/seeds/compare_variants.h"
#include "study/seeds/study.h"
#include "study/stages/stage_choice.h"

namespace overbend {
namespace {

using Clock = std::chrono::steady_clock;

/// Progress is reported this often at most.
constexpr auto kTold = std::chrono::milliseconds(100);
/// A killed run continues from a checkpoint no older than this [s].
constexpr double kCheckpoint = 30.0;

/// Largest of the columns of von Mises stress of a row.
double worst_stress(const std::vector<HistoryColumn>& columns, std::span<const double> values) {
  double worst = 0.0;
  for (std::size_t i = 0; i < columns.size() && i < values.size(); ++i) {
    if (columns[i].name.ends_with("_von_mises")) worst = std::max(worst, values[i]);
  }
  return worst;
}

/// Of the lay as such, or at the stage of its operation that the run is of.
Description description_of(const ModelText& model, const std::string& stage) {
  ModelReading reading = read_model_text(model.text, model.path);
  if (!reading.description) throw HttpFault(422, "the model has errors");
  if (stage.empty()) return std::move(*reading.description);
  std::variant<Description, RunEnd> chosen = choose_stage(*reading.description, stage);
  if (const RunEnd* end = std::get_if<RunEnd>(&chosen)) throw HttpFault(422, end->why);
  return std::get<Description>(std::move(chosen));
}

StudyPlan plan_of(const RunInfo& run, const Description& description) {
  const std::optional<double> duration = run.duration > 0.0 ? std::optional(run.duration) : std::nullopt;
  if (!run.is_study()) return plan_single(duration);
  std::variant<StudyPlan, std::string> plan =
      run.kind == "seeds"
          ? plan_seeds(run.seeds, duration)
          : plan_comparison(from_word<ComparisonOf>(run.of).value_or(ComparisonOf::tensioner), description, duration);
  if (const auto* fault = std::get_if<std::string>(&plan)) throw HttpFault(422, *fault);
  return std::get<StudyPlan>(plan);
}

/// Command line that continues a run; empty if the model as run is not in a file, or the command would run other seeds.
std::string command_of(const ModelText& model, const RunInfo& run, const std::string& folder) {
  if (!model.saved || model.name.empty() || run.kind == "seeds") return "";
  const std::string command = run.kind == "comparison" ? "compare --of " + run.of : "dynamic";
  const std::string stage = run.stage.empty() ? "" : fmt::format(" --stage '{}'", run.stage);
  const std::string time = run.duration > 0.0 ? fmt::format(" --duration '{} s'", run.duration) : "";
  return fmt::format(", also with: overbend {} '{}' -o '{}'{}{} --resume", command, model.path, folder, stage, time);
}

/// One core is left for the page: its statics are solved while a study runs.
int study_threads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
}

RunState state_of(RunEnding ending) {
  return ending == RunEnding::done          ? RunState::done
         : ending == RunEnding::interrupted ? RunState::cancelled
                                            : RunState::failed;
}

}  // namespace

/// Tells the page of a study: of its cases as of runs, of a single run as of itself.
class RunQueue::Watch : public CaseWatch {
 public:
  Watch(RunQueue& queue, const Job& job) : queue_(queue), study_(job.run.id) {}

  bool stop() override { return queue_.stop_; }

  void begin(const std::vector<CaseRun>& runs) override {
    const DynamicSettings& settings = *runs.front().prepared->description.dynamics;
    build_up_ = settings.build_up;
    whole_ = settings.build_up + settings.duration;
    for (const CaseRun& run : runs) {
      cases_.push_back({run.name.empty() ? study_ : study_ + "~" + run.name, part(run.from), 0.0, {}});
      if (run.ended) queue_.end(cases_.back().id, RunState::done, "");
    }
  }

  void started(std::size_t run) override {
    if (is_single()) return;
    queue_.update(
        cases_[run].id, [](RunInfo& one) { one.state = RunState::running; }, false);
  }

  void progress(std::size_t run, const DynamicProgress& at) override {
    const std::lock_guard<std::mutex> hold(mutex_);
    Followed& one = cases_[run];
    one.progress = part(at.time);
    const Clock::time_point now = Clock::now();
    if (now - one.told < kTold) return;
    one.told = now;
    queue_.update(
        one.id,
        [&](RunInfo& info) {
          info.progress = one.progress;
          info.now = RunNow{at.time, at.end, at.top_tension, one.worst_stress};
        },
        false);
    if (!is_single()) tell_whole();
  }

  void row(std::size_t run, const std::vector<HistoryColumn>& columns, std::span<const double> values) override {
    if (is_single()) queue_.live_.add(columns, values);
    const std::lock_guard<std::mutex> hold(mutex_);
    cases_[run].worst_stress = worst_stress(columns, values);
  }

  /// Results of one that was cancelled are written as far as it went; when the program ends there is no time for that.
  void ended(std::size_t run, const CaseRun& how) override {
    const std::string& id = cases_[run].id;
    std::string fault;
    if (how.end.ending == RunEnding::interrupted && how.end.results && !queue_.closing()) fault = keep_so_far(id, how);
    if (!is_single()) return queue_.end(id, state_of(how.end.ending), fault.empty() ? how.end.why : fault);
    fault_ = fault;
  }

  /// Why what a single run computed could not be kept; empty where it was.
  const std::string& fault() const { return fault_; }

 private:
  struct Followed {
    std::string id;
    double progress = 0.0, worst_stress = 0.0;  ///< [-], [Pa]
    Clock::time_point told;
  };

  std::string keep_so_far(const std::string& id, const CaseRun& how) {
    try {
      write_so_far(*how.prepared, *how.end.results, how.folder, queue_.files_);
    } catch (const std::exception& fault) {  // of this case's disk
      return fault.what();
    }
    queue_.update(
        id, [](RunInfo& info) { info.has_results = true; }, false);
    return "";
  }

  bool is_single() const { return cases_.size() == 1 && cases_.front().id == study_; }
  double part(double time) const { return std::clamp((time + build_up_) / whole_, 0.0, 1.0); }

  void tell_whole() {
    double sum = 0.0;
    for (const Followed& one : cases_) sum += one.progress;
    queue_.update(
        study_, [&](RunInfo& info) { info.progress = sum / static_cast<double>(cases_.size()); }, false);
  }

  RunQueue& queue_;
  std::string study_, fault_;
  double build_up_ = 0.0, whole_ = 1.0;  ///< [s]
  std::mutex mutex_;                     ///< Of what follows, but for the number of cases and their names.
  std::vector<Followed> cases_;
};

void RunQueue::run(const Job& job) {
  update(
      job.run.id, [](RunInfo&) {}, true);
  try {
    const InterruptionScope scope([this] { return stop_.load(); });
    if (job.run.kind == "static") {
      run_static(job);
    } else if (job.run.is_matrix()) {
      run_matrix(job);
    } else {
      run_dynamic(job);
    }
  } catch (const Interrupted&) {
    end_interrupted(job);
  } catch (const std::exception& fault) {
    end(job.run.id, RunState::failed, fault.what());
  }
}

void RunQueue::run_static(const Job& job) {
  const std::string& id = job.run.id;
  const Description description = description_of(job.model, job.run.stage);
  Model model = build_model(description);
  StaticRun found = run_statics(model);
  if (found.failure) return end(id, RunState::failed, failure_line(*found.failure));
  if (stop_) return end(id, RunState::cancelled, "cancelled");
  tell_hull(model, *found.results);
  {
    const std::lock_guard hold(files_);
    write_static_run(*found.results, description, folder(job.run));
  }
  end(id, RunState::done, "");
}

void RunQueue::run_dynamic(const Job& job) {
  const Description description = description_of(job.model, job.run.stage);
  Watch watch(*this, job);
  const StudyEnd ended = run_study(description, plan_of(job.run, description), folder(job.run),
                                   {job.resume, kCheckpoint, study_threads()}, watch, files_);
  if (!watch.fault().empty()) return end(job.run.id, RunState::failed, watch.fault());
  if (ended.ending == RunEnding::interrupted) return end_interrupted(job);
  if (ended.seeds && !ended.seeds->runs.empty()) {  // those that failed are listed among its cases
    const std::string failed =
        ended.failed.empty() ? "" : fmt::format("{} of {} seeds failed", ended.failed.size(), job.run.seeds.size());
    return end(job.run.id, RunState::done, failed);
  }
  end(job.run.id, state_of(ended.ending), ended.why);
}

void RunQueue::end_interrupted(const Job& job) {
  const std::string& id = job.run.id;
  if (closing()) {  // not what the user wanted
    return end(id, RunState::cancelled,
               "the program ended; the run can be resumed" + command_of(job.model, job.run, folder(job.run).string()));
  }
  if (job.run.kind == "static") return end(id, RunState::cancelled, "cancelled");
  if (job.run.is_study()) return end(id, RunState::cancelled, "cancelled; results computed by its cases are kept");
  end(id, RunState::cancelled,
      find(id).has_results ? "cancelled; results computed so far are kept" : "cancelled before t = 0");
}

}  // namespace overbend
