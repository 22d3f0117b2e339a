#include "app/dynamic_seeds.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <thread>

#include "app/interruption.h"
#include "app/progress.h"
#include "app/seeds_gather.h"
#include "base/version.h"
#include "io/dynamic_reader.h"
#include "io/results_writer.h"
#include "io/run_record.h"
#include "io/run_store.h"
#include "io/seeds_writer.h"
#include "io/staged_folder.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using SteadyClock = std::chrono::steady_clock;

// A seed that is done ---------------------------------------------------------------------------------------------

/// Says that the results beside it are whole, and of which input.
constexpr const char* kMark = ".finished";

std::string mark_text(const std::string& input) {
  return text_hash(input) + " " + kVersion + "\n";
}

void mark(const fs::path& folder, const std::string& input) {
  write_text(folder / ".finished.new", mark_text(input));
  fs::rename(folder / ".finished.new", folder / kMark);
}

std::optional<std::string> read_mark(const fs::path& folder) {
  std::ifstream stream(folder / kMark, std::ios::binary);
  if (!stream) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

// The seeds -------------------------------------------------------------------------------------------------------

struct Seed {
  std::uint64_t seed = 0;
  fs::path folder;
  bool ended = false;    ///< Well or not, in this sitting or one before.
  double begins = 0.0;   ///< Where it is taken up [s].
  RealisationEnd end{};  ///< Without the results: those are in its folder.
};

/// What an earlier sitting left of a seed. Throws std::runtime_error where that is of another input.
void look_back(Seed& seed, const std::string& input) {
  if (const std::optional<std::string> found = read_mark(seed.folder)) {
    if (*found != mark_text(input)) {
      throw std::runtime_error("'" + seed.folder.string() +
                               "' has results of another model file or version; start the run anew");
    }
    seed.ended = true;
    return;
  }
  if (const std::optional<ResumedRun> begun = RunStore::resume(seed.folder, input, seed.seed)) {
    seed.begins = begun->state.time;
  }
}

/// Progress of all seeds together, told by several threads.
class SeedsProgress {
 public:
  SeedsProgress(const std::vector<Seed>& seeds, double build_up, double duration)
      : at_(seeds.size()),
        whole_(build_up + duration),
        before_(build_up),
        progress_(0.0, whole_ * static_cast<double>(seeds.size())) {
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      at_[i] = seeds[i].ended ? whole_ : before_ + seeds[i].begins;
    }
  }

  void show(std::size_t index, double time) {
    const std::lock_guard<std::mutex> hold(mutex_);
    at_[index] = std::min(before_ + time, whole_);
    double sum = 0.0;
    for (const double at : at_) sum += at;
    const auto done = std::count_if(at_.begin(), at_.end(), [&](double at) { return at >= whole_; });
    progress_.show(sum, fmt::format("{} of {} seeds done", done, at_.size()));
  }

 private:
  std::mutex mutex_;
  std::vector<double> at_;
  double whole_, before_;
  Progress progress_;
};

/// The threads' common work.
class SeedsRun {
 public:
  SeedsRun(const DynamicCase& shared, const SeedsOptions& options, std::vector<Seed>& seeds)
      : shared_(shared),
        options_(options),
        seeds_(seeds),
        progress_(seeds, shared.description.dynamics->build_up, shared.description.dynamics->duration) {}

  void go() {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t wanted = options_.threads > 0 ? static_cast<std::size_t>(options_.threads) : cores;
    std::vector<std::thread> threads;
    for (std::size_t i = 1; i < std::min(wanted, seeds_.size()); ++i) threads.emplace_back([this] { work(); });
    work();
    for (std::thread& thread : threads) thread.join();
  }

 private:
  void work() {
    for (std::size_t i = next_++; i < seeds_.size() && !Interruption::wanted(); i = next_++) {
      if (seeds_[i].ended) continue;
      seeds_[i].end = run(i);
      seeds_[i].end.results.reset();
      seeds_[i].ended = seeds_[i].end.code != kInterrupted;
    }
  }

  RealisationEnd run(std::size_t index) {
    const Seed& seed = seeds_[index];
    SteadyClock::time_point last = SteadyClock::now();
    const auto control = [&](const DynamicProgress& at) {
      progress_.show(index, at.time);
      if (Interruption::wanted()) return DynamicControl::stop;
      if (std::chrono::duration<double>(SteadyClock::now() - last).count() < options_.checkpoint_every) {
        return DynamicControl::go_on;
      }
      last = SteadyClock::now();
      return DynamicControl::checkpoint;
    };
    try {
      std::error_code ignored;  // where that fails the run can not be stored either, which is told
      if (!options_.resume) fs::remove(seed.folder / kMark, ignored);
      RealisationEnd end = run_realisation(shared_, seed.folder, seed.seed, options_.resume, control, writing_);
      if (end.code == kDone) mark(seed.folder, shared_.input);
      return end;
    } catch (const std::exception& fault) {  // this one's disk or numbers; the others go on
      return {kInternalFault, fault.what(), std::nullopt};
    }
  }

  const DynamicCase& shared_;
  const SeedsOptions& options_;
  std::vector<Seed>& seeds_;
  std::atomic<std::size_t> next_{0};
  std::mutex writing_;
  SeedsProgress progress_;
};

// Together ----------------------------------------------------------------------------------------------------------

SeedsResults gather(const DynamicCase& shared, const std::vector<Seed>& seeds) {
  SeedsResults results;
  results.build_up = shared.description.dynamics->build_up;
  results.quantities = seed_quantities(shared.statics);
  for (const Seed& seed : seeds) {
    if (seed.end.code != kDone) {
      results.failed.push_back({seed.seed, seed.end.why});
      continue;
    }
    const DynamicResults run = read_dynamic_results(seed.folder / "results.h5").results;
    results.duration = run.duration;
    results.runs.push_back(
        {seed.seed, seed.folder.filename().string(), seed_values(shared.statics, run), run.warnings});
  }
  fill_statistics(results);
  const WaveType type = shared.description.environment.waves.type;
  if (type == WaveType::none || type == WaveType::airy || type == WaveType::stokes5) {
    results.warnings.emplace_back("the sea is not random: all seeds give the same");
  }
  return results;
}

void print(const SeedsResults& results) {
  std::cout << fmt::format("  {:<28}{:>12}{:>12}{:>12}{:>12}\n", "over the seeds", "mean", "std", "min", "max");
  for (std::size_t i = 0; i < results.statistics.size(); ++i) {
    const SeedQuantity& quantity = results.quantities[i];
    const SeedStatistics& s = results.statistics[i];
    const TableUnit unit = table_unit(quantity);
    std::cout << fmt::format("  {:<28}{:>12.4g}{:>12.3g}{:>12.4g}{:>12.4g} {}\n", quantity.name, s.mean * unit.factor,
                             s.std * unit.factor, s.min * unit.factor, s.max * unit.factor, unit.name);
  }
  std::map<std::string, int> warnings;
  for (const SeedRun& run : results.runs) {
    for (const std::string& warning : run.warnings) ++warnings[warning];
  }
  for (const auto& [warning, count] : warnings) {
    std::cout << fmt::format("  warning ({} of {} seeds): {}\n", count, results.runs.size(), warning);
  }
  for (const std::string& warning : results.warnings) std::cout << "  warning: " << warning << "\n";
}

int end(const DynamicCase& shared, const std::vector<Seed>& seeds, const fs::path& folder) {
  const SeedsResults results = gather(shared, seeds);
  const bool wrong = std::all_of(seeds.begin(), seeds.end(), [](const Seed& s) { return s.end.code == kWrongInput; });
  if (wrong) {
    std::cerr << "overbend: " << seeds.front().end.why << "\n";
    std::error_code ignored;
    if (fs::is_directory(folder, ignored)) fs::remove(folder, ignored);  // where nothing else is in it
    return kWrongInput;
  }
  for (const FailedSeed& failed : results.failed) {
    std::cerr << "overbend: seed " << failed.seed << ": " << failed.why << "\n";
  }
  if (!results.runs.empty()) {
    StagedFolder staged(folder);
    write_seeds_files(shared.statics, results, staged.path());
    staged.commit("summary.json");
    std::cout << fmt::format("{}\n  {:<28}{:>12} of {}\n", shared.statics.title, "seeds done", results.runs.size(),
                             seeds.size());
    print(results);
    std::cout << "Results are in " << folder.string() << "\n";
  }
  return results.failed.empty() ? kDone : kNoSolution;
}

}  // namespace

int run_seeds(const DynamicCase& shared, const std::vector<std::uint64_t>& numbers, const fs::path& folder,
              const SeedsOptions& options) {
  std::vector<Seed> seeds;
  for (const std::uint64_t number : numbers) {
    Seed seed;
    seed.seed = number;
    seed.folder = folder / fmt::format("seed-{}", number);
    seed.begins = -shared.description.dynamics->build_up;
    seeds.push_back(seed);
  }
  try {
    if (options.resume) {
      for (Seed& seed : seeds) look_back(seed, shared.input);
    }
  } catch (const std::runtime_error& fault) {
    std::cerr << "overbend: " << fault.what() << "\n";
    return kWrongInput;
  }
  {
    const Interruption interruption;
    SeedsRun(shared, options, seeds).go();
  }
  if (std::any_of(seeds.begin(), seeds.end(), [](const Seed& seed) { return !seed.ended; })) {
    std::cerr << "overbend: interrupted; the run goes on with --resume\n";
    return kInterrupted;
  }
  return end(shared, seeds, folder);
}

}  // namespace overbend
