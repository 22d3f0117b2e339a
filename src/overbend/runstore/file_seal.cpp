#include "runstore/file_seal.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <ctime>
#include <fstream>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/interruption.h"
#include "runstore/append_file.h"
#include "runstore/checksum.h"

namespace overbend {
namespace fs = std::filesystem;
namespace {

struct Seal {
  std::array<char, 8> mark = {'o', 'v', 'e', 'r', 'b', 'e', 'n', 'd'};
  std::uint64_t length = 0;  ///< Length of the content before the seal [bytes].
  std::uint64_t sum = kChecksumStart;
};
static_assert(sizeof(Seal) == 24);

[[noreturn]] void throw_seal_error(const fs::path& file, const std::string& why) {
  throw std::runtime_error("the file '" + file.string() + "' " + why);
}

/// Checksum of the first `length` bytes; the last word is padded with zeros.
std::uint64_t checksum(std::istream& stream, std::uint64_t length) {
  std::uint64_t sum = kChecksumStart;
  std::vector<std::uint64_t> buffer(std::min<std::uint64_t>(length / sizeof(std::uint64_t) + 1, 1U << 17U));
  while (length > 0 && stream) {
    check_interruption();
    const std::uint64_t count = std::min<std::uint64_t>(length, buffer.size() * sizeof(std::uint64_t));
    buffer[(count - 1) / sizeof(std::uint64_t)] = 0;
    stream.read(reinterpret_cast<char*>(buffer.data()), static_cast<std::streamsize>(count));
    for (std::uint64_t i = 0; i < (count + 7) / 8; ++i) sum = add_to_checksum(sum, buffer[i]);
    length -= count;
  }
  return sum;
}

void verify(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) throw_seal_error(file, "is a folder");
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) throw_seal_error(file, fs::exists(file, error) ? "cannot be read" : "does not exist");
  const auto size = static_cast<std::uint64_t>(stream.tellg());
  const Seal expected;
  Seal seal;
  if (size >= sizeof seal) {
    stream.seekg(-static_cast<std::streamoff>(sizeof seal), std::ios::end);
    stream.read(reinterpret_cast<char*>(&seal), sizeof seal);
  }
  if (!stream || size < sizeof seal || seal.mark != expected.mark) {
    throw_seal_error(file, "has no checksum at its end: it was cut short or changed, or comes from an older version");
  }
  stream.seekg(0);
  if (seal.length != size - sizeof seal || checksum(stream, seal.length) != seal.sum || !stream) {
    throw_seal_error(file, "is damaged: its content is not what the program wrote");
  }
}

}  // namespace

void seal_file(const fs::path& file) {
  Seal seal;
  std::ifstream stream(file, std::ios::binary);
  seal.length = fs::file_size(file);
  seal.sum = checksum(stream, seal.length);
  std::ofstream end(file, std::ios::binary | std::ios::app);
  end.write(reinterpret_cast<const char*>(&seal), sizeof seal);
  end.close();
  if (!stream || !end) throw_file_error(file, "written", library_error());
}

void unseal_file(const fs::path& file) {
  std::error_code error;
  fs::resize_file(file, fs::file_size(file) - sizeof(Seal), error);
  if (error) throw_file_error(file, "written", error);
}

void require_sealed(const fs::path& file) {
  static std::mutex mutex;  // the page requests one file repeatedly, and it may have gigabytes
  static std::optional<FileIdentity> verified;
  const std::lock_guard<std::mutex> hold(mutex);
  const std::optional<FileIdentity> current = file_identity(file);
  if (current && verified == current) return;
  verify(file);
  // A file changed within the last tick of its clock could change again without a new time stamp.
  constexpr std::int64_t kNanoseconds = 1'000'000'000;
  if (current && current->change_time / kNanoseconds + 2 < std::time(nullptr)) verified = current;
}

}  // namespace overbend
