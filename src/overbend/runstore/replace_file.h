/// Atomic replacement of the content of a user's file.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace overbend {

/// Replaces the content of the file by `text`, or creates the file. The text is written to a file with an unpredictable
/// name in the same folder, synced to disk, then renamed. Mode, owner and group of an existing file are kept; a
/// symbolic link is kept and its target replaced. `last_look` is called just before the rename; if it throws, nothing
/// is changed.
///
/// Throws std::runtime_error with the reason if that fails: not a regular file, a broken link, a write-protected file,
/// an owner that cannot be kept, a disk error.
void replace_file(const std::filesystem::path& file, std::string_view text,
                  const std::function<void()>& last_look = nullptr);

}  // namespace overbend
