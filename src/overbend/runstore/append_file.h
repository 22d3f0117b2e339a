/// A file that only grows, for data that a long computation hands over bit by bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "runstore/checksum.h"

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

/// Throws FileFault: the file, what was tried ("written", "read") and the reason from errno.
[[noreturn]] void refuse_file(const std::filesystem::path& file, const char* tried);

/// Checksums of a growing row of numbers, one for each block of 64 KiB and one for the incomplete block. A changed bit
/// changes the checksum of its block.
class BlockSums {
 public:
  static constexpr std::size_t kBlock = 8192;  ///< Numbers.

  BlockSums() { sums_.reserve(std::size_t{1} << 14); }  // a gigabyte without another allocation
  void add(std::span<const double> values);
  /// Of the full blocks, then of the incomplete one.
  std::vector<std::uint64_t> all() const;
  /// Of the block `index`, full or incomplete.
  std::uint64_t of(std::size_t index) const { return index < sums_.size() ? sums_[index] : begun_; }
  static std::uint64_t sum(std::span<const double> values, std::uint64_t onto = kChecksumStart);

 private:
  std::vector<std::uint64_t> sums_;
  std::uint64_t begun_ = kChecksumStart;
  std::size_t held_ = 0;  ///< Numbers in the incomplete block.
};

/// Appends through a buffer of fixed size, so that appending allocates nothing. What is in the buffer is lost with the
/// process; what was flushed only with the machine; what was synced not at all. What is read again is compared with the
/// checksums of what was appended. All functions throw std::runtime_error with the reason when the disk refuses or
/// gives back something else.
class AppendFile {
 public:
  AppendFile() = default;
  /// Opens or makes the file and cuts it to `keep` bytes. A file that is shorter, or whose content has not the
  /// checksums `sums` (of sums(), when it had that length), is refused as damaged and left as it is.
  AppendFile(std::filesystem::path file, std::uint64_t keep, const std::vector<std::uint64_t>& sums);

  void append(std::span<const double> values);
  void flush();
  void sync();
  /// Bytes, with those in the buffer.
  std::uint64_t size() const { return written_ + filled_; }
  /// Reads numbers from `offset` [bytes] on; the file must have been flushed.
  void read(std::uint64_t offset, std::span<double> values) const;
  std::vector<std::uint64_t> sums() const { return sums_.all(); }

 private:
  void read_raw(std::uint64_t offset, std::span<double> values) const;
  void verify(const std::vector<std::uint64_t>& sums);
  [[noreturn]] void refuse_damaged(std::uint64_t offset) const;

  std::filesystem::path file_;
  FileDescriptor descriptor_;
  std::vector<std::byte> buffer_;
  std::size_t filled_ = 0;     ///< Bytes in the buffer.
  std::uint64_t written_ = 0;  ///< Bytes in the file.
  BlockSums sums_;
};

/// Writes all bytes from `offset` on: at their place, so that a retry after a fault does not write them
/// twice. Throws std::runtime_error that names `file`.
void write_at(std::uint64_t offset, std::span<const std::byte> bytes, int id, const std::filesystem::path& file);

/// Writes a whole file. Throws std::runtime_error.
void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes);

/// The same with text.
void write_text(const std::filesystem::path& file, const std::string& text);

/// Writes a whole file to the disk (not only to the system's cache). Throws std::runtime_error.
void write_synced(const std::filesystem::path& file, std::span<const std::byte> bytes);

/// Makes renames in the folder safe on disk. Throws std::runtime_error.
void sync_folder(const std::filesystem::path& folder);

}  // namespace overbend
