#include "platform/file.h"

#include <algorithm>
#include <thread>

#include "platform/windows/system.h"

namespace overbend {
namespace fs = std::filesystem;
namespace {

constexpr DWORD kShareAll = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

HANDLE system_handle(const File& file) {
  return reinterpret_cast<HANDLE>(file.handle());
}

DWORD system_disposition(unsigned flags) {
  if ((flags & File::kCreate) == 0) return (flags & File::kTruncate) != 0 ? TRUNCATE_EXISTING : OPEN_EXISTING;
  if ((flags & File::kExclusive) != 0) return CREATE_NEW;
  return (flags & File::kTruncate) != 0 ? CREATE_ALWAYS : OPEN_ALWAYS;
}

DWORD system_attributes(unsigned flags) {
  DWORD attributes = FILE_ATTRIBUTE_NORMAL;
  if ((flags & File::kFolder) != 0) attributes |= FILE_FLAG_BACKUP_SEMANTICS;
  if ((flags & File::kNoLink) != 0) attributes |= FILE_FLAG_OPEN_REPARSE_POINT;
  return attributes;
}

OVERLAPPED make_position(std::uint64_t offset) {
  OVERLAPPED position{};
  position.Offset = static_cast<DWORD>(offset);
  position.OffsetHigh = static_cast<DWORD>(offset >> 32U);
  return position;
}

/// Length of a part for the system, which counts in 32 bits.
DWORD part_length(std::size_t size) {
  return static_cast<DWORD>(std::min<std::size_t>(size, std::size_t{1} << 30U));
}

std::uint64_t join(DWORD high, DWORD low) {
  return (std::uint64_t{high} << 32U) | low;
}

std::optional<FileIdentity> find_identity(HANDLE handle) {
  BY_HANDLE_FILE_INFORMATION found{};
  FILE_BASIC_INFO times{};
  if (::GetFileInformationByHandle(handle, &found) == FALSE) return std::nullopt;
  if (::GetFileInformationByHandleEx(handle, FileBasicInfo, &times, sizeof times) == FALSE) return std::nullopt;
  constexpr std::int64_t kStartOf1970 = 116'444'736'000'000'000, kTick = 100;  // in ticks of 100 ns since 1601; [ns]
  return FileIdentity{found.dwVolumeSerialNumber, join(found.nFileIndexHigh, found.nFileIndexLow),
                      join(found.nFileSizeHigh, found.nFileSizeLow),
                      (times.ChangeTime.QuadPart - kStartOf1970) * kTick};
}

/// Opens a file or folder for a question about it, which no other program can prevent.
Handle open_for(DWORD access, const fs::path& path) {
  return Handle(::CreateFileW(system_path(path).c_str(), access, kShareAll, nullptr, OPEN_EXISTING,
                              FILE_FLAG_BACKUP_SEMANTICS, nullptr));
}

}  // namespace

File::File(const fs::path& file, unsigned flags, std::error_code& error, fs::perms /*permissions*/) {
  const DWORD access =
      ((flags & kRead) != 0 ? GENERIC_READ : 0U) | ((flags & (kWrite | kTruncate)) != 0 ? GENERIC_WRITE : 0U);
  const HANDLE handle = ::CreateFileW(system_path(file).c_str(), access, kShareAll, nullptr, system_disposition(flags),
                                      system_attributes(flags), nullptr);
  handle_ = reinterpret_cast<std::intptr_t>(handle);
  error = error_unless(is_open() ? TRUE : FALSE);
}

std::error_code File::close() {
  const std::intptr_t open = std::exchange(handle_, kNone);
  return open != kNone ? error_unless(::CloseHandle(reinterpret_cast<HANDLE>(open))) : std::error_code();
}

std::size_t File::read(std::uint64_t offset, std::span<std::byte> bytes, std::error_code& error) const {
  error.clear();
  std::size_t total = 0;
  while (total < bytes.size()) {
    OVERLAPPED position = make_position(offset + total);
    DWORD count = 0;
    if (::ReadFile(system_handle(*this), bytes.data() + total, part_length(bytes.size() - total), &count, &position) ==
        FALSE) {
      if (::GetLastError() != ERROR_HANDLE_EOF) error = last_error();
      break;
    }
    if (count == 0) break;
    total += count;
  }
  return total;
}

std::error_code File::write(std::uint64_t offset, std::span<const std::byte> bytes) const {
  while (!bytes.empty()) {
    OVERLAPPED position = make_position(offset);
    DWORD count = 0;
    if (::WriteFile(system_handle(*this), bytes.data(), part_length(bytes.size()), &count, &position) == FALSE) {
      return last_error();
    }
    offset += count;
    bytes = bytes.subspan(count);
  }
  return {};
}

std::uint64_t File::size(std::error_code& error) const {
  LARGE_INTEGER size{};
  error = error_unless(::GetFileSizeEx(system_handle(*this), &size));
  return static_cast<std::uint64_t>(size.QuadPart);
}

std::error_code File::resize(std::uint64_t size) const {
  FILE_END_OF_FILE_INFO end{};
  end.EndOfFile.QuadPart = static_cast<LONGLONG>(size);
  return error_unless(::SetFileInformationByHandle(system_handle(*this), FileEndOfFileInfo, &end, sizeof end));
}

std::error_code File::sync() const {
  if (::FlushFileBuffers(system_handle(*this)) != FALSE) return {};
  // A file opened to be read has nothing to write, and the system itself makes the names in a folder durable.
  return ::GetLastError() == ERROR_ACCESS_DENIED ? std::error_code() : last_error();
}

std::optional<FileIdentity> File::identity() const {
  return find_identity(system_handle(*this));
}

std::optional<FileIdentity> file_identity(const fs::path& file) {
  const Handle opened = open_for(FILE_READ_ATTRIBUTES, file);
  return opened ? find_identity(opened.get()) : std::nullopt;
}

std::error_code rename_file(const fs::path& from, const fs::path& to) {
  const std::wstring source = system_path(from), target = system_path(to);
  constexpr int kAttempts = 20;
  constexpr std::chrono::milliseconds kPause{25};
  for (int attempt = 1;; ++attempt) {
    if (::MoveFileExW(source.c_str(), target.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) != FALSE) {
      return {};
    }
    const DWORD error = ::GetLastError();
    // Programs that look through new files, and readers of the target, hold a file for a moment.
    const bool held = error == ERROR_SHARING_VIOLATION || error == ERROR_ACCESS_DENIED;
    if (!held || attempt == kAttempts) return system_error(error);
    std::this_thread::sleep_for(kPause);
  }
}

std::error_code exchange_folders(const fs::path& /*first*/, const fs::path& /*second*/) {
  return make_error_code(std::errc::function_not_supported);
}

std::error_code check_writable(const fs::path& path) {
  std::error_code ignored;
  const bool folder = fs::is_directory(path, ignored);
  // For a folder the access to add files, for a file the access to write.
  return open_for(folder ? FILE_ADD_FILE : FILE_WRITE_DATA, path) ? std::error_code() : last_error();
}

std::error_code copy_ownership(const fs::path& /*from*/, const fs::path& /*to*/) {
  return {};
}

bool is_own_file(const fs::path& /*path*/) {
  return true;
}

void touch_file(const fs::path& file) noexcept {
  std::error_code error;
  std::byte first{};
  // The file system sets its own time if the file is written.
  const File opened(file, File::kRead | File::kWrite, error);
  if (error || opened.read(0, {&first, 1}, error) == 0) return;
  static_cast<void>(opened.write(0, {&first, 1}));
}

}  // namespace overbend
