#include "serve/runs/run_queue.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <iterator>

#include "base/ranges.h"
#include "modelfile/yaml/model_differences.h"
#include "platform/machine.h"
#include "resultfiles/static/results_writer.h"
#include "runstore/append_file.h"

namespace overbend {
namespace fs = std::filesystem;
namespace {

/// Returns a name such as "20261121-134500-dynamic".
std::string make_run_name(const std::string& kind, int attempt) {
  const std::tm local = local_time(std::time(nullptr));
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y%m%d-%H%M%S-", &local);
  return text.data() + kind + (attempt > 1 ? "-" + std::to_string(attempt) : "");
}

/// Returns the text of a file; empty if it does not exist.
std::string file_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Creates a folder for a new run and returns its name.
std::string make_folder(const fs::path& folder, const std::string& kind) {
  std::error_code error;
  fs::create_directories(folder, error);
  for (int attempt = 1; !error && attempt < 1000; ++attempt) {
    std::string name = make_run_name(kind, attempt);
    if (fs::create_directory(folder / name, error)) return name;
  }
  throw HttpError(422, "the folder '" + folder.string() + "' cannot be written: " + error.message());
}

/// Returns a text such as "tensioner.tension 255 kN, vessel.trim 1 deg and 3 more keys"; empty without changes.
std::string changes_text(const std::vector<DifferingKey>& keys) {
  constexpr std::size_t kShown = 2;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, keys.size()); ++i) {
    const std::string& value = keys[i].values[1];
    text += (i ? ", " : "") + keys[i].key + (value.empty() ? " removed" : " " + value);
  }
  const std::size_t more = keys.size() - std::min(kShown, keys.size());
  return more == 0 ? text : text + " and " + std::to_string(more) + (more == 1 ? " more key" : " more keys");
}

/// True for keys that do not affect the results of a run: titles, report settings and seeds.
bool does_not_affect_results(const std::string& key) {
  return key == "title" || key.starts_with("report") || key.starts_with("analysis.dynamic.seeds");
}

}  // namespace

RunQueue::RunQueue(fs::path folder, EventHub& events, Mode mode)
    : folder_(std::move(folder)), events_(events), runs_(find_runs(folder_)) {
  if (mode == Mode::background) worker_ = std::thread([this] { work(); });
}

RunQueue::~RunQueue() {
  try {
    close();
  } catch (const std::exception&) {  // the old record remains: the run is then listed as waiting
  }
}

void RunQueue::close() {
  std::vector<std::string> left;
  {
    const std::lock_guard<std::mutex> hold(mutex_);
    closing_ = true;
    stop_ = true;
    for (const Job& job : waiting_) left.push_back(job.run.id);
    waiting_.clear();
  }
  changed_.notify_all();
  if (worker_.joinable()) worker_.join();
  for (const std::string& id : left) end(id, RunState::cancelled, "the program ended before the run started");
}

RunInfo RunQueue::add(const ModelText& model, const RunRecord& order, const std::string& study) {
  RunInfo run;
  static_cast<RunRecord&>(run) = order;
  run.id = make_folder(folder_, run.kind);
  run.started = seconds_since_1970();
  run.model_path = model.path;
  run.changed = changed_since_last(run.title, model.text);
  write_text(folder(run) / kModelCopy, model.text);
  if (run.is_campaign()) write_text(folder(run) / kStudyCopy, study);
  keep_record(run, folder(run));
  const std::vector<RunInfo> cases = make_study_cases(run);
  {
    const std::lock_guard<std::mutex> hold(mutex_);
    runs_.push_back(run);
    runs_.insert(runs_.end(), cases.begin(), cases.end());
    waiting_.push_back({run, model, false});
  }
  changed_.notify_all();
  send_state(run.id);
  for (const RunInfo& case_run : cases) send_state(case_run.id);
  return run;
}

std::string RunQueue::changed_since_last(const std::string& title, const std::string& text) const {
  std::optional<RunInfo> last;
  for (const RunInfo& run : list()) {
    if (run.parent.empty() && run.title == title && (!last || run.id > last->id)) last = run;
  }
  return last ? changes_text(differing_keys(std::array{file_text(folder(*last) / kModelCopy), text})) : "";
}

std::string RunQueue::changes_since(const std::string& id, const std::string& text) const {
  RunInfo run = find(id);
  if (!run.parent.empty()) run = find(run.parent);  // a study has one copy of the model for all cases
  const std::string before = file_text(folder(run) / kModelCopy);
  if (before.empty()) throw HttpError(404, "the run has no copy of its model");
  std::vector<DifferingKey> keys = differing_keys(std::array{before, text});
  std::erase_if(keys, [](const DifferingKey& key) { return does_not_affect_results(key.key); });
  return changes_text(keys);
}

RunInfo RunQueue::cancel(const std::string& id) {
  find_whole(id);
  bool waited = false;
  {
    const std::lock_guard<std::mutex> hold(mutex_);
    const bool running = at(id).state == RunState::running;  // in slices, it may wait for the next one
    if (running) stop_ = true;
    waited = !running && std::erase_if(waiting_, [&](const Job& job) { return job.run.id == id; }) > 0;
  }
  if (waited) end(id, RunState::cancelled, "cancelled before it started");
  return find(id);
}

RunInfo RunQueue::annotate(const std::string& id, const std::string& name, const std::string& note) {
  find(id);
  update(
      id,
      [&](RunInfo& run) {
        run.name = name;
        run.note = note;
      },
      true);
  return find(id);
}

void RunQueue::remove(const std::string& id) {
  const RunInfo run = find_whole(id);
  {
    const std::lock_guard<std::mutex> hold(mutex_);
    if (!at(id).ended()) throw HttpError(409, "the run is still in progress", "cancel it first");
    std::erase_if(runs_, [&](const RunInfo& listed) { return listed.id == id || listed.parent == id; });
  }
  std::error_code error;
  {
    const std::lock_guard hold(files_);  // another thread may be reading them
    fs::remove_all(folder(run), error);
  }
  events_.send("run", {{"id", id}, {"state", "deleted"}}, id);
  if (error) throw HttpError(422, "the folder of the run cannot be removed: " + error.message());
}

RunInfo RunQueue::resume(const std::string& id) {
  const RunInfo run = find_whole(id);
  Job job{run, {}, true};
  job.model.text = file_text(folder(run) / kModelCopy);
  job.model.path = run.model_path;
  {
    const std::lock_guard<std::mutex> hold(mutex_);
    RunInfo& listed = at(id);
    if (!listed.ended() || !listed.resumable || job.model.text.empty()) {
      throw HttpError(409, "the run cannot be resumed", "it has no checkpoint to continue from");
    }
    listed.state = RunState::queued;
    listed.resumable = false;
    listed.message.clear();
    for (RunInfo& case_run : runs_) {
      if (case_run.parent != id || case_run.state == RunState::done) continue;
      case_run.state = RunState::queued;
      case_run.message.clear();
    }
    waiting_.push_back(std::move(job));
  }
  changed_.notify_all();
  for (const RunInfo& case_run : make_study_cases(run)) {
    update(
        case_run.id, [](RunInfo&) {}, false);
  }
  update(
      id, [](RunInfo&) {}, true);
  return find(id);
}

std::vector<RunInfo> RunQueue::list() const {
  const std::lock_guard<std::mutex> hold(mutex_);
  std::vector<RunInfo> runs(runs_.rbegin(), runs_.rend());
  std::erase_if(runs, [](const RunInfo& run) { return !run.parent.empty(); });
  std::stable_sort(runs.begin(), runs.end(), [](const RunInfo& a, const RunInfo& b) { return a.started > b.started; });
  for (std::size_t i = 0; i < runs.size(); ++i) {  // inserts the cases of each study after it, in order
    if (!runs[i].is_study()) continue;
    std::vector<RunInfo> cases;
    ranges::copy_if(runs_, std::back_inserter(cases),
                    [&](const RunInfo& candidate) { return candidate.parent == runs[i].id; });
    runs.insert(runs.begin() + static_cast<std::ptrdiff_t>(i) + 1, cases.begin(), cases.end());
  }
  return runs;
}

RunInfo RunQueue::find(const std::string& id) const {
  const std::lock_guard<std::mutex> hold(mutex_);
  for (const RunInfo& run : runs_) {
    if (run.id == id) return run;
  }
  throw HttpError(404, "there is no run " + id);
}

RunInfo RunQueue::find_whole(const std::string& id) const {
  RunInfo run = find(id);
  if (!run.parent.empty()) throw HttpError(409, "the run is a case of " + run.parent, "select the study itself");
  return run;
}

bool RunQueue::closing() const {
  const std::lock_guard<std::mutex> hold(mutex_);
  return closing_;
}

RunInfo& RunQueue::at(const std::string& id) {
  return *std::find_if(runs_.begin(), runs_.end(), [&](const RunInfo& run) { return run.id == id; });
}

void RunQueue::update(const std::string& id, const std::function<void(RunInfo&)>& change, bool persistent) {
  {
    const std::lock_guard<std::mutex> hold(mutex_);
    change(at(id));
  }
  if (persistent) {
    try {
      const std::lock_guard hold(files_);
      const RunInfo latest = find(id);  // the state may have changed while waiting for the lock
      keep_record(latest, folder(latest));
    } catch (const std::exception&) {
      // The disk is full or the folder was deleted; the run stays in the list of this session.
    }
  }
  send_state(id);
}

void RunQueue::send_state(const std::string& id) {
  const std::lock_guard<std::mutex> sending(sending_);
  RunInfo run;
  {
    const std::lock_guard<std::mutex> hold(mutex_);
    const auto found = ranges::find(runs_, id, &RunInfo::id);
    if (found == runs_.end()) return;  // deleted meanwhile
    run = *found;
  }
  events_.send("run", run_json(run), id);
}

void RunQueue::end(const std::string& id, RunState state, const std::string& message) {
  const RunInfo run = find(id);
  for (const RunInfo& case_run : make_study_cases(run)) {  // cases that have not ended
    if (!find(case_run.id).ended()) end(case_run.id, state == RunState::done ? state : RunState::cancelled, "");
  }
  const bool resumable = state != RunState::done && run.parent.empty() && can_be_resumed(run, folder_);
  RunInfo judged = run;
  read_verdict(judged, folder(run));
  update(
      id,
      [&](RunInfo& info) {
        info.verdict = judged.verdict;
        info.verdict_text = judged.verdict_text;
        info.utilisation = judged.utilisation;
        info.state = state;
        info.message = message;
        info.resumable = resumable;
        info.live_progress.reset();
        if (state == RunState::done) {
          info.progress = 1.0;
          info.has_results = true;
        }
      },
      true);
}

void RunQueue::work() {
  while (true) {
    Job job;
    {
      std::unique_lock<std::mutex> hold(mutex_);
      changed_.wait(hold, [&] { return closing_ || !waiting_.empty(); });
      if (closing_) return;
      job = take_job();
    }
    run(job);
    live_.clear();
  }
}

RunQueue::Job RunQueue::take_job() {
  Job job = std::move(waiting_.front());
  waiting_.pop_front();
  RunState& state = at(job.run.id).state;
  if (state != RunState::running) stop_ = false;  // else cancelled since its last slice
  state = RunState::running;
  return job;
}

bool RunQueue::execute_slice(std::chrono::milliseconds slice) {
  Job job;
  {
    const std::lock_guard<std::mutex> hold(mutex_);
    if (waiting_.empty()) return false;
    job = take_job();
  }
  slice_.begin(slice);
  run(job);
  if (find(job.run.id).ended()) live_.clear();
  return true;
}

void RunQueue::requeue(const Job& job) {
  const std::lock_guard<std::mutex> hold(mutex_);
  waiting_.push_front({job.run, job.model, true});
}

}  // namespace overbend
