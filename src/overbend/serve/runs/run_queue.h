/// Background queue of runs, executed one after the other, independent of open pages.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <mutex>
#include <thread>

#include "base/file_lock.h"
#include "serve/http/events.h"
#include "serve/model/open_model.h"
#include "serve/runs/live_history.h"
#include "serve/runs/run_info.h"
#include "serve/runs/run_slice.h"

namespace overbend {

/// All functions may be called from any thread.
class RunQueue {
 public:
  enum class Mode {
    background,  ///< In a thread of the queue.
    in_slices,   ///< By execute_slice(), where there are no threads.
  };

  /// Runs are stored in folders below `folder`; existing ones are listed.
  RunQueue(std::filesystem::path folder, EventHub& events, Mode mode = Mode::background);
  /// Stops the active run at a checkpoint and cancels the waiting ones.
  ~RunQueue();
  RunQueue(const RunQueue&) = delete;
  RunQueue& operator=(const RunQueue&) = delete;

  /// Executes the next queued run for about `slice`. A dynamic run and a study stop at a checkpoint then, and the next
  /// call continues them with the same results; other runs go on to their end. Returns false if no run is queued.
  bool execute_slice(std::chrono::milliseconds slice);

  /// Queues a run of the model. `order` gives kind, title, duration, seeds and comparison; `study` is the text of the
  /// study file, if that is the kind. HttpError 422 if the folder cannot be created.
  RunInfo add(const ModelText& model, const RunRecord& order, const std::string& study = "");
  /// Cancels a run. A dynamic run, and every case of a study, keeps its results so far and a checkpoint. HttpError 409
  /// for a single case of a study.
  RunInfo cancel(const std::string& id);
  /// Sets the user's name and note of a run.
  RunInfo annotate(const std::string& id, const std::string& name, const std::string& note);
  /// Removes a finished run with its folder and its cases; HttpError 409 while it is in progress.
  void remove(const std::string& id);
  /// Queues an interrupted run again, to continue from its checkpoint with its original model text. HttpError 409 if it
  /// cannot be resumed.
  RunInfo resume(const std::string& id);

  /// Returns the runs, newest first, each study followed by its cases.
  std::vector<RunInfo> list() const;
  /// Returns a run; HttpError 404 if it does not exist.
  RunInfo find(const std::string& id) const;
  /// Returns a text of the keys and values in which `text` differs from the model of a run; empty without differences.
  /// HttpError 404 if the run has no copy of its model.
  std::string changes_since(const std::string& id, const std::string& text) const;
  std::filesystem::path folder(const RunInfo& run) const { return find_run_folder(run, folder_); }

  const LiveHistory& live() const { return live_; }
  /// Lock to be held while reading or writing results files, because HDF5 is not thread-safe.
  FileLock& files() { return files_; }

 private:
  void close();
  struct Job {
    RunInfo run;
    ModelText model;
    bool resume = false;
  };
  class Watch;             ///< Observer of dynamic runs and studies.
  class CampaignObserver;  ///< Observer of study files.

  void work();
  /// Returns the first job of the queue, which becomes the active one.
  Job take_job();
  void run(const Job& job);
  /// True if the active run must stop at a checkpoint: it was cancelled, or its slice is over.
  /// A slice first computes a step or a case: of a run that was cancelled between two slices, the results are kept.
  bool must_pause() const {
    return slice_.is_active() ? slice_.has_advanced() && (stop_ || slice_.is_over()) : stop_.load();
  }
  /// True if the active run must end without a checkpoint.
  bool must_abandon() const { return stop_ && !slice_.is_active(); }
  /// Puts a run that stopped because its slice is over back to the head of the queue.
  void requeue(const Job& job);
  void run_static(const Job& job);
  void run_dynamic(const Job& job);
  void run_campaign(const Job& job);
  void end_interrupted(const Job& job);
  void update(const std::string& id, const std::function<void(RunInfo&)>& change, bool persistent);
  /// Sends the state of a run to the page; an older state is never sent after a newer one.
  void send_state(const std::string& id);
  void end(const std::string& id, RunState state, const std::string& message);
  RunInfo& at(const std::string& id);
  /// Returns the keys in which the model differs from that of the last run with this title; empty if there is none.
  std::string changed_since_last(const std::string& title, const std::string& text) const;
  /// Returns a run; HttpError 409 for a case of a study.
  RunInfo find_whole(const std::string& id) const;
  bool closing() const;

  std::filesystem::path folder_;
  EventHub& events_;
  LiveHistory live_;
  FileLock& files_ = hdf5_lock();

  std::mutex sending_;        ///< Keeps the order of the states sent; locked before `mutex_`.
  mutable std::mutex mutex_;  ///< Guards the members below.
  std::condition_variable changed_;
  std::vector<RunInfo> runs_;
  std::deque<Job> waiting_;
  bool closing_ = false;

  std::atomic<bool> stop_{false};  ///< True if the active run must end.
  RunSlice slice_;
  std::thread worker_;  ///< Last member: uses the others.
};

}  // namespace overbend
