/// Record of the files that the program wrote to a folder of results, as opposed to the user's, and marks of folders
/// during an exchange.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace overbend {

/// Name of the file, in a folder of results, that lists what the program wrote.
inline constexpr const char* kWrittenFiles = ".overbend-files";

struct WrittenFiles {
  std::vector<std::string> files;    ///< Names.
  std::vector<std::string> folders;  ///< Names of result folders inside the folder.
};

/// Returns an error message if one of these names exists in the folder but was not written by the program; nullopt
/// otherwise.
std::optional<std::string> find_user_file_conflict(const std::filesystem::path& folder,
                                                   const std::vector<std::string>& names);

/// Reads the list; empty if there is none. Names that lead out of the folder are ignored.
WrittenFiles read_written(const std::filesystem::path& folder);
/// Throws std::runtime_error if it cannot be written.
void write_written(const std::filesystem::path& folder, const WrittenFiles& written);

/// Sets, removes or tests the mark of a staged folder, which contains only the program's files.
bool mark_staged(const std::filesystem::path& folder);
bool unmark_staged(const std::filesystem::path& folder);
bool is_marked_staged(const std::filesystem::path& folder);

/// Marks a folder that is about to be exchanged for a new one at `place`.
bool mark_old(const std::filesystem::path& folder, const std::filesystem::path& place);
/// Removes that mark.
void unmark_old(const std::filesystem::path& folder);
/// True if `name` is that of one of these marks.
bool is_mark(const std::string& name);

/// Links the files of `from`, except folders and the names `mine`, into `to`. The names are added to `shared`; returns
/// false if a link fails.
bool link_user_files(const std::filesystem::path& from, const std::filesystem::path& to,
                     const std::vector<std::string>& mine, std::vector<std::string>& shared);

/// Removes a marked folder: a staged one with its content, an exchanged one after the user's files have been moved to
/// the new folder. An unmarked folder is left unchanged.
void clear_marked(const std::filesystem::path& folder);

}  // namespace overbend
