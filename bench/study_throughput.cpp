// Throughput of a study of statics on one thread and on several: lays of examples/bgl1.yaml over tension and depth.
//
//     overbend_study_throughput [THREADS] [TENSIONS] [FOLDER]
//
// Defaults: as many threads as cores, 200 tensions at three depths, a temporary folder that is thrown away. Prints lays
// per second, the gain of the threads, and files and bytes that the folder holds. With `small` behind the folder it
// solves a small lay instead, whose records weigh the same: the load of 10,000 cases on a shared folder.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <thread>

#include "modelfile/study_file/study_reader.h"
#include "study/campaign/study_runner.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

class Unwatched : public StudyObserver {
 public:
  bool stop() override { return false; }
};

struct Folder {
  std::size_t entries = 0;
  std::uintmax_t bytes = 0;
};

Folder weighed(const fs::path& folder) {
  Folder weight;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    ++weight.entries;
    if (entry.is_regular_file()) weight.bytes += entry.file_size();
  }
  return weight;
}

/// Cases a second.
double run(const CaseBase& base, const StudyCases& cases, const fs::path& folder, int threads) {
  fs::remove_all(folder);
  open_study(base, cases, folder);
  Unwatched watch;
  const auto begun = std::chrono::steady_clock::now();
  StudyRunOptions options;
  options.threads = threads;
  const StudyTally tally = run_study_cases(base, cases, folder, options, watch);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  std::cout << fmt::format("{} threads: {} cases in {:.2f} s, {:.1f} a second, {} failed\n", threads,
                           tally.done + tally.failed, seconds, static_cast<double>(tally.done) / seconds, tally.failed);
  return static_cast<double>(tally.done) / seconds;
}

int measure(int threads, int tensions, const fs::path& folder, bool small) {
  const std::string file = std::string(OVERBEND_SOURCE_DIR) + "/examples/throughput.yaml";  // its place counts alone
  const StudyReading reading = read_study_text(
      fmt::format("overbend_study: 1\nbase: {}\naxes:\n"
                  "  - {{key: environment.water_depth, values: [{}]}}\n"
                  "  - {{key: tensioner.tension, from: {} kN, to: {} kN, steps: {}}}\n",
                  small ? "first-model.yaml" : "bgl1.yaml", small ? "39 m, 40 m, 41 m" : "86 m, 89 m, 92 m",
                  small ? 280 : 200, small ? 320 : 360, tensions),
      file);
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) std::cerr << line << "\n";
  if (!reading.study) return 2;
  const CaseBase base(*reading.base, *reading.study);
  const StudyCases cases(base.study());
  const double single = run(base, cases, folder, 1);
  const Folder weight = weighed(folder);
  std::cout << fmt::format("{} files and folders, {} bytes: {:.2f} and {:.0f} a case\n", weight.entries, weight.bytes,
                           static_cast<double>(weight.entries) / static_cast<double>(cases.count()),
                           static_cast<double>(weight.bytes) / static_cast<double>(cases.count()));
  if (threads > 1) std::cout << fmt::format("gain {:.2f}\n", run(base, cases, folder, threads) / single);
  fs::remove_all(folder);
  return 0;
}

}  // namespace
}  // namespace overbend

int main(int count, char** args) {
  const int threads = count > 1 ? std::atoi(args[1]) : static_cast<int>(std::thread::hardware_concurrency());
  const int tensions = count > 2 ? std::atoi(args[2]) : 200;
  const std::filesystem::path folder =
      count > 3 ? std::filesystem::path(args[3]) : std::filesystem::temp_directory_path() / "overbend-throughput";
  return overbend::measure(threads, tensions, folder, count > 4 && std::string(args[4]) == "small");
}
