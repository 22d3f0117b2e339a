#include "platform/lock.h"

#include "platform/windows/system.h"

namespace overbend {

std::error_code lock_file(const File& file, LockKind kind) {
  // A byte far beyond the content: a lock keeps others from reading and writing its range.
  OVERLAPPED place{};
  place.OffsetHigh = 0x7fffffff;
  const DWORD exclusive = kind == LockKind::exclusive ? LOCKFILE_EXCLUSIVE_LOCK : 0U;
  return error_unless(
      ::LockFileEx(reinterpret_cast<HANDLE>(file.handle()), LOCKFILE_FAIL_IMMEDIATELY | exclusive, 0, 1, 0, &place));
}

File lock_folder(const std::filesystem::path& folder) {
  // The handle may add files and does not share that: a second one fails. Files are added and the folder is removed
  // without it.
  const HANDLE handle =
      ::CreateFileW(system_path(folder).c_str(), FILE_ADD_FILE, FILE_SHARE_READ | FILE_SHARE_DELETE, nullptr,
                    OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS | FILE_FLAG_OPEN_REPARSE_POINT, nullptr);
  return File(reinterpret_cast<std::intptr_t>(handle));
}

}  // namespace overbend
