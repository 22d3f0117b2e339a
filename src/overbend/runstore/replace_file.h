/// A user's own file given a new content, whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace overbend {

/// Puts `text` in the place of the file's content, or makes the file. Written to a file of an unpredictable name in the
/// same folder, to the disk, then renamed. Mode, owner and group of an existing file are kept; a symbolic link stays
/// and what it leads to is replaced. `last_look` is called when only the renaming is left to do; what it throws leaves
/// everything as it was.
///
/// Throws std::runtime_error with the reason where that cannot be done: no plain file, a link that leads nowhere, a
/// write-protected file, one of an owner that cannot be kept, a disk that refuses.
void replace_file(const std::filesystem::path& file, std::string_view text,
                  const std::function<void()>& last_look = nullptr);

}  // namespace overbend
