/// File that only grows, for data that a long computation writes in small parts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "platform/file.h"
#include "runstore/checksum.h"

namespace overbend {

/// Error of the operating system when reading or writing a file, with its reason.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws FileError with the file, the action that failed ("written", "read") and the reason.
[[noreturn]] void throw_file_error(const std::filesystem::path& file, const char* tried, std::error_code reason);

/// Returns the reason, from errno, why a function of the standard library failed.
std::error_code library_error();

/// Checksums of a growing sequence of numbers: one for each block of 64 KiB and one for the incomplete block. A changed
/// bit changes the checksum of its block.
class BlockSums {
 public:
  static constexpr std::size_t kBlock = 8192;  ///< Numbers per block.

  BlockSums() { sums_.reserve(std::size_t{1} << 14); }  // a gigabyte without another allocation
  /// Continues the checksums with further numbers.
  void add(std::span<const double> values);
  /// Returns the checksums of the full blocks, then that of the incomplete one.
  std::vector<std::uint64_t> all() const;
  /// Returns the checksum of the block `index`, full or incomplete.
  std::uint64_t block_sum(std::size_t index) const { return index < sums_.size() ? sums_[index] : begun_; }
  /// Returns the checksum of numbers, continued from `onto`.
  static std::uint64_t sum(std::span<const double> values, std::uint64_t onto = kChecksumStart);

 private:
  std::vector<std::uint64_t> sums_;
  std::uint64_t begun_ = kChecksumStart;
  std::size_t held_ = 0;  ///< Numbers in the incomplete block.
};

/// Appends through a buffer of fixed size, without allocation. Buffered data is lost if the process dies; flushed data
/// only if the machine fails; synced data in neither case. Data read back is verified with the checksums of the
/// appended data. All functions throw std::runtime_error with the reason if the disk reports an error or returns other
/// data.
class AppendFile {
 public:
  AppendFile() = default;
  /// Opens or creates the file and truncates it to `keep` bytes. Rejects a file as damaged, and leaves it unchanged, if
  /// it is shorter or does not have the checksums `sums` (of sums() at that length).
  AppendFile(std::filesystem::path file, std::uint64_t keep, const std::vector<std::uint64_t>& sums);

  /// Appends numbers to the buffer, which is flushed when full.
  void append(std::span<const double> values);
  void flush();  ///< Writes the buffer to the file.
  void sync();   ///< Flushes, and waits until the data are on disk.
  /// Size [bytes], including the buffer.
  std::uint64_t size() const { return written_ + filled_; }
  /// Reads numbers starting at `offset` [bytes]; the file must have been flushed.
  void read(std::uint64_t offset, std::span<double> values) const;
  /// Returns the checksums of all numbers appended so far; see BlockSums::all().
  std::vector<std::uint64_t> sums() const { return sums_.all(); }

 private:
  void read_raw(std::uint64_t offset, std::span<double> values) const;
  void verify(const std::vector<std::uint64_t>& sums);
  [[noreturn]] void throw_damaged(std::uint64_t offset) const;

  std::filesystem::path path_;
  File file_;
  std::vector<std::byte> buffer_;
  std::size_t filled_ = 0;     ///< Bytes in the buffer.
  std::uint64_t written_ = 0;  ///< Bytes in the file.
  BlockSums sums_;
};

/// Writes a whole file. Throws std::runtime_error.
void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes);

/// Same with text.
void write_text(const std::filesystem::path& file, const std::string& text);

/// Writes a whole file to the disk (not only to the system's cache). Throws std::runtime_error.
void write_synced(const std::filesystem::path& file, std::span<const std::byte> bytes);

/// Renames a part file that is complete; an existing file at `file` is replaced in one step. Throws FileError.
void name_complete_file(const std::filesystem::path& partial, const std::filesystem::path& file);

/// Makes renames in the folder durable on disk. Throws std::runtime_error.
void sync_folder(const std::filesystem::path& folder);

}  // namespace overbend
