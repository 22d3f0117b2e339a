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

/// Statics of dynamic analyses: solved once for the seeds of one model, kept as long as one of them is at work.
class SharedStatics {
 public:
  RunEnd take(const CaseBase& base, const CaseQuestion& question, std::size_t group, CaseNeighbour& neighbour) {
    std::shared_ptr<Entry> entry;
    {
      const std::lock_guard<std::mutex> hold(mutex_);
      std::weak_ptr<Entry>& place = entries_[group];
      entry = place.lock();
      if (!entry) place = entry = std::make_shared<Entry>();
    }
    const std::lock_guard<std::mutex> hold(entry->mutex);
    if (entry->neighbour.prepared == nullptr) {
      if (RunEnd end = prepare_neighbour(base, question, entry->neighbour); end.ending != RunEnding::done) return end;
    }
    // The entry lives as long as its statics are at work.
    neighbour.prepared = std::shared_ptr<const PreparedCase>(entry, entry->neighbour.prepared.get());
    neighbour.keys = entry->neighbour.keys;
    return {};
  }

 private:
  struct Entry {
    std::mutex mutex;
    CaseNeighbour neighbour;
  };
  std::mutex mutex_;
  std::map<std::size_t, std::weak_ptr<Entry>> entries_;
};

class StudyWork {
 public:
  StudyWork(const CaseBase& base, const StudyCases& cases, const fs::path& folder, const StudyRunOptions& options,
            StudyWatch& watch)
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
    const InterruptionScope scope([this] { return watch_.stop(); });
    try {
      if (!open_.empty() && is_static()) start_ = base_start(base_);
    } catch (const Interrupted&) {
      tally_.interrupted = true;
      return tally_;
    }
    work_in_threads(useful_threads(options_.threads, blocks_.size()), [this] { work(); });
    if (fault_) std::rethrow_exception(fault_);
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

  /// What a thread takes at once: open cases with one anchor; of other analyses than statics, each by itself.
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
      if (!fault_) fault_ = std::current_exception();
      stopped_ = true;
    }
  }

  struct Block {
    std::optional<std::size_t> anchor;
    std::vector<std::size_t> cases;
  };

  void run(const Block& block) {
    std::shared_ptr<const LayStart> beside;
    for (const std::size_t number : block.cases) {
      if (ends()) return;
      CaseNeighbour neighbour;
      neighbour.start = start_;
      if (start_ && block.anchor && number != *block.anchor) {
        if (!beside) beside = start_at(*block.anchor);
        neighbour.start = beside;
        if (beside != start_) neighbour.other = start_;
      }
      if (run(number, neighbour) && number == block.anchor) beside = neighbour.found ? neighbour.found : start_;
    }
  }

  /// The equilibrium of an anchor; that of the base where it has none.
  std::shared_ptr<const LayStart> start_at(std::size_t anchor) const {
    CaseNeighbour neighbour;
    neighbour.start = start_;
    evaluate_case(base_, cases_.question(anchor), neighbour, {});
    return neighbour.found ? neighbour.found : start_;
  }

  /// Whether it was solved here.
  bool run(std::size_t number, CaseNeighbour& neighbour) {
    const fs::path place = folder_ / case_folder(number), claim = place / "claim";
    std::error_code fault;
    fs::create_directories(place, fault);
    if (!worker_.claim(claim)) {
      count(&StudyTally::elsewhere);
      return false;
    }
    if (!is_open(number)) {  // another process has finished it since
      release_claims(claim);
      count(&StudyTally::before);
      return false;
    }
    StudyCase one = cases_.at(number);
    const CaseAnswer answer = solve(one, neighbour);
    const RunEnding ending = answer.ending;
    if (ending != RunEnding::interrupted) {
      write_case_record(one, cases_.inputs(), outputs_, folder_,
                        cases_.seeds() > 1 ? answer.peaks : std::vector<HistoryPeaks>());
    }
    release_claims(claim);
    if (ending == RunEnding::interrupted) {
      stopped_ = true;
      return false;
    }
    count(one.state == StudyCaseState::done ? &StudyTally::done : &StudyTally::failed);
    watch_.ended(one);
    return true;
  }

  CaseAnswer solve(StudyCase& one, CaseNeighbour& neighbour) {
    const SteadyClock::time_point begun = SteadyClock::now();
    const CaseQuestion question = cases_.question(one.number);
    const CaseConduct conduct{
        folder_ / one.folder, base_.study().keep, options_.checkpoint_every, [this] { return ends(); }, {},
        &hdf5_lock()};
    CaseAnswer answer;
    if (base_.study().analysis == StudyAnalysis::dynamic) {
      static_cast<RunEnd&>(answer) = statics_.take(base_, question, one.group, neighbour);
    }
    if (answer.ending == RunEnding::done) answer = evaluate_case(base_, question, neighbour, conduct);
    if (answer.ending == RunEnding::no_solution && is_static() && !conduct.keep) {
      answer = by_a_neighbour(one.number, neighbour, std::move(answer));
    }
    take_answer(answer, base_.study().analysis, outputs_, one);
    one.wall_time = seconds_since(begun);
    return answer;
  }

  /// Another way to a case without a solution: from the anchors around it through all cases between. `failed` is its
  /// answer so far.
  CaseAnswer by_a_neighbour(std::size_t number, CaseNeighbour& neighbour, CaseAnswer failed) const {
    for (const std::size_t anchor : cases_.anchors(number)) {
      if (anchor == number) continue;
      neighbour.start = start_at(anchor);
      for (std::size_t at = anchor; at != number;) {
        if (watch_.stop()) return {{RunEnding::interrupted, "interrupted"}};
        at = at < number ? at + 1 : at - 1;
        CaseAnswer answer = evaluate_case(base_, cases_.question(at), neighbour, {});
        if (neighbour.found) neighbour.start = neighbour.found;
        if (at == number && answer.ending == RunEnding::done) return answer;
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
  StudyWatch& watch_;
  WorkerFile worker_;
  std::vector<StudyOutput> outputs_;
  std::vector<std::size_t> open_;
  std::vector<Block> blocks_;
  std::shared_ptr<const LayStart> start_;
  SharedStatics statics_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;  ///< Of what follows.
  StudyTally tally_;
  std::size_t handled_ = 0;  ///< Of the open cases, those that this process need not look at again.
  std::exception_ptr fault_;
};

/// Why a case that has failed alone leaves its record as it is.
const char* kept_words(RunEnding ending) {
  return ending == RunEnding::no_solution ? "; the study found a solution from the cases around, and its record is kept"
                                          : "; the study has a result of this case, and its record is kept";
}

}  // namespace

void StudyWatch::begin(std::size_t /*open*/, std::size_t /*finished*/) {}
void StudyWatch::ended(const StudyCase& /*one*/) {}
void StudyWatch::tried(const TrialTold& /*trial*/) {}

StudyTally run_study_cases(const CaseBase& base, const StudyCases& cases, const fs::path& folder,
                           const StudyRunOptions& options, StudyWatch& watch) {
  return StudyWork(base, cases, folder, options, watch).go();
}

StudyCase run_study_case(const CaseBase& base, const StudyCases& cases, const fs::path& folder, std::size_t number,
                         const std::function<bool()>& stop) {
  const SteadyClock::time_point begun = SteadyClock::now();
  StudyCase one = cases.at(number);
  const CaseConduct conduct{folder / one.folder, true, 60.0, stop, {}, &hdf5_lock()};
  CaseNeighbour neighbour;
  const CaseAnswer answer = evaluate_case(base, cases.question(number), neighbour, conduct);
  const std::vector<StudyOutput> outputs = study_outputs(base);
  take_answer(answer, base.study().analysis, outputs, one);
  one.wall_time = seconds_since(begun);
  if (answer.ending == RunEnding::interrupted) {
    one.state = StudyCaseState::open;
    return one;
  }
  if (one.state == StudyCaseState::failed && recorded_state(folder, number) == StudyCaseState::done) {
    one.reason += kept_words(answer.ending);
    return one;
  }
  write_case_record(one, cases.inputs(), outputs, folder);
  return one;
}

namespace {

/// The serious findings of the cases, each once with the number of cases that have it.
void add_serious_findings(StudyResults& results) {
  constexpr std::size_t kShown = 10;
  std::vector<Findings> of_cases;
  for (const StudyCase& one : results.cases) {
    if (one.state == StudyCaseState::done) of_cases.push_back(serious_findings(one.findings));
  }
  std::vector<SharedFinding> shared = shared_findings(of_cases);
  std::ranges::stable_sort(shared, std::greater<>(), [](const SharedFinding& one) { return one.runs.size(); });
  for (const SharedFinding& one : shared) {
    Finding finding = one.worst;
    if (results.findings.size() >= kShown) {
      finding.message = fmt::format("{} more serious findings of cases are in their records, case.json",
                                    shared.size() - static_cast<std::size_t>(&one - shared.data()));
      results.findings.push_back(std::move(finding));
      break;
    }
    finding.message = fmt::format("{} of {} solved cases: {}", one.runs.size(), of_cases.size(), one.text());
    results.findings.push_back(std::move(finding));
  }
}

}  // namespace

StudyResults study_so_far(const fs::path& folder) {
  StudyResults results = read_study(folder);
  add_serious_findings(results);
  fill_extremes(results, recorded_duration(folder), [&](const StudyCase& one) { return recorded_peaks(folder, one); });
  return results;
}

StudyResults gather_study(const fs::path& folder) {
  StudyResults results = study_so_far(folder);
  write_study_files(results, folder);
  write_study_report(results, folder / "report.html");
  return results;
}

}  // namespace overbend
