#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <iostream>
#include <iterator>

#include "analysis/dynamics.h"
#include "analysis/recovery.h"
#include "app/commands.h"
#include "app/dynamic_finish.h"
#include "app/exit_code.h"
#include "app/interruption.h"
#include "app/progress.h"
#include "base/units.h"
#include "io/dynamic_writer.h"
#include "io/run_store.h"
#include "io/staged_folder.h"
#include "report/report.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

void number(const std::string& name, double value, const char* unit, int digits = 2) {
  std::cout << fmt::format("  {:<28}{:>12.{}f} {}\n", name, value, digits, unit);
}

void range(const std::string& name, const Spread& spread, double scale, const char* unit, int digits = 2) {
  std::cout << fmt::format("  {:<28}{:>12.{}f} to {:.{}f} {}\n", name, spread.min * scale, digits, spread.max * scale,
                           digits, unit);
}

void print_results(const StaticResults& statics, const DynamicResults& r) {
  std::cout << statics.title << "\n";
  range("top tension", r.top_tension, 1e-3, "kN");
  if (statics.overbend) number("overbend von Mises, largest", r.overbend.von_mises.over_time.max / 1e6, "MPa");
  number("sagbend von Mises, largest", r.sagbend.von_mises.over_time.max / 1e6, "MPa");
  if (statics.stinger_tip_clearance) range("stinger tip clearance", r.stinger_tip_clearance, 1.0, "m", 3);
  if (!r.supports.empty()) {
    std::cout << fmt::format("  {:<28}{:>12}", "impacts", r.impact_count);
    std::cout << (r.hardest_impacts.empty()
                      ? std::string("\n")
                      : fmt::format(", the hardest {:.1f} kN\n", r.hardest_impacts.front().peak_force / 1e3));
  }
  std::cout << fmt::format("  {:<28}{:>12.1e} of what passed\n", "energy drift", r.energy.drift());
  std::cout << fmt::format("  {:<28}{:>12.2f} s, {} steps, {:.0f} times real time\n", "time loop", r.run.wall_time,
                           r.run.steps, r.run.real_time_ratio);
  for (const std::string& warning : r.warnings) std::cout << "  warning: " << warning << "\n";
}

int tell(const StaticFailure& failure, int code) {
  const std::string where = failure.where.empty() ? "" : " (" + failure.where + ")";
  std::cerr << "overbend: " << (code == kNoSolution ? "no solution: " : "") << failure.what << where << ": "
            << failure.why << "\n";
  return code;
}

int refuse(const std::string& why) {
  std::cerr << "overbend: " << why << "\n";
  return kWrongInput;
}

std::string file_text(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// All that a run depends on: a run is taken up again with the same alone.
std::string input_text(const Description& d) {
  std::string text = d.source_text;
  for (const std::string& file : {d.vessel.motion_file, d.environment.waves.spectrum_file}) {
    if (!file.empty()) {
      text += "\n# " + file + "\n" + file_text(file);
    }
  }
  return text + fmt::format("\n# duration {:a}\n", d.dynamics->duration);
}

/// Where the run's data go, and the state to go on from.
struct Begun {
  std::optional<RunStore> store;
  std::optional<DynamicCheckpoint> state;
};

Begun begin(const fs::path& folder, const Description& description, std::uint64_t seed, bool resume) {
  const std::string text = input_text(description);
  if (resume) {
    if (std::optional<ResumedRun> resumed = RunStore::resume(folder, text, seed)) {
      std::cerr << fmt::format("Goes on from t = {:.1f} s.\n", resumed->state.time);
      return {std::move(resumed->store), std::move(resumed->state)};
    }
    std::cerr << "There is no unfinished run in " << folder.string() << ": begins anew.\n";
  }
  return {RunStore::create(folder, text, seed), std::nullopt};
}

void write_results(const StaticResults& statics, const DynamicResults& results, const RunStore& store,
                   const Description& description, const fs::path& folder) {
  StagedFolder staged(folder);
  write_dynamic_files(statics, results, store, description, staged.path());
  write_report(statics, results, description.source_text, staged.path() / "report.html");
  staged.commit("summary.json");
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

std::optional<Description> read(const DynamicArguments& arguments) {
  std::optional<Description> description = load_model(arguments.model_file);
  if (!description || arguments.duration.empty()) return description;
  const QuantityReading duration = parse_quantity(arguments.duration, "s");
  if (!duration.value || !(*duration.value > 0.0)) {
    std::cerr << "overbend: --duration: found " << duration.found << ", expected a time such as '600 s'\n";
    return std::nullopt;
  }
  if (!description->dynamics) description->dynamics.emplace();
  description->dynamics->duration = *duration.value;
  return description;
}

int run_in(const fs::path& folder, const Description& description, const DynamicArguments& arguments) {
  const Model model = build_model(description);
  if (const std::optional<StaticFailure> obstacle = dynamic_obstacle(model)) return tell(*obstacle, kWrongInput);
  const StaticOutcome start = solve_statics(model);
  if (start.failure) return tell(*start.failure, kNoSolution);
  const StaticResults statics = recover_statics(model, *start.solution);
  const DynamicOptions options = dynamic_options(model);
  Begun begun;
  try {
    begun = begin(folder, description, options.seed, arguments.resume);
  } catch (const std::runtime_error& fault) {
    return refuse(fault.what());
  }
  DynamicOutcome outcome;
  {
    const Interruption interruption;
    Watch watch(options, arguments.checkpoint_every);
    try {
      outcome =
          run_dynamics(model, *start.solution, statics, options, *begun.store, begun.state ? &*begun.state : nullptr,
                       [&](const DynamicProgress& at) { return watch(at); });
    } catch (const std::invalid_argument& fault) {  // a sea or a motion that can not be made
      begun.store->remove();
      return refuse(fault.what());
    }
  }
  if (outcome.stopped) {
    std::cerr << "overbend: interrupted; the run goes on with --resume\n";
    return kInterrupted;
  }
  if (outcome.failure) {
    begun.store->remove();
    return tell(*outcome.failure, kNoSolution);
  }
  finish_histories(*outcome.results, *begun.store);
  write_results(statics, *outcome.results, *begun.store, description, folder);
  begun.store->remove();
  print_results(statics, *outcome.results);
  std::cout << "Results are in " << folder.string() << "\n";
  return kDone;
}

}  // namespace

int run_dynamic(const DynamicArguments& arguments) {
  const std::optional<Description> description = read(arguments);
  if (!description) return kWrongInput;
  const fs::path folder = arguments.output.empty()
                              ? fs::path(fs::path(arguments.model_file).stem().string() + ".results")
                              : fs::path(arguments.output);
  return run_in(folder, *description, arguments);
}

}  // namespace overbend
