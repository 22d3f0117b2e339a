/// Background queue of runs, executed one after the other, independent of open pages.
#pragma once

#include <atomic>
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

namespace overbend {

/// All functions may be called from any thread.
class RunQueue {
 public:
  /// Runs are stored in folders below `folder`; existing ones are listed.
  RunQueue(std::filesystem::path folder, EventHub& events);
  /// Stops the active run at a checkpoint and cancels the waiting ones.
  ~RunQueue();
  RunQueue(const RunQueue&) = delete;
  RunQueue& operator=(const RunQueue&) = delete;

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
  void run(const Job& job);
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
  std::thread worker_;             ///< Last member: uses the others.
};

}  // namespace overbend
