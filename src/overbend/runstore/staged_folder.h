/// Folder of results that is written completely or not at all.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "platform/file.h"

namespace overbend {

/// Error: a folder cannot be created or written, with the reason.
class UnusableFolder : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Files are written to path(), a temporary folder next to the target, which commit() moves into place in one step.
/// Files that the program wrote to the old folder are removed (listed in the file `.overbend-files`); all others belong
/// to the user and are kept, and commit() does not overwrite them. Without commit() everything is removed again,
/// including created parent folders.
///
/// If folders cannot be exchanged (the parent folder is on another file system or cannot be written, or the target
/// is the current folder of the shell) the temporary folder lies inside the target and files are renamed one by one; if
/// one rename fails, the previous ones are undone.
class StagedFolder {
 public:
  /// Creates `folder` and its parents if they are missing, and removes temporary folders of killed programs next to it.
  /// Throws UnusableFolder with the reason if it cannot be written.
  explicit StagedFolder(const std::filesystem::path& folder);
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  const std::filesystem::path& path() const { return staging_; }

  /// Puts all files in place, `last` at the end if they are renamed one by one: a process that waits for it finds the
  /// others updated. `folders`: folders of results inside this one that belong to it; earlier ones that are not listed
  /// are removed. Throws UnusableFolder, with the old folder unchanged, also if a file of the user has one of the
  /// names.
  void commit(const std::string& last, const std::vector<std::string>& folders = {});

 private:
  void make_staging();
  bool exchange(const std::vector<std::string>& mine);
  void rename_one_by_one(std::vector<std::string> names, const std::string& last,
                         const std::vector<std::string>& before);
  void remove_traces() noexcept;

  std::filesystem::path folder_, staging_;
  std::filesystem::path made_;   ///< Topmost folder that was created; empty if none.
  bool next_to_target_ = false;  ///< True if staging_ is not inside folder_.
  File lock_;                    ///< Lock on staging_: it is in use.
};

/// Removes temporary folders in `parent` left by killed programs: those with our names and marks that are not locked.
/// Does not throw.
void clear_leftovers(const std::filesystem::path& parent) noexcept;

/// Removes the results that a commit() put into the folder, the data for resuming them, and the folder if it is
/// otherwise empty. Does not throw.
void remove_results(const std::filesystem::path& folder) noexcept;

}  // namespace overbend
