#include "runstore/append_file.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "base/bit_cast.h"
#include "base/interruption.h"
#include "base/require.h"

namespace overbend {
namespace {

static_assert(std::endian::native == std::endian::little, "the files of a run are little-endian");

constexpr std::size_t kBufferBytes = std::size_t{1} << 20;
constexpr unsigned kNewContent = File::kWrite | File::kCreate | File::kTruncate;

/// Throws FileError if there is a reason.
void require_success(std::error_code reason, const std::filesystem::path& file, const char* tried) {
  if (reason) throw_file_error(file, tried, reason);
}

File open_file(const std::filesystem::path& path, unsigned flags) {
  std::error_code error;
  File file(path, flags, error);
  require_success(error, path, "opened");
  return file;
}

}  // namespace

void throw_file_error(const std::filesystem::path& file, const char* tried, std::error_code reason) {
  throw FileError("the file '" + file.string() + "' cannot be " + tried + ": " + reason.message());
}

std::error_code library_error() {
  return {errno, std::generic_category()};
}

void BlockSums::add(std::span<const double> values) {
  while (!values.empty()) {
    const std::span<const double> part = values.first(std::min(values.size(), kBlock - held_));
    begun_ = sum(part, begun_);
    held_ += part.size();
    values = values.subspan(part.size());
    if (held_ < kBlock) continue;
    sums_.push_back(begun_);
    begun_ = kChecksumStart;
    held_ = 0;
  }
}

std::vector<std::uint64_t> BlockSums::all() const {
  std::vector<std::uint64_t> sums = sums_;
  sums.push_back(begun_);
  return sums;
}

std::uint64_t BlockSums::sum(std::span<const double> values, std::uint64_t onto) {
  for (const double value : values) onto = add_to_checksum(onto, overbend::bit_cast<std::uint64_t>(value));
  return onto;
}

AppendFile::AppendFile(std::filesystem::path file, std::uint64_t keep, const std::vector<std::uint64_t>& sums)
    : path_(std::move(file)),
      file_(open_file(path_, File::kRead | File::kWrite | File::kCreate)),
      buffer_(kBufferBytes),
      written_(keep) {
  std::error_code error;
  const std::uint64_t length = file_.size(error);
  require_success(error, path_, "read");
  if (length < keep) {
    throw std::runtime_error("the file '" + path_.string() + "' is damaged: " + std::to_string(keep) +
                             " bytes were stored, " + std::to_string(length) + " are left");
  }
  verify(sums);
  require_success(file_.resize(keep), path_, "cut");
}

/// Reads the whole file and accumulates its checksums.
void AppendFile::verify(const std::vector<std::uint64_t>& sums) {
  std::vector<double> block(BlockSums::kBlock);
  const std::uint64_t count = written_ / sizeof(double);
  for (std::uint64_t first = 0; first < count; first += block.size()) {
    check_interruption();
    block.resize(std::min<std::uint64_t>(BlockSums::kBlock, count - first));
    read_raw(first * sizeof(double), block);
    sums_.add(block);
    const std::size_t index = first / BlockSums::kBlock;
    if (index >= sums.size() || sums[index] != sums_.block_sum(index)) throw_damaged(first * sizeof(double));
  }
}

void AppendFile::throw_damaged(std::uint64_t offset) const {
  throw std::runtime_error("the file '" + path_.string() + "' is damaged: the content after byte " +
                           std::to_string(offset) + " is not what was written");
}

void AppendFile::append(std::span<const double> values) {
  sums_.add(values);
  std::span<const std::byte> bytes = std::as_bytes(values);
  while (!bytes.empty()) {
    if (filled_ == buffer_.size()) flush();
    const std::size_t count = std::min(bytes.size(), buffer_.size() - filled_);
    std::memcpy(buffer_.data() + filled_, bytes.data(), count);
    filled_ += count;
    bytes = bytes.subspan(count);
  }
}

void AppendFile::flush() {
  require_success(file_.write(written_, std::span(buffer_).first(filled_)), path_, "written");
  written_ += std::exchange(filled_, 0);
}

void AppendFile::sync() {
  flush();
  require_success(file_.sync(), path_, "written");
}

void AppendFile::read(std::uint64_t offset, std::span<double> values) const {
  require(filled_ == 0, "a file is flushed before it is read");
  constexpr std::uint64_t kBytes = BlockSums::kBlock * sizeof(double);
  std::vector<double> block;
  while (!values.empty()) {
    const std::uint64_t start = offset / kBytes * kBytes, end = std::min(start + kBytes, written_);
    if (end <= offset) throw std::runtime_error("the file '" + path_.string() + "' ends too early");
    block.resize((end - start) / sizeof(double));
    read_raw(start, block);
    if (BlockSums::sum(block) != sums_.block_sum(start / kBytes)) throw_damaged(start);
    const std::span<const double> wanted = std::span<const double>(block).subspan((offset - start) / sizeof(double));
    const std::size_t count = std::min(wanted.size(), values.size());
    std::copy_n(wanted.begin(), count, values.begin());
    values = values.subspan(count);
    offset += count * sizeof(double);
  }
}

void AppendFile::read_raw(std::uint64_t offset, std::span<double> values) const {
  std::error_code error;
  const std::size_t count = file_.read(offset, std::as_writable_bytes(values), error);
  require_success(error, path_, "read");
  if (count < values.size_bytes()) throw std::runtime_error("the file '" + path_.string() + "' ends too early");
}

void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  require_success(open_file(file, kNewContent).write(0, bytes), file, "written");
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  write_file(file, std::as_bytes(std::span(text)));
}

void write_synced(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  const File opened = open_file(file, kNewContent);
  require_success(opened.write(0, bytes), file, "written");
  require_success(opened.sync(), file, "written");
}

void name_complete_file(const std::filesystem::path& partial, const std::filesystem::path& file) {
  require_success(rename_file(partial, file), file, "written");
}

void sync_folder(const std::filesystem::path& folder) {
  require_success(open_file(folder, File::kRead | File::kFolder).sync(), folder, "written");
}

}  // namespace overbend
