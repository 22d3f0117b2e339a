/// A file that only grows, for data that a long computation hands over bit by bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace overbend {

/// Owns a descriptor of the operating system.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  explicit FileDescriptor(int id) : id_(id) {}
  ~FileDescriptor();
  FileDescriptor(FileDescriptor&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;

  int id() const { return id_; }

 private:
  int id_ = -1;
};

/// A file that the system does not let us write or read, with the reason: no fault of the program.
class FileFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws FileFault: the file, what was tried ("written", "read") and the reason that errno tells.
[[noreturn]] void refuse_file(const std::filesystem::path& file, const char* tried);

/// Appends through a buffer of fixed size, so that appending allocates nothing. What is in the buffer is lost with the
/// process; what was flushed only with the machine; what was synced not at all. All functions throw std::runtime_error
/// with the reason when the disk refuses.
class AppendFile {
 public:
  AppendFile() = default;
  /// Opens or makes the file and cuts it to `keep` bytes; a file shorter than that is refused as damaged.
  AppendFile(std::filesystem::path file, std::uint64_t keep);

  void append(std::span<const double> values);
  void flush();
  void sync();
  /// Bytes, with those in the buffer.
  std::uint64_t size() const { return written_ + filled_; }
  /// Reads numbers from `offset` [bytes] on; all of them must have been flushed.
  void read(std::uint64_t offset, std::span<double> values) const;

 private:
  std::filesystem::path file_;
  FileDescriptor descriptor_;
  std::vector<std::byte> buffer_;
  std::size_t filled_ = 0;     ///< Bytes in the buffer.
  std::uint64_t written_ = 0;  ///< Bytes in the file.
};

/// Writes all bytes from `offset` on: at their place, so that what is tried again after a fault does not stand there
/// twice. Throws std::runtime_error that names `file`.
void write_at(std::uint64_t offset, std::span<const std::byte> bytes, int id, const std::filesystem::path& file);

/// Writes a whole file. Throws std::runtime_error.
void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes);

/// Writes a whole file to the disk (not only to the system's cache). Throws std::runtime_error.
void write_synced(const std::filesystem::path& file, std::span<const std::byte> bytes);

/// Makes renames in the folder safe on disk. Throws std::runtime_error.
void sync_folder(const std::filesystem::path& folder);

}  // namespace overbend
