/// Who works at what, among processes that share a folder, also one of a network: by files that are made exclusively,
/// without locks.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>

namespace overbend {

/// This process as others see it: a file that is touched now and then while it lives.
///
/// Others on the same machine ask the system whether it lives; on another machine one whose file has not been touched
/// for two minutes counts as dead, by the clock of the file system alone.
class WorkerFile {
 public:
  /// Makes the file in `folder`, and the folder. Throws FileFault (runstore/append_file.h).
  explicit WorkerFile(const std::filesystem::path& folder);
  ~WorkerFile();
  WorkerFile(const WorkerFile&) = delete;
  WorkerFile& operator=(const WorkerFile&) = delete;

  /// Takes the task whose claims are files `stem`.0, `stem`.1, ...: false where a worker that lives has it. The claim
  /// of a dead worker stays, and the next number is made: exactly one process can. Throws FileFault.
  bool claim(const std::filesystem::path& stem) const;

  const std::string& name() const { return name_; }

 private:
  void stay_alive();
  bool lives(const std::string& worker) const;
  bool touched_lately(const std::filesystem::path& file) const;

  std::filesystem::path folder_, file_;
  std::string name_;
  std::mutex mutex_;
  std::condition_variable ending_;
  bool ended_ = false;
  std::thread pulse_;
};

/// Removes what claim() made, once the task is done for good: whoever claims it anew must look whether it is.
void release_claims(const std::filesystem::path& stem) noexcept;

}  // namespace overbend
