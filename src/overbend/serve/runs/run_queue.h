/// Runs one after the other in a thread of its own, whether anybody looks on or not.
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
  /// Runs have their folders below `folder`; those that are there are listed.
  RunQueue(std::filesystem::path folder, EventHub& events);
  /// Stops the run that is running, at a checkpoint; the others are cancelled.
  ~RunQueue();
  RunQueue(const RunQueue&) = delete;
  RunQueue& operator=(const RunQueue&) = delete;

  /// Queues a run of the model as it is now: what `order` says of kind, title, duration, seeds and comparison. Throws
  /// HttpFault when the folder cannot be.
  /// `study`: text of the study file, where that is the kind.
  RunInfo add(const ModelText& model, const RunRecord& order, const std::string& study = "");
  /// A stopped dynamic run keeps what it has computed: results so far, and the checkpoint to continue from. So
  /// does every case of a study. HttpFault 409 for a single case.
  RunInfo cancel(const std::string& id);
  /// Gives a run the user's name and note.
  RunInfo annotate(const std::string& id, const std::string& name, const std::string& note);
  /// Removes a run that has ended, with its folder and its cases; HttpFault 409 while it is in progress.
  void remove(const std::string& id);
  /// Queues an interrupted run again, to continue from its checkpoint with the text it was started with. HttpFault 409
  /// when it cannot be resumed.
  RunInfo resume(const std::string& id);

  /// Newest first.
  std::vector<RunInfo> list() const;
  /// HttpFault 404 when there is none.
  RunInfo find(const std::string& id) const;
  /// Keys with their values in which a model's text differs from that which a run was started with, in words; empty
  /// where there is none. HttpFault 404 where the run has no copy of its model.
  std::string changes_since(const std::string& id, const std::string& text) const;
  std::filesystem::path folder(const RunInfo& run) const { return folder_of(run, folder_); }

  const LiveHistory& live() const { return live_; }
  /// Held by whoever reads or writes files of results: the library below them serves one thread alone.
  FileLock& files() { return files_; }

 private:
  void close();
  struct Job {
    RunInfo run;
    ModelText model;
    bool resume = false;
  };
  class Watch;        ///< How a study is followed.
  class MatrixWatch;  ///< The same of a study file's.

  void work();
  void run(const Job& job);
  void run_static(const Job& job);
  void run_dynamic(const Job& job);
  void run_matrix(const Job& job);
  void end_interrupted(const Job& job);
  void update(const std::string& id, const std::function<void(RunInfo&)>& change, bool lasting);
  void end(const std::string& id, RunState state, const std::string& message);
  RunInfo& at(const std::string& id);
  /// Keys in which the model differs from that of the last run of this kind of name; empty where there is none.
  std::string changed_since_last(const std::string& title, const std::string& text) const;
  /// HttpFault 409 for a case of a study.
  RunInfo find_whole(const std::string& id) const;
  bool closing() const;

  std::filesystem::path folder_;
  EventHub& events_;
  LiveHistory live_;
  FileLock& files_ = hdf5_lock();

  mutable std::mutex mutex_;  ///< Of what follows.
  std::condition_variable changed_;
  std::vector<RunInfo> runs_;
  std::deque<Job> waiting_;
  bool closing_ = false;

  std::atomic<bool> stop_{false};  ///< The run that is running shall end.
  std::thread worker_;             ///< The last member: it uses the others.
};

}  // namespace overbend
