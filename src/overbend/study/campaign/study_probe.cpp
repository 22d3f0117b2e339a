#include "study/campaign/study_probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "runstore/staged_folder.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using SteadyClock = std::chrono::steady_clock;

constexpr double kLongest = 5.0;  ///< Of a dynamic analysis in the probe [s].

double seconds_since(SteadyClock::time_point then) {
  return std::chrono::duration<double>(SteadyClock::now() - then).count();
}

/// A folder that goes with its owner.
class PassingFolder {
 public:
  PassingFolder() {
    std::string pattern = (fs::temp_directory_path() / "overbend-probe-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw UnusableFolder("no temporary folder can be made: " + pattern);
    path_ = pattern;
  }
  ~PassingFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

StudyProbe probe_study(const CaseBase& base, const StudyCases& cases, const std::function<bool()>& stop) {
  StudyProbe probe;
  const PassingFolder folder;
  CaseNeighbour neighbour;
  SteadyClock::time_point begun = SteadyClock::now();
  if (base.study().analysis == StudyAnalysis::statics) neighbour.start = base_start(base);
  probe.before = seconds_since(begun);
  const std::size_t last = cases.count() - 1;
  double sum = 0.0;
  int solved = 0;
  for (const std::size_t number : std::set<std::size_t>{0, cases.count() / 2, last}) {
    if (stop()) break;
    begun = SteadyClock::now();
    CaseConduct conduct;
    conduct.folder = folder.path() / case_folder(number);
    double done = 1.0;
    SteadyClock::time_point running = begun;
    double prepared = 0.0;
    conduct.progress = [&](const DynamicProgress& at, double from) {
      if (prepared == 0.0) {
        prepared = seconds_since(begun);
        running = SteadyClock::now();
      }
      done = std::max(1e-3, (at.time - from) / (at.end - from));
    };
    conduct.stop = [&] { return stop() || (prepared > 0.0 && seconds_since(running) > kLongest); };
    const CaseAnswer answer = evaluate_case(base, cases.question(number), neighbour, conduct);
    if (answer.ending != RunEnding::done && answer.ending != RunEnding::interrupted) {
      probe.failures.push_back(fmt::format("case {} has no solution: {}", number, answer.why));
      continue;
    }
    const double spent = seconds_since(begun);
    sum += answer.ending == RunEnding::done ? spent : prepared + (spent - prepared) / done;
    ++solved;
  }
  if (solved > 0) probe.seconds = sum / solved;
  return probe;
}

}  // namespace overbend
