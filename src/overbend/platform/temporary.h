/// Temporary files and folders.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace overbend {

/// Creates a folder for this user alone and returns its path. The name is `stem` and six letters or digits that no
/// process can predict.
std::filesystem::path make_unique_folder(const std::filesystem::path& parent, const std::string& stem,
                                         std::error_code& error);

/// Returns the system's folder for temporary files, or the current folder if there is none.
std::filesystem::path temporary_folder();

/// Folder in temporary_folder(), or in the current folder if that cannot be written. The destructor removes it with its
/// content.
class ScratchFolder {
 public:
  /// If it cannot be created, `error` is set and the path is empty.
  explicit ScratchFolder(std::error_code& error);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace overbend
