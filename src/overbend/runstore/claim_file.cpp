#include "runstore/claim_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <sstream>

#include "runstore/append_file.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

constexpr auto kTouchInterval = std::chrono::seconds(15);
constexpr auto kWorkerTimeout = std::chrono::seconds(120);  ///< Time without a touch after which a process counts as
                                                            ///< dead; caches of network folders lag by a minute.

/// Machine, its boot and its process namespace: process numbers are comparable only within one of these.
std::string process_namespace() {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  std::ifstream boot("/proc/sys/kernel/random/boot_id");
  std::string id;
  std::getline(boot, id);
  std::array<char, 64> view{};
  const ssize_t length = readlink("/proc/self/ns/pid", view.data(), view.size() - 1);
  std::string text = std::string(host.data()) + "_" + id.substr(0, 8) + "_" +
                     (length > 0 ? std::string(view.data(), static_cast<std::size_t>(length)) : "");
  for (char& c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
  }
  return text;
}

/// Start time of a process in system ticks, which distinguishes processes with the same number. Empty if there is none.
std::string process_start_ticks(long process) {
  std::ifstream stream(fmt::format("/proc/{}/stat", process));
  std::string line;
  if (!std::getline(stream, line)) return {};
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return {};
  std::istringstream rest(line.substr(name_end + 1));
  std::string word;
  constexpr int kStart = 20;  // field 22 of the line, proc(5)
  for (int i = 0; i < kStart; ++i) rest >> word;
  return word;
}

std::string read_first_line(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text;
  std::getline(stream, text);
  return text;
}

/// Creates the file as a hard link to `source`, which already contains the text: a process killed at any time leaves a
/// complete claim or none. Returns false if the file exists. On a file system without links it is created empty and
/// then written.
bool create_exclusively(const fs::path& file, const std::string& text, const fs::path& source) {
  if (link(source.c_str(), file.c_str()) == 0) return true;
  if (errno == EEXIST) return false;
  const FileDescriptor made(open(file.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666));
  if (made.id() < 0) {
    if (errno == EEXIST) return false;
    throw_file_error(file, "written");
  }
  const std::string line = text + "\n";
  write_at(0, std::as_bytes(std::span(line)), made.id(), file);
  return true;
}

fs::path claim_path(const fs::path& stem, int generation) {
  return fs::path(stem.string() + "." + std::to_string(generation));
}

}  // namespace

WorkerFile::WorkerFile(const fs::path& folder) : folder_(folder) {
  name_ = fmt::format("{}.{}.{}", process_namespace(), getpid(), process_start_ticks(getpid()));
  file_ = folder_ / name_;
  std::error_code error;
  fs::create_directories(folder_, error);
  write_text(file_, name_ + "\n");
  touch_thread_ = std::thread([this] { touch_periodically(); });
}

WorkerFile::~WorkerFile() {
  {
    const std::lock_guard<std::mutex> hold(mutex_);
    ended_ = true;
  }
  ending_.notify_all();
  touch_thread_.join();
  std::error_code ignored;
  fs::remove(file_, ignored);
}

void WorkerFile::touch_periodically() {
  std::unique_lock<std::mutex> hold(mutex_);
  while (!ending_.wait_for(hold, kTouchInterval, [this] { return ended_; })) {
    utimensat(AT_FDCWD, file_.c_str(), nullptr, 0);
  }
}

bool WorkerFile::touched_recently(const fs::path& file) const {
  utimensat(AT_FDCWD, file_.c_str(), nullptr, 0);
  std::error_code error;
  const auto reference_time = fs::last_write_time(file_, error);
  if (error) return true;
  const auto file_time = fs::last_write_time(file, error);
  return !error && reference_time - file_time < kWorkerTimeout;
}

bool WorkerFile::is_alive(const std::string& worker) const {
  if (worker == name_) return true;
  const std::string prefix = process_namespace() + ".";
  if (!worker.starts_with(prefix)) return touched_recently(folder_ / worker);
  const std::size_t point = worker.find('.', prefix.size());
  if (point == std::string::npos) return false;
  const long process = std::strtol(worker.c_str() + prefix.size(), nullptr, 10);
  const std::string ticks = process_start_ticks(process);
  return !ticks.empty() && ticks == worker.substr(point + 1);
}

bool WorkerFile::claim(const fs::path& stem) const {
  for (int generation = 0;; ++generation) {
    const fs::path file = claim_path(stem, generation);
    if (create_exclusively(file, name_, file_)) return true;
    std::error_code ignored;
    if (fs::exists(claim_path(stem, generation + 1), ignored)) continue;  // already taken over from a dead worker
    const std::string worker = read_first_line(file);
    // An empty file was created just now, or by a process killed before writing, on a file system without links.
    if (worker.empty() ? touched_recently(file) : is_alive(worker)) return false;
  }
}

void release_claims(const fs::path& stem) noexcept {
  std::error_code ignored;
  int last = 0;
  while (fs::exists(claim_path(stem, last + 1), ignored)) ++last;
  for (int generation = last; generation >= 0; --generation) fs::remove(claim_path(stem, generation), ignored);
}

}  // namespace overbend
