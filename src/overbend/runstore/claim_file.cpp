#include "runstore/claim_file.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <fstream>

#include "platform/file.h"
#include "platform/process.h"
#include "runstore/append_file.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

constexpr auto kTouchInterval = std::chrono::seconds(15);
constexpr auto kWorkerTimeout = std::chrono::seconds(120);  ///< Time without a touch after which a process counts as
                                                            ///< dead; caches of network folders lag by a minute.

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
  std::error_code error;
  fs::create_hard_link(source, file, error);
  if (!error) return true;
  if (error == std::errc::file_exists) return false;
  const File made(file, File::kCreate | File::kExclusive | File::kWrite, error, fs::perms(0666));
  if (error == std::errc::file_exists) return false;
  const std::string line = text + "\n";
  if (!error) error = made.write(0, std::as_bytes(std::span(line)));
  if (error) throw_file_error(file, "written", error);
  return true;
}

fs::path claim_path(const fs::path& stem, int generation) {
  return fs::path(stem.string() + "." + std::to_string(generation));
}

}  // namespace

WorkerFile::WorkerFile(const fs::path& folder) : folder_(folder) {
  name_ = fmt::format("{}.{}.{}", process_namespace(), process_number(), process_start(process_number()));
  file_ = folder_ / name_;
  std::error_code error;
  fs::create_directories(folder_, error);
  write_text(file_, name_ + "\n");
  try {
    touch_thread_ = std::thread([this] { touch_periodically(); });
  } catch (const std::system_error&) {  // no more threads, or none at all: other machines see it as dead in time
  }
}

WorkerFile::~WorkerFile() {
  {
    const std::lock_guard<std::mutex> hold(mutex_);
    ended_ = true;
  }
  ending_.notify_all();
  if (touch_thread_.joinable()) touch_thread_.join();
  std::error_code ignored;
  fs::remove(file_, ignored);
}

void WorkerFile::touch_periodically() {
  std::unique_lock<std::mutex> hold(mutex_);
  while (!ending_.wait_for(hold, kTouchInterval, [this] { return ended_; })) {
    touch_file(file_);
  }
}

bool WorkerFile::touched_recently(const fs::path& file) const {
  touch_file(file_);
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
  const std::string start = process_start(process);
  return !start.empty() && start == worker.substr(point + 1);
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
