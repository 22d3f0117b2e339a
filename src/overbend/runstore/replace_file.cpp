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

[[noreturn]] void refuse(const fs::path& file, const std::string& reason) {
  throw FileFault("the file '" + file.string() + "' cannot be written: " + reason);
}

/// Where the content lies: at the end of the links.
fs::path end_of_links(const fs::path& file) {
  std::error_code fault;
  if (!fs::is_symlink(fs::symlink_status(file, fault))) return file;
  fs::path target = fs::canonical(file, fault);
  if (fault) refuse(file, "it is a broken link");
  return target;
}

/// The existing file; nothing if there is none yet.
std::optional<struct stat> present(const fs::path& file) {
  struct stat found {};
  if (::lstat(file.c_str(), &found) != 0) {
    if (errno == ENOENT) return std::nullopt;
    refuse_file(file, "written");
  }
  if (!S_ISREG(found.st_mode)) refuse(file, "it is not a regular file");
  // A rename asks the folder alone; a file that its owner protects stays as it is.
  if (::access(file.c_str(), W_OK) != 0) refuse_file(file, "written");
  return found;
}

/// A name in the file's folder that nobody can have prepared in advance.
fs::path unpredictable_name(const fs::path& file) {
  std::random_device source;
  return file.parent_path() / fmt::format(".{}.{:08x}{:08x}", file.filename().string(), source(), source());
}

/// A new file beside another, gone again with this object unless it was put in the other's place.
class Beside {
 public:
  Beside(const fs::path& file, const std::optional<struct stat>& before) : file_(file) {
    const fs::path name = unpredictable_name(file);
    // The mode that a new file has by the user's umask, or nobody else's until it is that of the file before.
    const mode_t mode = before ? 0600 : 0666;
    descriptor_ = FileDescriptor(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
    if (descriptor_.id() < 0) refuse_file(file, "written");
    name_ = name;
    if (before) take_on(*before);
  }
  ~Beside() {
    if (!name_.empty()) ::unlink(name_.c_str());
  }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;

  void write(std::string_view text) {
    write_at(0, std::as_bytes(std::span(text)), descriptor_.id(), file_);
    if (::fsync(descriptor_.id()) != 0) refuse_file(file_, "written");
  }

  void put_in_place() {
    if (::rename(name_.c_str(), file_.c_str()) != 0) refuse_file(file_, "written");
    name_.clear();
  }

 private:
  void take_on(const struct stat& before) {
    struct stat own {};
    if (::fstat(descriptor_.id(), &own) != 0) refuse_file(file_, "written");
    const bool foreign = before.st_uid != own.st_uid || before.st_gid != own.st_gid;
    if (foreign && ::fchown(descriptor_.id(), before.st_uid, before.st_gid) != 0) {
      refuse(file_, "it belongs to another user or group, and the ownership could not be preserved");
    }
    if (::fchmod(descriptor_.id(), before.st_mode & 07777) != 0) refuse_file(file_, "written");
  }

  fs::path file_, name_;
  FileDescriptor descriptor_;
};

}  // namespace

void replace_file(const fs::path& file, std::string_view text, const std::function<void()>& last_look) {
  const fs::path target = fs::absolute(end_of_links(file));
  const std::optional<struct stat> before = present(target);
  Beside beside(target, before);
  beside.write(text);
  if (last_look) last_look();
  beside.put_in_place();
  try {
    sync_folder(target.parent_path());
  } catch (const std::runtime_error&) {
    // Some file systems cannot; the new content is in place all the same.
  }
}

}  // namespace overbend
