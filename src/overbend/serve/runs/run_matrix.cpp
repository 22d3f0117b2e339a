// Execution of a study file by the queue: the same as the command `study`.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <mutex>
#include <thread>

#include "modelfile/reading/yaml_reader.h"
#include "modelfile/study_file/study_reader.h"
#include "serve/runs/run_queue.h"
#include "study/campaign/whole_study.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

/// Progress is reported this often at most.
constexpr auto kTold = std::chrono::milliseconds(200);

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

class RunQueue::MatrixWatch : public StudyWatch {
 public:
  MatrixWatch(RunQueue& queue, std::string id) : queue_(queue), id_(std::move(id)) {}

  bool stop() override { return queue_.stop_; }

  void begin(std::size_t open, std::size_t finished) override {
    whole_ = open + finished;
    ended_ = finished;
  }

  void ended(const StudyCase& one) override {
    const std::lock_guard<std::mutex> hold(mutex_);
    ++ended_;
    if (one.state == StudyCaseState::failed) ++failed_;
    tell(failed_ == 0 ? fmt::format("{} of {} cases", ended_, whole_)
                      : fmt::format("{} of {} cases, {} without a solution", ended_, whole_, failed_));
  }

  void tried(const TrialTold& /*trial*/) override {
    const std::lock_guard<std::mutex> hold(mutex_);
    ++ended_;
    tell(fmt::format("{} analyses", ended_));  // how many it will take is not known
  }

 private:
  void tell(const std::string& words) {
    const auto now = std::chrono::steady_clock::now();
    if (now - told_ < kTold) return;
    told_ = now;
    queue_.update(
        id_,
        [&](RunInfo& info) {
          info.progress = whole_ == 0 ? 0.0 : static_cast<double>(ended_) / static_cast<double>(whole_);
          info.message = words;
        },
        false);
  }

  RunQueue& queue_;
  std::string id_;
  std::mutex mutex_;  ///< Of what follows.
  std::size_t whole_ = 0, ended_ = 0, failed_ = 0;
  std::chrono::steady_clock::time_point told_{};
};

void RunQueue::run_matrix(const Job& job) {
  const std::string& id = job.run.id;
  ModelReading model = read_model_text(job.model.text, job.model.path);
  if (!model.description) return end(id, RunState::failed, "the model has errors");
  StudyReading reading =
      read_study_of(text_of(folder(job.run) / kStudyCopy), job.model.path, std::move(*model.description));
  if (!reading.study) return end(id, RunState::failed, reading.diagnostics.lines(Severity::error).front());
  const CaseBase base(std::move(*reading.base), std::move(*reading.study));
  MatrixWatch watch(*this, id);
  StudyRunOptions options;
  // One core is left for the page: its statics are solved meanwhile.
  options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
  const WholeStudy whole = run_whole_study(base, folder(job.run) / kStudyFolder, options, watch);
  if (whole.ending == RunEnding::interrupted) {
    return end(id, RunState::cancelled, "cancelled; cases computed so far are kept");
  }
  if (whole.ending != RunEnding::done) return end(id, RunState::failed, whole.why);
  end(id, RunState::done, whole.tally.failed == 0 ? "" : fmt::format("{} cases have no solution", whole.tally.failed));
}

}  // namespace overbend
