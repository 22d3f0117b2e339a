/// A folder of results that is there whole or not at all.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "runstore/append_file.h"

namespace overbend {

/// A folder that cannot be made or written, with the reason.
class UnusableFolder : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Files are written to path(), a temporary folder beside the target, which commit() moves into place in one step.
/// Files that the program wrote to the old folder are removed (it keeps a list in the file
/// `.overbend-files`); everything else in it belongs to the user and is kept, and commit() refuses to write over it.
/// Without commit() everything is removed
/// again, also the folders that had to be created.
///
/// Where folders cannot be exchanged (another file system than that of the folder above, a folder above that cannot
/// be written, the current folder, which would be pulled away under the shell) the temporary folder lies within, and
/// files are renamed one by one; when one refuses, those before it are put back.
class StagedFolder {
 public:
  /// Makes `folder` and its parents where they are missing, and removes what killed programs left beside it. Throws
  /// UnusableFolder with the reason when it cannot be written.
  explicit StagedFolder(const std::filesystem::path& folder);
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  const std::filesystem::path& path() const { return staging_; }

  /// Puts all files in place, `last` at the end where it goes one by one: a process that waits for it finds the others
  /// updated. `folders` are folders of results within that belong to these; those of the last time that are not among
  /// them go. Throws UnusableFolder, with the old folder as it was, also where a file of the user has one of the names.
  void commit(const std::string& last, const std::vector<std::string>& folders = {});

 private:
  void make_staging();
  bool exchange(const std::vector<std::string>& mine);
  void move_in(std::vector<std::string> names, const std::string& last, const std::vector<std::string>& before);
  void remove_traces() noexcept;

  std::filesystem::path folder_, staging_;
  std::filesystem::path made_;  ///< The topmost folder that had to be made; empty: none.
  bool beside_ = false;         ///< staging_ is no part of folder_.
  FileDescriptor lock_;         ///< On staging_: somebody is at work there.
};

/// Clears away the temporary folders in `parent` of programs that were killed at work: names of ours with a mark of
/// ours that nobody has locked. Does not throw.
void clear_leftovers(const std::filesystem::path& parent) noexcept;

/// Removes the results that a commit() put into the folder, what it takes to resume them, and the folder where nothing
/// else is in it. Does not throw.
void remove_results(const std::filesystem::path& folder) noexcept;

}  // namespace overbend
