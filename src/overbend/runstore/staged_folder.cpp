#include "runstore/staged_folder.h"

#include <algorithm>
#include <system_error>

#include "platform/lock.h"
#include "platform/temporary.h"
#include "runstore/append_file.h"
#include "runstore/written_files.h"

namespace overbend {
namespace fs = std::filesystem;
namespace {

constexpr const char* kStem = ".overbend-";

[[noreturn]] void throw_unusable_folder(const fs::path& folder, const std::string& reason) {
  throw UnusableFolder("the folder '" + folder.string() + "' cannot be written: " + reason);
}

/// Topmost part of the path that does not exist; empty if all parts exist.
fs::path topmost_missing(const fs::path& folder) {
  fs::path missing;
  for (fs::path part = folder; !part.empty(); part = part.parent_path()) {
    std::error_code error;
    if (fs::exists(fs::symlink_status(part, error))) break;
    missing = part;
    if (part == part.parent_path()) break;
  }
  return missing;
}

bool on_one_file_system(const fs::path& a, const fs::path& b) {
  const auto identity_a = file_identity(a), identity_b = file_identity(b);
  return identity_a && identity_b && identity_a->volume == identity_b->volume;
}

/// True if the current folder is `folder` or inside it.
bool contains_current_folder(const fs::path& folder) {
  std::error_code error;
  const fs::path current = fs::current_path(error);
  const auto [end, ignored] = std::mismatch(folder.begin(), folder.end(), current.begin(), current.end());
  return error || end == folder.end();
}

bool is_staging_name(const std::string& name) {
  return name.starts_with(kStem) && name.size() == std::string(kStem).size() + 6;
}

}  // namespace

void clear_leftovers(const fs::path& parent) noexcept {
  std::error_code error;
  for (fs::directory_iterator entry(parent, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (!is_staging_name(entry->path().filename().string()) || !entry->is_directory(ignored)) continue;
    if (const File guard = lock_folder(entry->path()); guard.is_open()) clear_marked(entry->path());
  }
}

StagedFolder::StagedFolder(const fs::path& folder) : folder_(fs::absolute(folder).lexically_normal()) {
  if (!folder_.has_filename()) folder_ = folder_.parent_path();  // "results/" is "results"
  made_ = topmost_missing(folder_);
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error || !fs::is_directory(folder_)) {
    remove_traces();
    throw_unusable_folder(folder, error ? error.message() : "it is not a folder");
  }
  if (made_.empty()) folder_ = fs::canonical(folder_);  // resolve links: the folder is exchanged, not the link
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
  std::error_code error = check_writable(folder_);
  if (error) throw_unusable_folder(folder_, error.message());
  for (const bool next_to_target : {true, false}) {
    if (next_to_target && (contains_current_folder(folder_) || !on_one_file_system(folder_, parent))) continue;
    staging_ = make_unique_folder(next_to_target ? parent : folder_, kStem, error);
    if (error) continue;
    next_to_target_ = next_to_target;
    lock_ = lock_folder(staging_);
    if (!mark_staged(staging_)) throw_unusable_folder(folder_, library_error().message());
    return;
  }
  throw_unusable_folder(folder_, error.message());
}

void StagedFolder::commit(const std::string& last, const std::vector<std::string>& folders) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(staging_)) {
    const std::string name = entry.path().filename().string();
    if (is_mark(name)) continue;
    if (fs::is_directory(folder_ / name)) throw_unusable_folder(folder_, "'" + name + "' in it is a folder");
    names.push_back(name);
  }
  const WrittenFiles before = read_written(folder_);
  if (const auto foreign = find_user_file_conflict(folder_, names)) throw_unusable_folder(folder_, *foreign);
  write_written(staging_, {names, folders});
  // first, for renaming one by one: the files that follow are known as ours
  names.insert(names.begin(), kWrittenFiles);
  std::vector<std::string> mine = names;
  mine.insert(mine.end(), before.files.begin(), before.files.end());
  if (!exchange(mine)) rename_one_by_one(names, last, before.files);
  made_.clear();
  for (const std::string& name : before.folders) {
    if (std::find(folders.begin(), folders.end(), name) == folders.end()) remove_results(folder_ / name);
  }
}

/// Links the user's files into the new folder, exchanges it with the old one, and moves the user's folders, which
/// cannot be linked. Returns false, with nothing changed, if that is not possible.
bool StagedFolder::exchange(const std::vector<std::string>& mine) {
  if (!next_to_target_) return false;
  std::vector<std::string> shared;
  const auto undo = [&] {
    std::error_code ignored;
    for (const std::string& name : shared) fs::remove(staging_ / name, ignored);
    unmark_old(folder_);
    mark_staged(staging_);
    return false;
  };
  if (!link_user_files(folder_, staging_, mine, shared)) return undo();
  if (copy_ownership(folder_, staging_) && !is_own_file(folder_)) return undo();
  std::error_code error;
  const fs::file_status old = fs::status(folder_, error);
  if (!error) fs::permissions(staging_, old.permissions(), error);
  if (error) return undo();
  if (!mark_old(folder_, folder_) || !unmark_staged(staging_)) return undo();
  if (exchange_folders(staging_, folder_)) return undo();
  clear_marked(staging_);
  return true;
}

/// Renames one by one, moving existing files aside; all are restored if one fails.
void StagedFolder::rename_one_by_one(std::vector<std::string> names, const std::string& last,
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
  } catch (const fs::filesystem_error& error) {
    std::error_code ignored;
    for (auto undone = done.rbegin(); undone != done.rend(); ++undone) {
      fs::rename(undone->to, undone->from, ignored);
      if (ignored) unmark_staged(staging_);  // keep files that could not be restored
    }
    throw_unusable_folder(folder_, error.code().message());
  }
}

void StagedFolder::remove_traces() noexcept {
  std::error_code ignored;  // the first error is the one to report
  if (!staging_.empty() && is_marked_staged(staging_)) fs::remove_all(staging_, ignored);
  if (!made_.empty()) {
    // Only folders created here, from the innermost out: remove() keeps those that have other content by now.
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
