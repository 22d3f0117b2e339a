/// What in a folder of results the program wrote and what is the user's, and the marks of folders on their way there.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace overbend {

/// The list in a folder of results of what the program put there.
inline constexpr const char* kWrittenFiles = ".overbend-files";

struct WrittenFiles {
  std::vector<std::string> files;    ///< Names.
  std::vector<std::string> folders;  ///< Names of folders of results within.
};

/// Why files of these names cannot be put there: one is there that the program did not write. Nothing else: nothing.
std::optional<std::string> file_of_the_user(const std::filesystem::path& folder, const std::vector<std::string>& names);

/// Empty where there is no list. Names that lead out of the folder are passed over.
WrittenFiles read_written(const std::filesystem::path& folder);
/// Throws std::runtime_error when it cannot be written.
void write_written(const std::filesystem::path& folder, const WrittenFiles& written);

/// A staged folder: nothing in it is anybody's but the program's.
bool mark_staged(const std::filesystem::path& folder);
bool unmark_staged(const std::filesystem::path& folder);
bool is_marked_staged(const std::filesystem::path& folder);

/// A folder about to be exchanged for a new one at `place`.
bool mark_old(const std::filesystem::path& folder, const std::filesystem::path& place);
void unmark_old(const std::filesystem::path& folder);
bool is_mark(const std::string& name);

/// Gives what is in `from`, but folders and the names `mine`, a second name in `to`. The names are added to `shared`;
/// false where one could not be.
bool share_others(const std::filesystem::path& from, const std::filesystem::path& to,
                  const std::vector<std::string>& mine, std::vector<std::string>& shared);

/// Removes a marked folder: a staged one with all that is in it, an exchanged one after what is the user's has been
/// brought to the new. Another one is left alone.
void clear_marked(const std::filesystem::path& folder);

}  // namespace overbend
