#include "io/staging_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace overbend {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPrefix = ".overbend-";
constexpr std::size_t kRandomLetters = 6;

/// A name that mkdtemp makes.
bool staging_name(const std::string& name) {
  const auto letter = [](char c) { return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
  return name.starts_with(kPrefix) && name.size() == kPrefix.size() + kRandomLetters &&
         std::all_of(name.begin() + kPrefix.size(), name.end(), letter);
}

FileDescriptor open_folder(const fs::path& folder) {
  return FileDescriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

/// Whether the folder is still the one that is open.
bool still_there(const fs::path& folder, const FileDescriptor& open) {
  struct stat named {
  }, held{};
  return ::lstat(folder.c_str(), &named) == 0 && ::fstat(open.id(), &held) == 0 && named.st_dev == held.st_dev &&
         named.st_ino == held.st_ino;
}

void remove_abandoned(const fs::path& folder) {
  const FileDescriptor open = open_folder(folder);
  struct stat held {};
  if (open.id() < 0 || ::fstat(open.id(), &held) != 0 || held.st_uid != ::geteuid()) return;
  if (::flock(open.id(), LOCK_EX | LOCK_NB) != 0) return;
  std::error_code ignored;
  fs::remove_all(folder, ignored);
}

}  // namespace

std::optional<StagingPlace> make_staging(const fs::path& folder) {
  for (;;) {
    std::string pattern = (folder / (std::string(kPrefix) + std::string(kRandomLetters, 'X'))).string();
    if (mkdtemp(pattern.data()) == nullptr) return std::nullopt;
    FileDescriptor lock = open_folder(pattern);
    // Where there are no locks nobody removes anything either.
    if (lock.id() >= 0) ::flock(lock.id(), LOCK_EX);
    // Another process may have taken it for abandoned before it was locked.
    if (lock.id() < 0 || still_there(pattern, lock)) return StagingPlace{pattern, std::move(lock)};
  }
}

void remove_abandoned_staging(const fs::path& folder) noexcept {
  try {
    std::vector<fs::path> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      if (staging_name(entry.path().filename().string())) found.push_back(entry.path());
    }
    for (const fs::path& one : found) remove_abandoned(one);
  } catch (const std::exception&) {
    return;  // they take room and nothing else
  }
}

}  // namespace overbend
