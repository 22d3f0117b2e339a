#include "app/dynamic_seeds.h"

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <map>

#include "app/check_lines.h"
#include "app/seeds_gather.h"
#include "app/warning_lines.h"
#include "report/warning_weight.h"
#include "resultfiles/dynamic_reader.h"
#include "resultfiles/seeds_writer.h"
#include "runstore/staged_folder.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

/// Keeps the table whose worst check is used more.
void keep_worse(CheckTable& worst, CheckTable&& other) {
  const CheckRow *a = worst_check(worst), *b = worst_check(other);
  if (b != nullptr && (a == nullptr || b->utilisation > a->utilisation)) worst = std::move(other);
}

SeedsResults gather(const DynamicCase& shared, const std::vector<SideRun>& seeds, CheckTable& worst) {
  SeedsResults results;
  results.build_up = shared.description.dynamics->build_up;
  results.quantities = seed_quantities(shared.statics);
  for (const SideRun& seed : seeds) {
    if (seed.end.code != kDone) {
      results.failed.push_back({seed.seed, seed.end.why});
      continue;
    }
    DynamicResults run = read_dynamic_results(seed.folder / "results.h5").results;
    results.duration = run.duration;
    results.runs.push_back(
        {seed.seed, seed.folder.filename().string(), seed_values(shared.statics, run), run.warnings});
    keep_worse(worst, std::move(run.checks));
  }
  fill_statistics(results);
  const WaveType type = shared.description.environment.waves.type;
  if (type == WaveType::none || type == WaveType::airy || type == WaveType::stokes5) {
    results.warnings.emplace_back("the sea is not random: all seeds give the same results");
  }
  return results;
}

void print(const SeedsResults& results) {
  std::cout << fmt::format("  {:<28}{:>12}{:>12}{:>12}{:>12}\n", "over the seeds", "mean", "std", "min", "max");
  for (std::size_t i = 0; i < results.statistics.size(); ++i) {
    const SeedQuantity& quantity = results.quantities[i];
    const SeedStatistics& s = results.statistics[i];
    if (std::isnan(s.mean)) continue;  // absent in every run
    const TableUnit unit = table_unit(quantity);
    std::cout << fmt::format("  {:<28}{:>12.4g}{:>12.3g}{:>12.4g}{:>12.4g} {}\n", quantity.name, s.mean * unit.factor,
                             s.std * unit.factor, s.min * unit.factor, s.max * unit.factor, unit.name);
  }
  std::map<std::string, int> warnings;
  for (const SeedRun& run : results.runs) {
    for (const std::string& warning : run.warnings) ++warnings[warning];
  }
  for (const auto& [warning, count] : warnings) {
    std::cout << fmt::format("  warning ({} of {} seeds): {}\n", count, results.runs.size(), without_mark(warning));
  }
  std::cout << warning_lines(results.warnings);
}

int end(const DynamicCase& shared, const std::vector<SideRun>& seeds, const fs::path& folder, bool strict) {
  if (all_wrong(seeds, folder)) return kWrongInput;
  CheckTable worst;
  const SeedsResults results = gather(shared, seeds, worst);
  for (const FailedSeed& failed : results.failed) {
    std::cerr << "overbend: seed " << failed.seed << ": " << failed.why << "\n";
  }
  if (!results.runs.empty()) {
    StagedFolder staged(folder);
    write_seeds_files(shared.statics, results, staged.path());
    std::vector<std::string> folders;
    for (const SideRun& seed : seeds) folders.push_back(seed.folder.filename().string());
    staged.commit("summary.json", folders);
    std::cout << fmt::format("{}\n  {:<28}{:>12} of {}\n", shared.statics.title, "seeds done", results.runs.size(),
                             seeds.size());
    print(results);
    std::cout << "Results are in " << folder.string() << "\n";
  }
  return results.failed.empty() ? strict_code(worst, strict) : kNoSolution;
}

}  // namespace

std::vector<fs::path> seed_folders(const fs::path& folder, const std::vector<std::uint64_t>& numbers) {
  std::vector<fs::path> folders;
  for (const std::uint64_t number : numbers) folders.push_back(folder / fmt::format("seed-{}", number));
  return folders;
}

int run_seeds(const DynamicCase& shared, const std::vector<std::uint64_t>& numbers, const fs::path& folder,
              const SideOptions& options) {
  const std::vector<fs::path> folders = seed_folders(folder, numbers);
  std::vector<SideRun> seeds;
  for (std::size_t i = 0; i < numbers.size(); ++i) seeds.push_back({&shared, numbers[i], folders[i]});
  const ExitCode code = run_side_by_side(seeds, options, "seeds");
  return code == kDone ? end(shared, seeds, folder, options.strict) : code;
}

}  // namespace overbend
