/// Distribution of tasks among processes that share a folder, also a network folder: exclusive creation of files,
/// without locks.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>

namespace overbend {

/// File that represents this process to others and is touched periodically while the process lives.
///
/// Processes on the same machine ask the system whether it lives. On another machine, a process whose file has not been
/// touched for two minutes counts as dead, by the clock of the file system alone.
class WorkerFile {
 public:
  /// Creates the file in `folder`, and the folder. Throws FileError (runstore/append_file.h).
  explicit WorkerFile(const std::filesystem::path& folder);
  ~WorkerFile();
  WorkerFile(const WorkerFile&) = delete;
  WorkerFile& operator=(const WorkerFile&) = delete;

  /// Claims the task whose claim files are `stem`.0, `stem`.1, ...: returns false if a living worker has it. The claim
  /// of a dead worker remains and the next number is created, which exactly one process can do. Throws FileError.
  bool claim(const std::filesystem::path& stem) const;

  const std::string& name() const { return name_; }

 private:
  void touch_periodically();
  bool is_alive(const std::string& worker) const;
  bool touched_recently(const std::filesystem::path& file) const;

  std::filesystem::path folder_, file_;
  std::string name_;
  std::mutex mutex_;
  std::condition_variable ending_;
  bool ended_ = false;
  std::thread touch_thread_;
};

/// Removes the files of claim() after the task is done. A process that claims the task again must check whether it is
/// done.
void release_claims(const std::filesystem::path& stem) noexcept;

}  // namespace overbend
