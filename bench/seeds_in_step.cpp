// Work that seeds of one model would share if they were advanced side by side in vector lanes, one step for all.
//
//     overbend_seeds_in_step [MODEL] [SECONDS] [SEEDS]
//
// Defaults: examples/bgl1.yaml of the sources, 100 s, 8 seeds. Each seed is advanced by itself, with the steps it
// needs; then its steps are laid over those of the others, which would all have to take the smallest. Prints steps a
// seed alone and together: their ratio is what lanes have to make up for before they gain anything. Also how many of
// the steps alone are those in which impacts are resolved, about 1 ms long.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <numeric>
#include <string>

#include "dynamics/run/simulation.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/recovery/recovery.h"

namespace overbend {
namespace {

/// The instants that the steps of a run lead from and to, rising [s].
std::vector<double> find_instants(const Model& model, const StaticSolution& start, double tension,
                                  const DynamicOptions& options) {
  Simulation simulation(model, start, tension, options);
  std::vector<double> instants = {simulation.time()};
  while (!simulation.finished()) {
    if (!simulation.step()) {
      std::cerr << fmt::format("seed {} ends at {:.1f} s\n", options.seed, simulation.time());
      std::exit(1);
    }
    instants.push_back(simulation.time());
  }
  return instants;
}

/// Steps that all take if each is as long as the shortest that one of them takes there.
double steps_together(const std::vector<std::vector<double>>& seeds) {
  std::vector<double> all;
  for (const std::vector<double>& instants : seeds) all.insert(all.end(), instants.begin(), instants.end());
  std::sort(all.begin(), all.end());
  double steps = 0.0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (all[i] == all[i - 1]) continue;
    double min_step = all.back() - all.front();
    for (const std::vector<double>& instants : seeds) {
      const auto end = std::lower_bound(instants.begin() + 1, instants.end(), all[i]);
      if (end != instants.end()) min_step = std::min(min_step, *end - *(end - 1));
    }
    steps += (all[i] - all[i - 1]) / min_step;
  }
  return steps;
}

/// Steps shorter than any but those that follow an impact.
std::ptrdiff_t impact_steps(const std::vector<double>& instants) {
  constexpr double kShortStep = 1.5e-3;  // s
  std::vector<double> steps(instants.size());
  std::adjacent_difference(instants.begin(), instants.end(), steps.begin());
  return std::count_if(steps.begin() + 1, steps.end(), [](double step) { return step < kShortStep; });
}

int measure(const std::string& file, double duration, std::size_t seeds) {
  const ModelReading reading = read_model(file);
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) std::cerr << line << "\n";
  if (!reading.description) return 2;
  const Model model = build_model(*reading.description);
  const StaticSolution start = solve_statics(model).solution.value();
  const double tension = recover_statics(model, start).top_tension;
  DynamicOptions options = dynamic_options(model);
  options.duration = duration;
  std::vector<std::vector<double>> runs;
  double alone = 0.0, in_impacts = 0.0;
  for (std::size_t seed = 1; seed <= seeds; ++seed) {
    options.seed = seed;
    runs.push_back(find_instants(model, start, tension, options));
    alone += static_cast<double>(runs.back().size() - 1);
    in_impacts += static_cast<double>(impact_steps(runs.back()));
    const double together = steps_together(runs), mean = alone / static_cast<double>(seed);
    std::cout << fmt::format(
        "{} seeds: {:.0f} steps each alone, {:.0f} % of them in impacts, {:.0f} together, {:.2f} times\n", seed, mean,
        100.0 * in_impacts / alone, together, together / mean);
  }
  return 0;
}

}  // namespace
}  // namespace overbend

int main(int argc, char** argv) {
  const std::string file = argc > 1 ? argv[1] : std::string(OVERBEND_SOURCE_DIR) + "/examples/bgl1.yaml";
  return overbend::measure(file, argc > 2 ? std::atof(argv[2]) : 100.0,
                           argc > 3 ? static_cast<std::size_t>(std::atoi(argv[3])) : 8);
}
