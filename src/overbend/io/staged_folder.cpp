#include "io/staged_folder.h"

#include <cerrno>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace overbend {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void refuse(const fs::path& folder, const std::string& reason) {
  throw UnusableFolder("the folder '" + folder.string() + "' can not be written: " + reason);
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

}  // namespace

StagedFolder::StagedFolder(const fs::path& folder) : folder_(fs::absolute(folder).lexically_normal()) {
  if (!folder_.has_filename()) folder_ = folder_.parent_path();  // "results/" is "results"
  made_ = topmost_missing(folder_);
  std::error_code fault;
  fs::create_directories(folder_, fault);
  if (fault || !fs::is_directory(folder_)) {
    remove_traces();
    refuse(folder, fault ? fault.message() : "it is not a folder");
  }
  remove_abandoned_staging(folder_);
  std::optional<StagingPlace> place = make_staging(folder_);
  if (!place) {
    fault.assign(errno, std::generic_category());
    remove_traces();
    refuse(folder, fault.message());
  }
  staging_ = std::move(*place);
}

StagedFolder::~StagedFolder() {
  remove_traces();
}

void StagedFolder::commit(const std::string& last) {
  std::vector<fs::path> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(path())) {
    const fs::path name = entry.path().filename();
    if (fs::is_directory(folder_ / name)) refuse(folder_, "'" + name.string() + "' in it is a folder");
    if (name != last) names.push_back(name);
  }
  if (fs::exists(path() / last)) names.emplace_back(last);
  for (const fs::path& name : names) fs::rename(path() / name, folder_ / name);
  made_.clear();
}

void StagedFolder::remove_traces() noexcept {
  std::error_code ignored;  // nothing can be done about it, and the first fault is the one to tell
  if (!path().empty()) fs::remove_all(path(), ignored);
  if (!made_.empty()) {
    // Folders of ours only, from the innermost out: remove() leaves alone what somebody else has filled meanwhile.
    for (fs::path part = folder_; part != made_.parent_path(); part = part.parent_path()) fs::remove(part, ignored);
  }
}

}  // namespace overbend
