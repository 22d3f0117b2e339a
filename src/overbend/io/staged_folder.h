/// A folder of results that is there whole or not at all.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "io/staging_lock.h"

namespace overbend {

/// A folder that can not be made or written, with the reason.
class UnusableFolder : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Files are written to path(), a temporary folder inside the folder they are meant for (the same file system), and
/// renamed into place by commit(). Without commit() everything is removed again, also the folders that had to be made;
/// what a process that was killed left in the same folder is removed at the next start.
class StagedFolder {
 public:
  /// Makes `folder` and its parents where they are missing. Throws UnusableFolder with the reason when it can not be
  /// written.
  explicit StagedFolder(const std::filesystem::path& folder);
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  const std::filesystem::path& path() const { return staging_.path; }

  /// Renames all files into place over older ones, `last` at the end: whoever waits for it finds the others new.
  void commit(const std::string& last);

 private:
  void remove_traces() noexcept;

  std::filesystem::path folder_;
  StagingPlace staging_;
  std::filesystem::path made_;  ///< The topmost folder that had to be made; empty: none.
};

}  // namespace overbend
