#include "runstore/replace_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>

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

/// Status of the existing file; nullopt if there is none.
std::optional<struct stat> existing_file_status(const fs::path& file) {
  struct stat found {};
  if (::lstat(file.c_str(), &found) != 0) {
    if (errno == ENOENT) return std::nullopt;
    throw_file_error(file, "written");
  }
  if (!S_ISREG(found.st_mode)) throw_write_error(file, "it is not a regular file");
  // A rename needs permission on the folder only; a file protected by its owner is left unchanged.
  if (::access(file.c_str(), W_OK) != 0) throw_file_error(file, "written");
  return found;
}

/// Name in the file's folder that no process can predict.
fs::path unpredictable_name(const fs::path& file) {
  std::random_device source;
  return file.parent_path() / fmt::format(".{}.{:08x}{:08x}", file.filename().string(), source(), source());
}

/// New file in the folder of another, deleted with this object unless it has replaced the other.
class TemporaryFile {
 public:
  TemporaryFile(const fs::path& file, const std::optional<struct stat>& before) : file_(file) {
    const fs::path name = unpredictable_name(file);
    // Mode by the user's umask, or private until it gets the mode of the replaced file.
    const mode_t mode = before ? 0600 : 0666;
    descriptor_ = FileDescriptor(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
    if (descriptor_.id() < 0) throw_file_error(file, "written");
    name_ = name;
    if (before) copy_ownership_and_mode(*before);
  }
  ~TemporaryFile() {
    if (!name_.empty()) ::unlink(name_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::string_view text) {
    write_at(0, std::as_bytes(std::span(text)), descriptor_.id(), file_);
    if (::fsync(descriptor_.id()) != 0) throw_file_error(file_, "written");
  }

  void put_in_place() {
    if (::rename(name_.c_str(), file_.c_str()) != 0) throw_file_error(file_, "written");
    name_.clear();
  }

 private:
  void copy_ownership_and_mode(const struct stat& before) {
    struct stat status {};
    if (::fstat(descriptor_.id(), &status) != 0) throw_file_error(file_, "written");
    const bool foreign = before.st_uid != status.st_uid || before.st_gid != status.st_gid;
    if (foreign && ::fchown(descriptor_.id(), before.st_uid, before.st_gid) != 0) {
      throw_write_error(file_, "it belongs to another user or group, and the ownership could not be preserved");
    }
    if (::fchmod(descriptor_.id(), before.st_mode & 07777) != 0) throw_file_error(file_, "written");
  }

  fs::path file_, name_;
  FileDescriptor descriptor_;
};

}  // namespace

void replace_file(const fs::path& file, std::string_view text, const std::function<void()>& last_look) {
  const fs::path target = fs::absolute(end_of_links(file));
  const std::optional<struct stat> before = existing_file_status(target);
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
