#include "runstore/append_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

#include "base/interruption.h"
#include "base/require.h"

namespace overbend {
namespace {

static_assert(std::endian::native == std::endian::little, "the files of a run are little-endian");

constexpr std::size_t kBufferBytes = std::size_t{1} << 20;

FileDescriptor open_file(const std::filesystem::path& file, int flags) {
  FileDescriptor descriptor(::open(file.c_str(), flags | O_CLOEXEC, 0644));
  if (descriptor.id() < 0) throw_file_error(file, "opened");
  return descriptor;
}

}  // namespace

void throw_file_error(const std::filesystem::path& file, const char* tried) {
  const std::string reason = std::generic_category().message(errno);
  throw FileError("the file '" + file.string() + "' cannot be " + tried + ": " + reason);
}

void write_at(std::uint64_t offset, std::span<const std::byte> bytes, int id, const std::filesystem::path& file) {
  while (!bytes.empty()) {
    const ssize_t count = ::pwrite(id, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw_file_error(file, "written");
    offset += static_cast<std::uint64_t>(count);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

FileDescriptor::~FileDescriptor() {
  if (id_ >= 0) ::close(id_);
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
  for (const double value : values) onto = add_to_checksum(onto, std::bit_cast<std::uint64_t>(value));
  return onto;
}

AppendFile::AppendFile(std::filesystem::path file, std::uint64_t keep, const std::vector<std::uint64_t>& sums)
    : file_(std::move(file)), descriptor_(open_file(file_, O_RDWR | O_CREAT)), buffer_(kBufferBytes), written_(keep) {
  const off_t length = ::lseek(descriptor_.id(), 0, SEEK_END);
  if (length < 0) throw_file_error(file_, "read");
  if (static_cast<std::uint64_t>(length) < keep) {
    throw std::runtime_error("the file '" + file_.string() + "' is damaged: " + std::to_string(keep) +
                             " bytes were stored, " + std::to_string(length) + " are left");
  }
  verify(sums);
  if (::ftruncate(descriptor_.id(), static_cast<off_t>(keep)) != 0) throw_file_error(file_, "cut");
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
  throw std::runtime_error("the file '" + file_.string() + "' is damaged: the content after byte " +
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
  write_at(written_, std::span(buffer_).first(filled_), descriptor_.id(), file_);
  written_ += std::exchange(filled_, 0);
}

void AppendFile::sync() {
  flush();
  if (::fsync(descriptor_.id()) != 0) throw_file_error(file_, "written");
}

void AppendFile::read(std::uint64_t offset, std::span<double> values) const {
  require(filled_ == 0, "a file is flushed before it is read");
  constexpr std::uint64_t kBytes = BlockSums::kBlock * sizeof(double);
  std::vector<double> block;
  while (!values.empty()) {
    const std::uint64_t start = offset / kBytes * kBytes, end = std::min(start + kBytes, written_);
    if (end <= offset) throw std::runtime_error("the file '" + file_.string() + "' ends too early");
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
  std::span<std::byte> bytes = std::as_writable_bytes(values);
  while (!bytes.empty()) {
    const ssize_t count = ::pread(descriptor_.id(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw_file_error(file_, "read");
    if (count == 0) throw std::runtime_error("the file '" + file_.string() + "' ends too early");
    offset += static_cast<std::uint64_t>(count);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  write_at(0, bytes, open_file(file, O_WRONLY | O_CREAT | O_TRUNC).id(), file);
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  write_file(file, std::as_bytes(std::span(text)));
}

void write_synced(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  const FileDescriptor descriptor = open_file(file, O_WRONLY | O_CREAT | O_TRUNC);
  write_at(0, bytes, descriptor.id(), file);
  if (::fsync(descriptor.id()) != 0) throw_file_error(file, "written");
}

void sync_folder(const std::filesystem::path& folder) {
  const FileDescriptor descriptor = open_file(folder, O_RDONLY | O_DIRECTORY);
  if (::fsync(descriptor.id()) != 0) throw_file_error(folder, "written");
}

}  // namespace overbend
