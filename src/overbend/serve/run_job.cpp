// Execution of a run by the queue: the same as the commands `static` and `dynamic`.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "modelfile/yaml_reader.h"
#include "serve/run_queue.h"
#include "statics/recovery.h"
#include "study/dynamic_realisation.h"
#include "study/static_run.h"

namespace overbend {
namespace {

using Clock = std::chrono::steady_clock;

/// Progress is reported this often at most.
constexpr auto kTold = std::chrono::milliseconds(100);
/// A killed run continues from here.
constexpr auto kCheckpoint = std::chrono::seconds(30);

/// Largest of the columns of von Mises stress of a row.
double worst_stress(const std::vector<HistoryColumn>& columns, std::span<const double> values) {
  double worst = 0.0;
  for (std::size_t i = 0; i < columns.size() && i < values.size(); ++i) {
    if (columns[i].name.ends_with("_von_mises")) worst = std::max(worst, values[i]);
  }
  return worst;
}

/// The model's text as the run was asked for it.
Description description_of(const ModelText& model, double duration) {
  ModelReading reading = read_model_text(model.text, model.path);
  if (!reading.description) throw HttpFault(422, "the model has errors");
  if (duration > 0.0) {
    if (!reading.description->dynamics) reading.description->dynamics.emplace();
    reading.description->dynamics->duration = duration;
  }
  return std::move(*reading.description);
}

/// Command line that continues a run; empty if the model as run is not in a file.
std::string command_of(const ModelText& model, double duration, const std::string& folder) {
  if (!model.saved || model.name.empty()) return "";
  const std::string time = duration > 0.0 ? fmt::format(" --duration '{} s'", duration) : "";
  return fmt::format(", also with: overbend dynamic '{}' -o '{}'{} --resume", model.path, folder, time);
}

}  // namespace

void RunQueue::run(const Job& job) {
  update(
      job.id, [](RunInfo&) {}, true);
  try {
    if (job.kind == "dynamic") {
      run_dynamic(job);
    } else {
      run_static(job);
    }
  } catch (const std::exception& fault) {
    end(job.id, RunState::failed, fault.what());
  }
}

void RunQueue::run_static(const Job& job) {
  const Description description = description_of(job.model, 0.0);
  const Model model = build_model(description);
  const StaticOutcome outcome = solve_statics(model);
  if (outcome.failure) return end(job.id, RunState::failed, failure_line(*outcome.failure));
  if (stop_) return end(job.id, RunState::cancelled, "cancelled");
  {
    const std::lock_guard<std::mutex> hold(files_);
    write_static_run(recover_statics(model, *outcome.solution), description, folder_ / job.id);
  }
  end(job.id, RunState::done, "");
}

void RunQueue::run_dynamic(const Job& job) {
  const Description description = description_of(job.model, job.duration);
  const Model model = build_model(description);
  if (const auto obstacle = dynamic_obstacle(model)) return end(job.id, RunState::failed, failure_line(*obstacle));
  const StaticOutcome start = solve_statics(model);
  if (start.failure) return end(job.id, RunState::failed, failure_line(*start.failure));
  const StaticResults statics = recover_statics(model, *start.solution);
  const DynamicCase shared{description, model, *start.solution, statics, input_text(description)};
  const DynamicOptions options = dynamic_options(model);
  double worst = 0.0;
  Clock::time_point told, saved = Clock::now();
  const auto control = [&](const DynamicProgress& at) {
    if (stop_) return DynamicControl::stop;
    const Clock::time_point now = Clock::now();
    if (now - told >= kTold) {
      told = now;
      update(
          job.id,
          [&](RunInfo& run) {
            run.progress = (at.time + options.build_up) / (options.duration + options.build_up);
            run.now = RunNow{at.time, at.end, at.top_tension, worst};
          },
          false);
    }
    if (now - saved < kCheckpoint) return DynamicControl::go_on;
    saved = now;
    return DynamicControl::checkpoint;
  };
  const auto rows = [&](const std::vector<HistoryColumn>& columns, std::span<const double> values) {
    worst = worst_stress(columns, values);
    live_.add(columns, values);
  };
  const RealisationEnd ended =
      run_realisation(shared, folder_ / job.id, options.seed, job.resume, control, files_, rows);
  if (ended.code == kDone) return end(job.id, RunState::done, "");
  if (ended.code != kInterrupted) return end(job.id, RunState::failed, ended.why);
  end_interrupted(job, [&] {
    if (ended.results) write_so_far(shared, *ended.results, folder_ / job.id, files_);
    return ended.results.has_value();
  });
}

void RunQueue::end_interrupted(const Job& job, const std::function<bool()>& keep_results) {
  const bool closing = [&] {
    const std::lock_guard<std::mutex> hold(mutex_);
    return closing_;
  }();
  if (closing) {  // not what the user wanted, nor is there time for results: the checkpoint stays
    const std::string folder = (folder_ / job.id).string();
    return end(job.id, RunState::cancelled,
               "the program ended; the run can be resumed" + command_of(job.model, job.duration, folder));
  }
  const bool kept = keep_results();
  update(
      job.id, [&](RunInfo& run) { run.has_results = run.has_results || kept; }, false);
  end(job.id, RunState::cancelled, kept ? "cancelled; results computed so far are kept" : "cancelled before t = 0");
}

}  // namespace overbend
