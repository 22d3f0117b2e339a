#include "platform/lock.h"

#include <sys/file.h>

#include <cerrno>

namespace overbend {

std::error_code lock_file(const File& file, LockKind kind) {
  const int operation = kind == LockKind::shared ? LOCK_SH : LOCK_EX;
  if (::flock(static_cast<int>(file.handle()), operation | LOCK_NB) == 0) return {};
  return {errno, std::generic_category()};  // EWOULDBLOCK if another holds it
}

File lock_folder(const std::filesystem::path& folder) {
  std::error_code error;
  File opened(folder, File::kRead | File::kFolder | File::kNoLink, error);
  if (opened.is_open() && lock_file(opened, LockKind::exclusive)) return {};
  return opened;
}

}  // namespace overbend
