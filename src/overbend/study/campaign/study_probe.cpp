#include "study/campaign/study_probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "platform/temporary.h"
#include "runstore/staged_folder.h"

namespace overbend {
namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr double kMaxProbeTime = 5.0;  ///< Maximum wall time of a dynamic analysis in the probe [s].

double seconds_since(SteadyClock::time_point then) {
  return std::chrono::duration<double>(SteadyClock::now() - then).count();
}

}  // namespace

StudyProbe probe_study(const CaseBase& base, const StudyCases& cases, const std::function<bool()>& stop) {
  StudyProbe probe;
  std::error_code error;
  const ScratchFolder folder(error);
  if (error) throw UnusableFolder("a temporary folder cannot be created: " + error.message());
  CaseWarmStart neighbour;
  SteadyClock::time_point begun = SteadyClock::now();
  if (base.study().analysis == StudyAnalysis::statics) neighbour.start = base_start(base);
  probe.before = seconds_since(begun);
  const std::size_t last = cases.count() - 1;
  double sum = 0.0;
  int solved = 0;
  for (const std::size_t number : std::set<std::size_t>{0, cases.count() / 2, last}) {
    if (stop()) break;
    begun = SteadyClock::now();
    CaseEvaluationOptions conduct;
    conduct.folder = folder.path() / case_folder(number);
    double done = 1.0;
    SteadyClock::time_point running = begun;
    double prepared = 0.0;
    conduct.progress = [&](const DynamicProgress& progress, double from) {
      if (prepared == 0.0) {
        prepared = seconds_since(begun);
        running = SteadyClock::now();
      }
      done = std::max(1e-3, (progress.time - from) / (progress.end - from));
    };
    conduct.stop = [&] { return stop() || (prepared > 0.0 && seconds_since(running) > kMaxProbeTime); };
    const CaseResult answer = evaluate_case(base, cases.question(number), neighbour, conduct);
    if (answer.ending != RunStatus::done && answer.ending != RunStatus::interrupted) {
      probe.failures.push_back(fmt::format("case {} has no solution: {}", number, answer.why));
      continue;
    }
    const double spent = seconds_since(begun);
    sum += answer.ending == RunStatus::done ? spent : prepared + (spent - prepared) / done;
    ++solved;
  }
  if (solved > 0) probe.seconds = sum / solved;
  return probe;
}

}  // namespace overbend
