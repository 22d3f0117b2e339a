#include "study/campaign/study_runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <map>
#include <mutex>

#include "base/finding.h"
#include "base/interruption.h"
#include "base/ranges.h"
#include "base/threads.h"
#include "report/studies/study_page.h"
#include "resultfiles/studies/study_writer.h"
#include "runstore/claim_file.h"
#include "study/campaign/study_extremes.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using SteadyClock = std::chrono::steady_clock;

double seconds_since(SteadyClock::time_point then) {
  return std::chrono::duration<double>(SteadyClock::now() - then).count();
}

/// Statics of dynamic analyses: solved once for the seeds of one model, kept while one of them runs.
class SharedStatics {
 public:
  RunResult take(const CaseBase& base, const CaseInput& question, std::size_t group, CaseWarmStart& neighbour) {
    std::shared_ptr<Entry> entry;
    {
      const std::lock_guard<std::mutex> hold(mutex_);
      std::weak_ptr<Entry>& place = entries_[group];
      entry = place.lock();
      if (!entry) place = entry = std::make_shared<Entry>();
    }
    const std::lock_guard<std::mutex> hold(entry->mutex);
    if (entry->neighbour.prepared == nullptr) {
      if (RunResult end = prepare_warm_start(base, question, entry->neighbour); end.ending != RunStatus::done) {
        return end;
      }
    }
    // The entry lives as long as its statics are in use.
    neighbour.prepared = std::shared_ptr<const PreparedCase>(entry, entry->neighbour.prepared.get());
    neighbour.keys = entry->neighbour.keys;
    return {};
  }

 private:
  struct Entry {
    std::mutex mutex;
    CaseWarmStart neighbour;
  };
  std::mutex mutex_;
  std::map<std::size_t, std::weak_ptr<Entry>> entries_;
};

class StudyWork {
 public:
  StudyWork(const CaseBase& base, const StudyCases& cases, const fs::path& folder, const StudyRunOptions& options,
            StudyObserver& watch)
      : base_(base),
        cases_(cases),
        folder_(folder),
        options_(options),
        watch_(watch),
        worker_(folder / "workers"),
        outputs_(study_outputs(base)) {}

  StudyTally go() {
    list_open();
    list_blocks();
    watch_.begin(open_.size(), tally_.before);
    const InterruptionScope scope([this] { return watch_.abandon(); });
    try {
      if (!open_.empty() && is_static()) start_ = base_start(base_);
    } catch (const Interrupted&) {
      tally_.interrupted = true;
      return tally_;
    }
    work_in_threads(useful_threads(options_.threads, blocks_.size()), [this] { work(); });
    if (error_) std::rethrow_exception(error_);
    tally_.interrupted = handled_ < open_.size();
    return tally_;
  }

 private:
  bool is_open(std::size_t number) const {
    const StudyCaseState state = recorded_state(folder_, number);
    return state == StudyCaseState::open || (options_.retry_failed && state == StudyCaseState::failed);
  }

  void list_open() {
    for (std::size_t number = options_.task; number < cases_.count(); number += options_.tasks) {
      if (is_open(number)) {
        open_.push_back(number);
      } else {
        ++tally_.before;
      }
    }
  }

  bool is_static() const { return base_.study().analysis == StudyAnalysis::statics; }

  /// Divides the open cases into blocks for a thread: cases with one anchor; for other analyses than statics, single
  /// cases.
  void list_blocks() {
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const std::vector<std::size_t> anchors = is_static() ? cases_.anchors(open_[i]) : std::vector<std::size_t>();
      const std::optional<std::size_t> anchor = anchors.empty() ? std::nullopt : std::optional(anchors.front());
      if (!anchor || blocks_.empty() || blocks_.back().anchor != anchor) blocks_.push_back({anchor, {}});
      blocks_.back().cases.push_back(open_[i]);
    }
    for (Block& block : blocks_) {  // the anchor first: the others start from it
      std::stable_partition(block.cases.begin(), block.cases.end(),
                            [&](std::size_t number) { return number == block.anchor; });
    }
  }

  bool ends() { return stopped_ || watch_.stop(); }

  void work() {
    try {
      for (std::size_t i = next_++; i < blocks_.size() && !ends(); i = next_++) run(blocks_[i]);
    } catch (const Interrupted&) {
      stopped_ = true;
    } catch (...) {
      const std::lock_guard<std::mutex> hold(mutex_);
      if (!error_) error_ = std::current_exception();
      stopped_ = true;
    }
  }

  struct Block {
    std::optional<std::size_t> anchor;
    std::vector<std::size_t> cases;
  };

  void run(const Block& block) {
    std::shared_ptr<const LayWarmStart> anchor_start;
    for (const std::size_t number : block.cases) {
      if (ends()) return;
      CaseWarmStart neighbour;
      neighbour.start = start_;
      if (start_ && block.anchor && number != *block.anchor) {
        if (!anchor_start) anchor_start = start_at(*block.anchor);
        neighbour.start = anchor_start;
        if (anchor_start != start_) neighbour.fallback_start = start_;
      }
      if (run(number, neighbour) && number == block.anchor) anchor_start = neighbour.found ? neighbour.found : start_;
    }
  }

  /// Returns the equilibrium of an anchor; that of the base model if it has none.
  std::shared_ptr<const LayWarmStart> start_at(std::size_t anchor) const {
    CaseWarmStart neighbour;
    neighbour.start = start_;
    evaluate_case(base_, cases_.question(anchor), neighbour, {});
    return neighbour.found ? neighbour.found : start_;
  }

  /// Returns true if the case was solved by this process.
  bool run(std::size_t number, CaseWarmStart& neighbour) {
    const fs::path place = folder_ / case_folder(number), claim = place / "claim";
    std::error_code error;
    fs::create_directories(place, error);
    if (!worker_.claim(claim)) {
      count(&StudyTally::elsewhere);
      return false;
    }
    if (!is_open(number)) {  // another process has finished it since
      release_claims(claim);
      count(&StudyTally::before);
      return false;
    }
    StudyCase study_case = cases_.at(number);
    const CaseResult answer = solve(study_case, neighbour);
    const RunStatus ending = answer.ending;
    if (ending != RunStatus::interrupted) {
      write_case_record(study_case, cases_.inputs(), outputs_, folder_,
                        cases_.seeds() > 1 ? answer.peaks : std::vector<HistoryPeaks>());
    }
    release_claims(claim);
    if (ending == RunStatus::interrupted) {
      stopped_ = true;
      return false;
    }
    count(study_case.state == StudyCaseState::done ? &StudyTally::done : &StudyTally::failed);
    watch_.ended(study_case);
    return true;
  }

  CaseResult solve(StudyCase& study_case, CaseWarmStart& neighbour) {
    const SteadyClock::time_point begun = SteadyClock::now();
    const CaseInput question = cases_.question(study_case.number);
    const CaseEvaluationOptions conduct{folder_ / study_case.folder,
                                        base_.study().keep,
                                        options_.checkpoint_every,
                                        [this] { return ends(); },
                                        [this] { return stopped_ || watch_.abandon(); },
                                        [this](const DynamicProgress&, double) { watch_.advanced(); },
                                        &hdf5_lock()};
    CaseResult answer;
    if (base_.study().analysis == StudyAnalysis::dynamic) {
      static_cast<RunResult&>(answer) = statics_.take(base_, question, study_case.group, neighbour);
    }
    if (answer.ending == RunStatus::done) answer = evaluate_case(base_, question, neighbour, conduct);
    if (answer.ending == RunStatus::no_solution && is_static() && !conduct.keep) {
      answer = solve_from_neighbours(study_case.number, neighbour, std::move(answer));
    }
    store_result(answer, base_.study().analysis, outputs_, study_case);
    study_case.wall_time = seconds_since(begun);
    return answer;
  }

  /// Retries a case without a solution from its anchors, through all cases between. `failed` is its result so far.
  CaseResult solve_from_neighbours(std::size_t number, CaseWarmStart& neighbour, CaseResult failed) const {
    for (const std::size_t anchor : cases_.anchors(number)) {
      if (anchor == number) continue;
      neighbour.start = start_at(anchor);
      for (std::size_t current = anchor; current != number;) {
        if (watch_.stop()) return {{RunStatus::interrupted, "interrupted"}};
        current = current < number ? current + 1 : current - 1;
        CaseResult answer = evaluate_case(base_, cases_.question(current), neighbour, {});
        if (neighbour.found) neighbour.start = neighbour.found;
        if (current == number && answer.ending == RunStatus::done) return answer;
      }
    }
    return failed;
  }

  void count(std::size_t StudyTally::*which) {
    const std::lock_guard<std::mutex> hold(mutex_);
    ++(tally_.*which);
    ++handled_;
  }

  const CaseBase& base_;
  const StudyCases& cases_;
  const fs::path& folder_;
  const StudyRunOptions& options_;
  StudyObserver& watch_;
  WorkerFile worker_;
  std::vector<StudyOutput> outputs_;
  std::vector<std::size_t> open_;
  std::vector<Block> blocks_;
  std::shared_ptr<const LayWarmStart> start_;
  SharedStatics statics_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;  ///< Protects the following members.
  StudyTally tally_;
  std::size_t handled_ = 0;  ///< Number of open cases that this process has finished with.
  std::exception_ptr error_;
};

/// Reason that a case run alone and failed keeps its record.
const char* kept_record_message(RunStatus ending) {
  return ending == RunStatus::no_solution ? "; the study found a solution from other cases, and its record is kept"
                                          : "; the study has a result of this case, and its record is kept";
}

}  // namespace

void StudyObserver::begin(std::size_t /*open*/, std::size_t /*finished*/) {}
void StudyObserver::ended(const StudyCase& /*one*/) {}
void StudyObserver::advanced() {}
void StudyObserver::tried(const TrialReport& /*trial*/) {}

StudyTally run_study_cases(const CaseBase& base, const StudyCases& cases, const fs::path& folder,
                           const StudyRunOptions& options, StudyObserver& watch) {
  return StudyWork(base, cases, folder, options, watch).go();
}

StudyCase run_study_case(const CaseBase& base, const StudyCases& cases, const fs::path& folder, std::size_t number,
                         const std::function<bool()>& stop) {
  const SteadyClock::time_point begun = SteadyClock::now();
  StudyCase study_case = cases.at(number);
  const CaseEvaluationOptions conduct{folder / study_case.folder, true, 60.0, stop, {}, {}, &hdf5_lock()};
  CaseWarmStart neighbour;
  const CaseResult answer = evaluate_case(base, cases.question(number), neighbour, conduct);
  const std::vector<StudyOutput> outputs = study_outputs(base);
  store_result(answer, base.study().analysis, outputs, study_case);
  study_case.wall_time = seconds_since(begun);
  if (answer.ending == RunStatus::interrupted) {
    study_case.state = StudyCaseState::open;
    return study_case;
  }
  if (study_case.state == StudyCaseState::failed && recorded_state(folder, number) == StudyCaseState::done) {
    study_case.reason += kept_record_message(answer.ending);
    return study_case;
  }
  write_case_record(study_case, cases.inputs(), outputs, folder);
  return study_case;
}

namespace {

/// The serious findings of the cases, each once with the number of cases that have it.
void add_serious_findings(StudyResults& results) {
  constexpr std::size_t kShown = 10;
  std::vector<Findings> of_cases;
  for (const StudyCase& study_case : results.cases) {
    if (study_case.state == StudyCaseState::done) of_cases.push_back(serious_findings(study_case.findings));
  }
  std::vector<SharedFinding> shared = shared_findings(of_cases);
  ranges::stable_sort(shared, std::greater<>(), [](const SharedFinding& finding) { return finding.runs.size(); });
  for (const SharedFinding& group : shared) {
    Finding finding = group.worst;
    if (results.findings.size() >= kShown) {
      finding.message = fmt::format("{} more serious findings of cases are in their records, case.json",
                                    shared.size() - static_cast<std::size_t>(&group - shared.data()));
      results.findings.push_back(std::move(finding));
      break;
    }
    finding.message = fmt::format("{} of {} solved cases: {}", group.runs.size(), of_cases.size(), group.text());
    results.findings.push_back(std::move(finding));
  }
}

}  // namespace

StudyResults study_so_far(const fs::path& folder) {
  StudyResults results = read_study(folder);
  add_serious_findings(results);
  fill_extremes(results, recorded_duration(folder),
                [&](const StudyCase& study_case) { return recorded_peaks(folder, study_case); });
  return results;
}

StudyResults gather_study(const fs::path& folder) {
  StudyResults results = study_so_far(folder);
  write_study_files(results, folder);
  write_study_report(results, folder / "report.html");
  return results;
}

}  // namespace overbend
