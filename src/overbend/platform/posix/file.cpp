#include "platform/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

namespace overbend {
namespace fs = std::filesystem;
namespace {

std::error_code last_error() {
  return {errno, std::generic_category()};
}

/// Returns the error of a function of the system that returns 0 on success.
std::error_code error_if(int failed) {
  return failed != 0 ? last_error() : std::error_code();
}

int system_flags(unsigned flags) {
  const bool reads = (flags & File::kRead) != 0, writes = (flags & File::kWrite) != 0;
  int out = O_CLOEXEC | (writes ? (reads ? O_RDWR : O_WRONLY) : O_RDONLY);
  if ((flags & File::kCreate) != 0) out |= O_CREAT;
  if ((flags & File::kTruncate) != 0) out |= O_TRUNC;
  if ((flags & File::kExclusive) != 0) out |= O_EXCL;
  if ((flags & File::kFolder) != 0) out |= O_DIRECTORY;
  if ((flags & File::kNoLink) != 0) out |= O_NOFOLLOW;
  return out;
}

int descriptor(const File& file) {
  return static_cast<int>(file.handle());
}

FileIdentity make_identity(const struct stat& status) {
  constexpr std::int64_t kNanoseconds = 1'000'000'000;
  return {status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size),
          status.st_ctim.tv_sec * kNanoseconds + status.st_ctim.tv_nsec};
}

}  // namespace

File::File(const fs::path& file, unsigned flags, std::error_code& error, fs::perms permissions)
    : handle_(::open(file.c_str(), system_flags(flags), static_cast<mode_t>(permissions))) {
  error = error_if(is_open() ? 0 : -1);
}

std::error_code File::close() {
  const int open = static_cast<int>(std::exchange(handle_, kNone));
  return error_if(open >= 0 ? ::close(open) : 0);
}

std::size_t File::read(std::uint64_t offset, std::span<std::byte> bytes, std::error_code& error) const {
  error.clear();
  std::size_t total = 0;
  while (total < bytes.size()) {
    const ssize_t count =
        ::pread(descriptor(*this), bytes.data() + total, bytes.size() - total, static_cast<off_t>(offset + total));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) error = last_error();
    if (count <= 0) break;
    total += static_cast<std::size_t>(count);
  }
  return total;
}

std::error_code File::write(std::uint64_t offset, std::span<const std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::pwrite(descriptor(*this), bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return last_error();
    offset += static_cast<std::uint64_t>(count);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return {};
}

std::uint64_t File::size(std::error_code& error) const {
  const off_t length = ::lseek(descriptor(*this), 0, SEEK_END);
  error = error_if(length < 0 ? -1 : 0);
  return length < 0 ? 0 : static_cast<std::uint64_t>(length);
}

std::error_code File::resize(std::uint64_t size) const {
  return error_if(::ftruncate(descriptor(*this), static_cast<off_t>(size)));
}

std::error_code File::sync() const {
  return error_if(::fsync(descriptor(*this)));
}

std::optional<FileIdentity> File::identity() const {
  struct stat status {};
  if (::fstat(descriptor(*this), &status) != 0) return std::nullopt;
  return make_identity(status);
}

std::optional<FileIdentity> file_identity(const fs::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return std::nullopt;
  return make_identity(status);
}

std::error_code rename_file(const fs::path& from, const fs::path& to) {
  return error_if(::rename(from.c_str(), to.c_str()));
}

std::error_code exchange_folders(const fs::path& first, const fs::path& second) {
#ifdef RENAME_EXCHANGE
  return error_if(::renameat2(AT_FDCWD, first.c_str(), AT_FDCWD, second.c_str(), RENAME_EXCHANGE));
#else
  static_cast<void>(first), static_cast<void>(second);
  return make_error_code(std::errc::function_not_supported);
#endif
}

std::error_code check_writable(const fs::path& path) {
  std::error_code ignored;
  return error_if(::access(path.c_str(), fs::is_directory(path, ignored) ? W_OK | X_OK : W_OK));
}

std::error_code copy_ownership(const fs::path& from, const fs::path& to) {
  struct stat source {
  }, target{};
  if (::stat(from.c_str(), &source) != 0 || ::stat(to.c_str(), &target) != 0) return last_error();
  if (source.st_uid == target.st_uid && source.st_gid == target.st_gid) return {};
  return error_if(::chown(to.c_str(), source.st_uid, source.st_gid));
}

bool is_own_file(const fs::path& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && status.st_uid == ::geteuid();
}

void touch_file(const fs::path& file) noexcept {
  ::utimensat(AT_FDCWD, file.c_str(), nullptr, 0);
}

}  // namespace overbend
