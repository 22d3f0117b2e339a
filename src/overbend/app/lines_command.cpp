#include "app/lines_command.h"

#include <fmt/format.h>

#include <chrono>
#include <iostream>
#include <stdexcept>

#include "app/check_lines.h"
#include "app/exit_code.h"
#include "app/finding_lines.h"
#include "app/interruption.h"
#include "app/progress.h"
#include "base/finding.h"
#include "base/shown_unit.h"
#include "dynamics/setup/dynamic_obstacle.h"
#include "resultfiles/lines/lines_writer.h"
#include "runstore/append_file.h"
#include "runstore/staged_folder.h"
#include "study/run/case.h"
#include "study/run/lines_run.h"
#include "study/run/prepared_case.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

void print_line(const LineResult& line, bool moved) {
  std::cout << fmt::format("  {}: {}, {} elements, {} on the bed\n", line.name, shown(line.length, "m", 2),
                           line.elements, shown(line.on_bed, "m", 1));
  for (const auto& [name, end] : {std::pair{"first end", &line.first}, {"second end", &line.second}}) {
    std::cout << fmt::format("    {:<26}{:>12} {}", name, shown_number(end->tension, "N", 2), shown_name("N"));
    if (moved) {
      std::cout << fmt::format(", {} to {}", shown_number(end->in_time.min, "N", 2), shown(end->in_time.max, "N", 2));
    }
    std::cout << "\n";
  }
  if (!line.utilisation) return;
  std::cout << fmt::format("    {:<26}{:>12.3f}", "of the breaking load", *line.utilisation);
  if (moved) std::cout << fmt::format(" at rest, {:.3f} at most", line.utilisation_in_time.value_or(*line.utilisation));
  std::cout << "\n";
}

void print(const LinesResults& results) {
  std::cout << results.title << "\n";
  for (const LineResult& line : results.lines) print_line(line, results.moved);
  std::cout << check_lines(results.checks) << verdict_line(results.checks, results.findings)
            << finding_lines(results.findings);
}

int told_folder(const fs::path& folder) {
  std::cout << "Results are in " << folder.string() << "\n";
  return kDone;
}

/// Runs one seed in its folder, with progress; stops when interrupted.
LinesOutcome run_seed(const Model& model, std::uint64_t seed, const fs::path& folder, bool resume,
                      double checkpoint_every) {
  using Clock = std::chrono::steady_clock;
  DynamicOptions options = dynamic_options(model);
  options.seed = seed;
  Progress progress(-options.build_up, options.duration);
  Clock::time_point last = Clock::now();
  return run_lines_in(folder, model, options, resume, [&](const DynamicProgress& at) {
    progress.show(at.time, fmt::format("t = {:.1f} s  tension {}", at.time, shown(at.top_tension, "N", 1)));
    if (Interruption::wanted()) return DynamicControl::stop;
    if (std::chrono::duration<double>(Clock::now() - last).count() < checkpoint_every) return DynamicControl::go_on;
    last = Clock::now();
    return DynamicControl::checkpoint;
  });
}

/// Several seeds, one after the other: a folder each, and what they give together. When one goes on, those that were
/// done before are run again.
int run_seeds(const Model& model, const std::vector<std::uint64_t>& seeds, const fs::path& folder, bool resume,
              double checkpoint_every) {
  const LineSeeds all = run_line_seeds(model.description, seeds, [&](std::uint64_t seed, const std::string& name) {
    return run_seed(model, seed, folder / name, resume, checkpoint_every);
  });
  if (all.stopped) return tell({RunEnding::interrupted, ""});
  if (all.failure) return tell(failed_end(*all.failure, model.description));
  const SeedsResults& gathered = all.seeds;
  for (const FailedSeed& failed : gathered.failed) {
    std::cerr << "overbend: seed " << failed.seed << ": " << failed.why << "\n";
  }
  write_lines_seeds(all.last, gathered, folder);
  std::cout << all.last.title << "\n";
  for (std::size_t i = 0; i < gathered.quantities.size(); ++i) {
    std::cout << fmt::format("  {:<36}{:>10} to {} over {} seeds\n", gathered.quantities[i].name,
                             shown_number(gathered.statistics[i].min, "N", 2),
                             shown(gathered.statistics[i].max, "N", 2), gathered.runs.size());
  }
  std::vector<Findings> findings;
  for (const SeedRun& run : gathered.runs) findings.push_back(run.findings);
  std::cout << shared_finding_lines(findings, "seeds");
  told_folder(folder);
  return gathered.failed.empty() ? kDone : kNoSolution;
}

}  // namespace

int run_static_lines(const Description& description, const fs::path& folder) {
  const LinesOutcome outcome = solve_lines(build_model(description));
  if (outcome.failure) return tell(failed_end(*outcome.failure, description));
  try {
    write_lines_run(*outcome.results, description, folder);
  } catch (const UnusableFolder& fault) {  // a folder that cannot be is the user's to mend
    return tell({RunEnding::wrong_input, fault.what()});
  }
  print(*outcome.results);
  return told_folder(folder);
}

int run_dynamic_lines(const Description& described, std::optional<double> duration, const fs::path& folder,
                      const TakeUp& take_up, double checkpoint_every) {
  Description description = described;
  set_duration(description, duration);
  if (!description.dynamics) return tell(failed_end(without_dynamics(), description));
  const Model model = build_model(description);
  const std::vector<std::uint64_t>& seeds = description.dynamics->seeds;
  std::vector<fs::path> folders = {folder};
  if (seeds.size() > 1) {
    folders.clear();
    for (const std::uint64_t seed : seeds) folders.push_back(folder / ("seed-" + std::to_string(seed)));
  }
  const std::optional<bool> resume = goes_on(folders, take_up);
  if (!resume) return kWrongInput;
  const Interruption interruption;
  try {
    if (seeds.size() > 1) return run_seeds(model, seeds, folder, *resume, checkpoint_every);
    const LinesOutcome outcome = run_seed(model, dynamic_options(model).seed, folder, *resume, checkpoint_every);
    if (outcome.stopped) return tell({RunEnding::interrupted, ""});
    if (outcome.failure) return tell(failed_end(*outcome.failure, description));
    print(*outcome.results);
    return told_folder(folder);
  } catch (const std::invalid_argument& fault) {  // a sea or a motion that cannot be made
    return tell({RunEnding::wrong_input, fault.what()});
  } catch (const FileFault&) {
    throw;                                     // no fault of the input
  } catch (const std::runtime_error& fault) {  // a folder that cannot be, or a run of something else in it
    return tell({RunEnding::wrong_input, fault.what()});
  }
}

}  // namespace overbend
