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

constexpr auto kPulse = std::chrono::seconds(15);
constexpr auto kDead = std::chrono::seconds(120);  ///< Without a pulse; caches of network folders lag by a minute.

/// Machine, start of its system, and view of its processes: process numbers mean the same within one of these.
std::string place() {
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

/// When a process was begun, in the system's ticks: tells processes of one number apart. Empty where there is none.
std::string begun(long process) {
  std::ifstream stream(fmt::format("/proc/{}/stat", process));
  std::string line;
  if (!std::getline(stream, line)) return {};
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return {};
  std::istringstream rest(line.substr(name_end + 1));
  std::string word;
  constexpr int kStart = 20;  // the 22nd of the line, proc(5)
  for (int i = 0; i < kStart; ++i) rest >> word;
  return word;
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text;
  std::getline(stream, text);
  return text;
}

/// Makes the file as another name of `source`, which has this text already: a process killed at any instant leaves a
/// whole claim or none. False where there is one. On a file system without links it is made empty and then written.
bool make_alone(const fs::path& file, const std::string& text, const fs::path& source) {
  if (link(source.c_str(), file.c_str()) == 0) return true;
  if (errno == EEXIST) return false;
  const FileDescriptor made(open(file.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666));
  if (made.id() < 0) {
    if (errno == EEXIST) return false;
    refuse_file(file, "written");
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
  name_ = fmt::format("{}.{}.{}", place(), getpid(), begun(getpid()));
  file_ = folder_ / name_;
  std::error_code fault;
  fs::create_directories(folder_, fault);
  write_text(file_, name_ + "\n");
  pulse_ = std::thread([this] { stay_alive(); });
}

WorkerFile::~WorkerFile() {
  {
    const std::lock_guard<std::mutex> hold(mutex_);
    ended_ = true;
  }
  ending_.notify_all();
  pulse_.join();
  std::error_code ignored;
  fs::remove(file_, ignored);
}

void WorkerFile::stay_alive() {
  std::unique_lock<std::mutex> hold(mutex_);
  while (!ending_.wait_for(hold, kPulse, [this] { return ended_; })) {
    utimensat(AT_FDCWD, file_.c_str(), nullptr, 0);
  }
}

bool WorkerFile::touched_lately(const fs::path& file) const {
  utimensat(AT_FDCWD, file_.c_str(), nullptr, 0);
  std::error_code fault;
  const auto own = fs::last_write_time(file_, fault);
  if (fault) return true;
  const auto other = fs::last_write_time(file, fault);
  return !fault && own - other < kDead;
}

bool WorkerFile::lives(const std::string& worker) const {
  if (worker == name_) return true;
  const std::string here = place() + ".";
  if (!worker.starts_with(here)) return touched_lately(folder_ / worker);
  const std::size_t point = worker.find('.', here.size());
  if (point == std::string::npos) return false;
  const long process = std::strtol(worker.c_str() + here.size(), nullptr, 10);
  const std::string ticks = begun(process);
  return !ticks.empty() && ticks == worker.substr(point + 1);
}

bool WorkerFile::claim(const fs::path& stem) const {
  for (int generation = 0;; ++generation) {
    const fs::path file = claim_path(stem, generation);
    if (make_alone(file, name_, file_)) return true;
    std::error_code ignored;
    if (fs::exists(claim_path(stem, generation + 1), ignored)) continue;  // taken over from a dead one before
    const std::string worker = text_of(file);
    // One without text was made just now, or by a process killed in between, on a file system without links.
    if (worker.empty() ? touched_lately(file) : lives(worker)) return false;
  }
}

void release_claims(const fs::path& stem) noexcept {
  std::error_code ignored;
  int last = 0;
  while (fs::exists(claim_path(stem, last + 1), ignored)) ++last;
  for (int generation = last; generation >= 0; --generation) fs::remove(claim_path(stem, generation), ignored);
}

}  // namespace overbend
