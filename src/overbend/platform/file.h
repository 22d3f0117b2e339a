/// Files of the operating system: access by offset, durability, identity, ownership.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

namespace overbend {

/// A file and its version.
struct FileIdentity {
  std::uint64_t volume = 0, number = 0;  ///< The pair identifies the file.
  std::uint64_t length = 0;              ///< [bytes]
  std::int64_t change_time = 0;          ///< Time of the last change of content or status since 1970 [ns].
  bool operator==(const FileIdentity&) const = default;
};

/// Open file; the destructor closes it. Other processes may read, write, rename and delete it meanwhile. Child
/// processes do not inherit it.
class File {
 public:
  /// Ways to open a file, combined by `|`.
  enum Flag : unsigned {
    kRead = 1,
    kWrite = 2,
    kCreate = 4,      ///< Creates the file if it is missing.
    kTruncate = 8,    ///< Empties the file.
    kExclusive = 16,  ///< With kCreate: fails if the file exists.
    kFolder = 32,     ///< Opens a folder, for sync().
    kNoLink = 64,     ///< Fails if the last part of the path is a link.
  };

  File() = default;
  /// If it fails, `error` is set and the object is not open. `permissions` are those of a file that is created, less
  /// those that the system withholds from all files of the user.
  File(const std::filesystem::path& file, unsigned flags, std::error_code& error,
       std::filesystem::perms permissions = std::filesystem::perms(0644));
  explicit File(std::intptr_t handle) : handle_(handle) {}  ///< Takes over an open handle of the system; -1: none.
  ~File() { close(); }
  File(File&& source) noexcept : handle_(std::exchange(source.handle_, kNone)) {}
  File& operator=(File&& source) noexcept {
    std::swap(handle_, source.handle_);
    return *this;
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  bool is_open() const { return handle_ != kNone; }
  std::error_code close();

  /// Reads to the end of `bytes` or of the file and returns the number of bytes read.
  std::size_t read(std::uint64_t offset, std::span<std::byte> bytes, std::error_code& error) const;
  /// Writes all bytes at `offset`, so that a retry after an error does not write them twice.
  std::error_code write(std::uint64_t offset, std::span<const std::byte> bytes) const;
  std::uint64_t size(std::error_code& error) const;  ///< [bytes]
  std::error_code resize(std::uint64_t size) const;
  /// Waits until the data are on disk; for a folder, the names in it.
  std::error_code sync() const;
  std::optional<FileIdentity> identity() const;

  std::intptr_t handle() const { return handle_; }  ///< Handle of the system.

 private:
  static constexpr std::intptr_t kNone = -1;
  std::intptr_t handle_ = kNone;
};

/// Returns the identity of a file or folder at the end of links; nullopt if there is none.
std::optional<FileIdentity> file_identity(const std::filesystem::path& file);

/// Renames a file; an existing one at `to` is replaced in one step. On Windows it waits for up to half a second for
/// programs that have the existing one open.
std::error_code rename_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Exchanges the names of two folders in one step. Many systems and file systems do not support it.
std::error_code exchange_folders(const std::filesystem::path& first, const std::filesystem::path& second);

/// Returns an error if this process may not write the file, or may not create files in the folder.
std::error_code check_writable(const std::filesystem::path& path);

/// Gives `to` the owner and the group of `from`. Without effect on Windows, where the folder determines the access.
std::error_code copy_ownership(const std::filesystem::path& from, const std::filesystem::path& to);

/// True if the file or folder belongs to the user of this process.
bool is_own_file(const std::filesystem::path& path);

/// Sets the time of the last write to the current time of the file system, which may differ from that of this machine.
/// Errors are ignored.
void touch_file(const std::filesystem::path& file) noexcept;

}  // namespace overbend
