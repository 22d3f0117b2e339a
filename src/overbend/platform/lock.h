/// Locks among processes. They end with the file object that holds them, also if the process is killed.
#pragma once

#include "platform/file.h"

namespace overbend {

enum class LockKind { shared, exclusive };

/// Locks an open file without waiting. Returns std::errc::resource_unavailable_try_again if another holds the lock.
std::error_code lock_file(const File& file, LockKind kind);

/// Opens and locks a folder, without waiting. Not open if another holds the lock, or if it is no folder or a link.
File lock_folder(const std::filesystem::path& folder);

}  // namespace overbend
