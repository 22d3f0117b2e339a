#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>

#include "app/check_lines.h"
#include "app/commands.h"
#include "app/dynamic_seeds.h"
#include "app/finished_mark.h"
#include "app/interruption.h"
#include "app/prepared_case.h"
#include "app/progress.h"
#include "app/warning_lines.h"
#include "resultfiles/dynamic_reader.h"
#include "runstore/run_store.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

void number(const std::string& name, double value, const char* unit, int digits = 2) {
  std::cout << fmt::format("  {:<28}{:>12.{}f} {}\n", name, value, digits, unit);
}

void range(const std::string& name, const Spread& spread, double scale, const char* unit, int digits = 2) {
  if (std::isnan(spread.min)) {
    std::cout << fmt::format("  {:<28}{:>12}\n", name, "none");
    return;
  }
  std::cout << fmt::format("  {:<28}{:>12.{}f} to {:.{}f} {}\n", name, spread.min * scale, digits, spread.max * scale,
                           digits, unit);
}

void print_results(const StaticResults& statics, const DynamicResults& r) {
  std::cout << statics.title << "\n";
  range("top tension", r.top_tension, 1e-3, "kN");
  if (statics.overbend) number("overbend von Mises, largest", r.overbend.von_mises.over_time.max / 1e6, "MPa");
  if (statics.tower) number("tower von Mises, largest", r.tower.von_mises.over_time.max / 1e6, "MPa");
  number("sagbend von Mises, largest", r.sagbend.von_mises.over_time.max / 1e6, "MPa");
  number("smallest tension of all", r.smallest_tension.over_time.min / 1e3, "kN");
  if (statics.stinger_tip_clearance) range("stinger tip clearance", r.stinger_tip_clearance, 1.0, "m", 3);
  if (!r.supports.empty()) {
    std::cout << fmt::format("  {:<28}{:>12}", "impacts", r.impact_count);
    std::cout << (r.hardest_impacts.empty()
                      ? std::string("\n")
                      : fmt::format(", the hardest {:.1f} kN\n", r.hardest_impacts.front().peak_force / 1e3));
  }
  std::cout << check_lines(r.checks);
  std::cout << fmt::format("  {:<28}{:>12.1e} of the energy exchanged\n", "energy drift", r.energy.drift());
  std::cout << fmt::format("  {:<28}{:>12.2f} s, {} steps, {:.0f} times real time\n", "time loop", r.run.wall_time,
                           r.run.steps, r.run.real_time_ratio);
  std::cout << warning_lines(r.warnings);
}

int refuse(const std::string& why) {
  std::cerr << "overbend: " << why << "\n";
  return kWrongInput;
}

/// Follows the run: progress, checkpoints, interruption.
class Watch {
 public:
  Watch(const DynamicOptions& options, double checkpoint_every)
      : progress_(-options.build_up, options.duration), every_(checkpoint_every), last_(Clock::now()) {}

  DynamicControl operator()(const DynamicProgress& at) {
    progress_.show(at.time, fmt::format("t = {:.1f} s  tension {:.1f} kN", at.time, at.top_tension / 1e3));
    if (Interruption::wanted()) {
      return DynamicControl::stop;
    }
    if (std::chrono::duration<double>(Clock::now() - last_).count() < every_) {
      return DynamicControl::go_on;
    }
    last_ = Clock::now();
    return DynamicControl::checkpoint;
  }

 private:
  Progress progress_;
  double every_;
  Clock::time_point last_;
};

/// Where there is nothing left to run: says so and shows what it gave.
int tell_finished(const fs::path& folder, bool strict) {
  const StoredDynamics stored = read_dynamic_results(folder / "results.h5");
  std::cerr << fmt::format("The run in {} is finished after {:.6g} s. Without --resume it is run again.\n",
                           folder.string(), stored.results.duration);
  print_results(stored.statics.results, stored.results);
  std::cout << "Results are in " << folder.string() << "\n";
  return strict_code(stored.results.checks, strict);
}

/// One run straight into the folder.
int run_one(const DynamicCase& shared, const fs::path& folder, const DynamicArguments& arguments, bool resume) {
  if (!resume) unmark(folder);
  if (resume) {
    try {
      const fs::path results = folder / "results.h5";  // another command may have written it since
      if (is_finished(folder, shared.input) && fs::exists(results) && has_dynamic(results)) {
        return tell_finished(folder, arguments.strict);
      }
    } catch (const std::runtime_error& fault) {  // of another model, or results that somebody has taken away
      return refuse(fault.what());
    }
    const std::optional<StoredRun> stored = RunStore::find(folder);
    if (!stored) std::cerr << fmt::format("There is no unfinished run in {}: starting a new one.\n", folder.string());
    if (stored && stored->fault.empty()) std::cerr << fmt::format("Continuing from t = {:.1f} s.\n", stored->time);
  }
  const DynamicOptions options = dynamic_options(shared.model);
  std::mutex writing;
  RealisationEnd end;
  {
    const Interruption interruption;
    Watch watch(options, arguments.checkpoint_every);
    end = run_realisation(shared, folder, options.seed, resume, std::ref(watch), writing);
  }
  if (end.code != kDone) {
    std::cerr << "overbend: " << end.why << "\n";
    return end.code;
  }
  mark_finished(folder, shared.input);
  print_results(shared.statics, *end.results);
  std::cout << "Results are in " << folder.string() << "\n";
  return strict_code(end.results->checks, arguments.strict);
}

std::optional<std::string> twice(std::vector<std::uint64_t> seeds) {
  std::sort(seeds.begin(), seeds.end());
  const auto found = std::adjacent_find(seeds.begin(), seeds.end());
  if (found == seeds.end()) return std::nullopt;
  return fmt::format("analysis.dynamic.seeds: {} is given twice", *found);
}

int run_in(const fs::path& folder, const Description& description, const DynamicArguments& arguments) {
  std::vector<std::uint64_t> seeds;
  if (description.dynamics) seeds = description.dynamics->seeds;
  if (const std::optional<std::string> fault = twice(seeds)) return refuse(*fault);
  const std::vector<fs::path> folders = seeds.size() < 2 ? std::vector{folder} : seed_folders(folder, seeds);
  const std::optional<bool> resume = goes_on(folders, arguments.take_up);
  if (!resume) return kWrongInput;
  ExitCode code = kDone;
  const std::unique_ptr<PreparedCase> prepared = prepare_case(description, code);
  if (!prepared) return code;
  const DynamicCase shared = prepared->shared();
  if (seeds.size() < 2) return run_one(shared, folder, arguments, *resume);
  return run_seeds(shared, seeds, folder, {*resume, arguments.checkpoint_every, arguments.threads, arguments.strict});
}

}  // namespace

int run_dynamic(const DynamicArguments& arguments) {
  std::optional<Description> description = load_model(arguments.model_file);
  if (!description || !set_duration(*description, arguments.duration)) return kWrongInput;
  const fs::path folder = arguments.output.empty()
                              ? fs::path(fs::path(arguments.model_file).stem().string() + ".results")
                              : fs::path(arguments.output);
  return run_in(folder, *description, arguments);
}

}  // namespace overbend
