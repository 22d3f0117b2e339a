#include "runstore/replace_file.h"

#include <fmt/format.h>

#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>

#include "platform/file.h"
#include "runstore/append_file.h"

namespace overbend {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void throw_write_error(const fs::path& file, const std::string& reason) {
  throw FileError("the file '" + file.string() + "' cannot be written: " + reason);
}

/// Path of the content, at the end of the links.
fs::path end_of_links(const fs::path& file) {
  std::error_code error;
  if (!fs::is_symlink(fs::symlink_status(file, error))) return file;
  fs::path target = fs::canonical(file, error);
  if (error) throw_write_error(file, "it is a broken link");
  return target;
}

/// Permissions of the existing file; nullopt if there is none.
std::optional<fs::perms> existing_file_permissions(const fs::path& file) {
  std::error_code error;
  const fs::file_status found = fs::symlink_status(file, error);
  if (found.type() == fs::file_type::not_found) return std::nullopt;
  if (error) throw_file_error(file, "written", error);
  if (!fs::is_regular_file(found)) throw_write_error(file, "it is not a regular file");
  // A rename needs permission on the folder only; a file protected by its owner is left unchanged.
  error = check_writable(file);
  if (error) throw_file_error(file, "written", error);
  return found.permissions();
}

/// Name in the file's folder that no process can predict.
fs::path unpredictable_name(const fs::path& file) {
  std::random_device source;
  return file.parent_path() / fmt::format(".{}.{:08x}{:08x}", file.filename().string(), source(), source());
}

/// New file in the folder of another, deleted with this object unless it has replaced the other.
class TemporaryFile {
 public:
  TemporaryFile(const fs::path& file, const std::optional<fs::perms>& before) : target_(file) {
    const fs::path name = unpredictable_name(file);
    // Mode by the user's umask, or private until it gets the mode of the replaced file.
    const unsigned mode = before ? 0600 : 0666;
    std::error_code error;
    file_ = File(name, File::kWrite | File::kCreate | File::kExclusive, error, fs::perms(mode));
    require_success(error);
    name_ = name;
    if (before) copy_ownership_and_mode(*before);
  }
  ~TemporaryFile() {
    std::error_code ignored;
    if (!name_.empty()) fs::remove(name_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::string_view text) {
    require_success(file_.write(0, std::as_bytes(std::span<const char>(text.data(), text.size()))));
    require_success(file_.sync());
  }

  void put_in_place() {
    require_success(file_.close());
    require_success(rename_file(name_, target_));
    name_.clear();
  }

 private:
  void require_success(std::error_code reason) const {
    if (reason) throw_file_error(target_, "written", reason);
  }

  void copy_ownership_and_mode(fs::perms before) {
    if (copy_ownership(target_, name_)) {
      throw_write_error(target_, "it belongs to another user or group, and the ownership could not be preserved");
    }
    std::error_code error;
    fs::permissions(name_, before, error);
    require_success(error);
  }

  fs::path target_, name_;
  File file_;
};

}  // namespace

void replace_file(const fs::path& file, std::string_view text, const std::function<void()>& last_look) {
  const fs::path target = fs::absolute(end_of_links(file));
  const std::optional<fs::perms> before = existing_file_permissions(target);
  TemporaryFile temporary(target, before);
  temporary.write(text);
  if (last_look) last_look();
  temporary.put_in_place();
  try {
    sync_folder(target.parent_path());
  } catch (const std::runtime_error&) {
    // Some file systems do not support it; the new content is in place nevertheless.
  }
}

}  // namespace overbend
