/// Temporary folders named .overbend-XXXXXX: who is at work in them, and which are left over from a process that was
/// killed.
#pragma once

#include <filesystem>
#include <optional>

#include "io/append_file.h"

namespace overbend {

/// A new folder `.overbend-XXXXXX` in `folder`, and the lock that says that a process is at work there; the system
/// takes it back with the process, however that ends.
struct StagingPlace {
  std::filesystem::path path;
  FileDescriptor lock;
};

/// Nothing, with the reason in errno, where the folder can not be made.
std::optional<StagingPlace> make_staging(const std::filesystem::path& folder);

/// Removes the folders of that kind in `folder` in which nobody is at work. Folders of other users, of other names,
/// links, and all on file systems without locks are left alone. Never throws: what can not be removed stays.
void remove_abandoned_staging(const std::filesystem::path& folder) noexcept;

}  // namespace overbend
