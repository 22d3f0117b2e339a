#include "runstore/staged_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <system_error>

#include "runstore/written_files.h"

namespace overbend {
namespace fs = std::filesystem;
namespace {

constexpr const char* kStem = ".overbend-";

[[noreturn]] void refuse(const fs::path& folder, const std::string& reason) {
  throw UnusableFolder("the folder '" + folder.string() + "' cannot be written: " + reason);
}

/// The topmost part of the path that does not exist; empty when all of it does.
fs::path topmost_missing(const fs::path& folder) {
  fs::path missing;
  for (fs::path part = folder; !part.empty(); part = part.parent_path()) {
    std::error_code fault;
    if (fs::exists(fs::symlink_status(part, fault))) break;
    missing = part;
    if (part == part.parent_path()) break;
  }
  return missing;
}

bool on_one_file_system(const fs::path& a, const fs::path& b) {
  struct stat of_a {
  }, of_b{};
  return ::stat(a.c_str(), &of_a) == 0 && ::stat(b.c_str(), &of_b) == 0 && of_a.st_dev == of_b.st_dev;
}

/// Whether the current folder is `folder` or lies in it.
bool stands_in(const fs::path& folder) {
  std::error_code fault;
  const fs::path here = fs::current_path(fault);
  const auto [end, ignored] = std::mismatch(folder.begin(), folder.end(), here.begin(), here.end());
  return fault || end == folder.end();
}

/// Locked as long as its descriptor is open; none where somebody else has it.
FileDescriptor lock_folder(const fs::path& folder) {
  FileDescriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (descriptor.id() >= 0 && ::flock(descriptor.id(), LOCK_EX | LOCK_NB) != 0) return {};
  return descriptor;
}

bool is_staging_name(const std::string& name) {
  return name.starts_with(kStem) && name.size() == std::string(kStem).size() + 6;
}

}  // namespace

void clear_leftovers(const fs::path& parent) noexcept {
  std::error_code fault;
  for (fs::directory_iterator entry(parent, fault), end; !fault && entry != end; entry.increment(fault)) {
    std::error_code ignored;
    if (!is_staging_name(entry->path().filename().string()) || !entry->is_directory(ignored)) continue;
    if (const FileDescriptor guard = lock_folder(entry->path()); guard.id() >= 0) clear_marked(entry->path());
  }
}

StagedFolder::StagedFolder(const fs::path& folder) : folder_(fs::absolute(folder).lexically_normal()) {
  if (!folder_.has_filename()) folder_ = folder_.parent_path();  // "results/" is "results"
  made_ = topmost_missing(folder_);
  std::error_code fault;
  fs::create_directories(folder_, fault);
  if (fault || !fs::is_directory(folder_)) {
    remove_traces();
    refuse(folder, fault ? fault.message() : "it is not a folder");
  }
  if (made_.empty()) folder_ = fs::canonical(folder_);  // behind links: the folder is exchanged, not the link
  try {
    make_staging();
  } catch (const UnusableFolder&) {
    remove_traces();
    throw;
  }
}

StagedFolder::~StagedFolder() {
  remove_traces();
}

void StagedFolder::make_staging() {
  const fs::path parent = folder_.parent_path();
  clear_leftovers(parent);
  clear_leftovers(folder_);
  if (::access(folder_.c_str(), W_OK | X_OK) != 0) refuse(folder_, std::generic_category().message(errno));
  for (const bool beside : {true, false}) {
    if (beside && (stands_in(folder_) || !on_one_file_system(folder_, parent))) continue;
    std::string pattern = ((beside ? parent : folder_) / (std::string(kStem) + "XXXXXX")).string();
    if (mkdtemp(pattern.data()) == nullptr) continue;
    staging_ = pattern;
    beside_ = beside;
    lock_ = lock_folder(staging_);
    if (!mark_staged(staging_)) refuse(folder_, std::generic_category().message(errno));
    return;
  }
  refuse(folder_, std::generic_category().message(errno));
}

void StagedFolder::commit(const std::string& last, const std::vector<std::string>& folders) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(staging_)) {
    const std::string name = entry.path().filename().string();
    if (is_mark(name)) continue;
    if (fs::is_directory(folder_ / name)) refuse(folder_, "'" + name + "' in it is a folder");
    names.push_back(name);
  }
  const WrittenFiles before = read_written(folder_);
  if (const auto foreign = file_of_the_user(folder_, names)) refuse(folder_, *foreign);
  write_written(staging_, {names, folders});
  names.insert(names.begin(), kWrittenFiles);  // first, where they go one by one: what follows is known as ours
  std::vector<std::string> mine = names;
  mine.insert(mine.end(), before.files.begin(), before.files.end());
  if (!exchange(mine)) move_in(names, last, before.files);
  made_.clear();
  for (const std::string& name : before.folders) {
    if (std::find(folders.begin(), folders.end(), name) == folders.end()) remove_results(folder_ / name);
  }
}

/// The new folder gets the user's files as further names of the same files, takes the old one's place, and gets from it
/// what can have no second name: its folders. False, with nothing changed, where that cannot be done.
bool StagedFolder::exchange(const std::vector<std::string>& mine) {
  if (!beside_) return false;
  std::vector<std::string> shared;
  const auto undo = [&] {
    std::error_code ignored;
    for (const std::string& name : shared) fs::remove(staging_ / name, ignored);
    unmark_old(folder_);
    mark_staged(staging_);
    return false;
  };
  if (!share_others(folder_, staging_, mine, shared)) return undo();
  struct stat old {};
  if (::stat(folder_.c_str(), &old) != 0) return undo();
  if (::chown(staging_.c_str(), old.st_uid, old.st_gid) != 0 && old.st_uid != ::geteuid()) return undo();
  if (::chmod(staging_.c_str(), old.st_mode & 07777) != 0) return undo();
  if (!mark_old(folder_, folder_) || !unmark_staged(staging_)) return undo();
  if (::renameat2(AT_FDCWD, staging_.c_str(), AT_FDCWD, folder_.c_str(), RENAME_EXCHANGE) != 0) return undo();
  clear_marked(staging_);
  return true;
}

/// One by one, moving existing files aside; all are restored if one fails.
void StagedFolder::move_in(std::vector<std::string> names, const std::string& last,
                           const std::vector<std::string>& before) {
  std::stable_partition(names.begin(), names.end(), [&](const std::string& name) { return name != last; });
  const fs::path aside = staging_ / ".aside";
  struct Move {
    fs::path from, to;
  };
  std::vector<Move> done;
  const auto move = [&](const fs::path& from, const fs::path& to) {
    fs::rename(from, to);
    done.push_back({from, to});
  };
  const auto put_aside = [&](const std::string& name) {
    if (fs::exists(fs::symlink_status(folder_ / name))) move(folder_ / name, aside / name);
  };
  try {
    fs::create_directory(aside);
    for (const std::string& name : before) put_aside(name);
    for (const std::string& name : names) {
      put_aside(name);
      move(staging_ / name, folder_ / name);
    }
  } catch (const fs::filesystem_error& fault) {
    std::error_code ignored;
    for (auto undone = done.rbegin(); undone != done.rend(); ++undone) {
      fs::rename(undone->to, undone->from, ignored);
      if (ignored) unmark_staged(staging_);  // what could not be put back is not thrown away
    }
    refuse(folder_, fault.code().message());
  }
}

void StagedFolder::remove_traces() noexcept {
  std::error_code ignored;  // nothing can be done about it, and the first error is the one to report
  if (!staging_.empty() && is_marked_staged(staging_)) fs::remove_all(staging_, ignored);
  if (!made_.empty()) {
    // Folders of ours only, from the innermost out: remove() leaves alone what somebody else has filled meanwhile.
    for (fs::path part = folder_; part != made_.parent_path(); part = part.parent_path()) fs::remove(part, ignored);
  }
}

void remove_results(const fs::path& folder) noexcept {
  std::error_code ignored;
  if (!fs::exists(folder / kWrittenFiles, ignored)) return;  // not ours
  const WrittenFiles written = read_written(folder);
  for (const std::string& name : written.files) fs::remove(folder / name, ignored);
  for (const std::string& name : written.folders) remove_results(folder / name);
  for (const char* name : {"run.json", kWrittenFiles}) fs::remove(folder / name, ignored);
  fs::remove_all(folder / ".run", ignored);
  fs::remove(folder, ignored);
}

}  // namespace overbend
