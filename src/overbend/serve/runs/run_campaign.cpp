// Execution of a study file by the queue, equivalent to the command `study`.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <mutex>

#include "modelfile/reading/yaml_reader.h"
#include "modelfile/study_file/study_reader.h"
#include "platform/machine.h"
#include "serve/runs/run_queue.h"
#include "study/campaign/study_execution.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

/// Minimum interval between progress reports.
constexpr auto kProgressInterval = std::chrono::milliseconds(200);

std::string read_file_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

class RunQueue::CampaignObserver : public StudyObserver {
 public:
  CampaignObserver(RunQueue& queue, std::string id) : queue_(queue), id_(std::move(id)) {}

  bool stop() override { return queue_.must_pause(); }
  bool abandon() override { return queue_.must_abandon(); }

  void begin(std::size_t open, std::size_t finished) override {
    total_ = open + finished;
    ended_ = finished;
  }

  void advanced() override { queue_.slice_.note_advance(); }

  void ended(const StudyCase& study_case) override {
    advanced();
    const std::lock_guard<std::mutex> hold(mutex_);
    ++ended_;
    if (study_case.state == StudyCaseState::failed) ++failed_;
    report_progress(failed_ == 0 ? fmt::format("{} of {} cases", ended_, total_)
                                 : fmt::format("{} of {} cases, {} without a solution", ended_, total_, failed_));
  }

  void tried(const TrialReport& /*trial*/) override {
    advanced();
    const std::lock_guard<std::mutex> hold(mutex_);
    ++ended_;
    report_progress(fmt::format("{} analyses", ended_));  // the total number is unknown
  }

 private:
  void report_progress(const std::string& message) {
    const auto time = std::chrono::steady_clock::now();
    if (time - last_report_ < kProgressInterval) return;
    last_report_ = time;
    queue_.update(
        id_,
        [&](RunInfo& info) {
          info.progress = total_ == 0 ? 0.0 : static_cast<double>(ended_) / static_cast<double>(total_);
          info.message = message;
        },
        false);
  }

  RunQueue& queue_;
  std::string id_;
  std::mutex mutex_;  ///< Guards the members below.
  std::size_t total_ = 0, ended_ = 0, failed_ = 0;
  std::chrono::steady_clock::time_point last_report_{};
};

void RunQueue::run_campaign(const Job& job) {
  const std::string& id = job.run.id;
  ModelReading model = read_model_text(job.model.text, job.model.path);
  if (!model.description) return end(id, RunState::failed, "the model has errors");
  StudyReading reading =
      read_study_with_base(read_file_text(folder(job.run) / kStudyCopy), job.model.path, std::move(*model.description));
  if (!reading.study) return end(id, RunState::failed, reading.diagnostics.lines(Severity::error).front());
  const CaseBase base(std::move(*reading.base), std::move(*reading.study));
  CampaignObserver watch(*this, id);
  StudyRunOptions options;
  // One core is left for the statics of the page.
  options.threads = std::max(1, static_cast<int>(hardware_threads()) - 1);
  const StudyExecution outcome = execute_study(base, folder(job.run) / kStudyFolder, options, watch);
  if (outcome.ending == RunStatus::interrupted && !stop_) return requeue(job);
  if (outcome.ending == RunStatus::interrupted) {
    return end(id, RunState::cancelled, "cancelled; cases computed so far are kept");
  }
  if (outcome.ending != RunStatus::done) return end(id, RunState::failed, outcome.why);
  end(id, RunState::done,
      outcome.tally.failed == 0 ? "" : fmt::format("{} cases have no solution", outcome.tally.failed));
}

}  // namespace overbend
